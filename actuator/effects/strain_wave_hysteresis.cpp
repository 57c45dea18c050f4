// SPDX-License-Identifier: Apache-2.0
// The flexspline of a strain-wave gear rubs in its teeth and its bearing while it winds up: torque
// over twist is a loop, the same at every speed. A differential equation in the twist for it:
// Dhaouadi, Ghorbel and Gandhi, "A new dynamic model of hysteresis in harmonic drives", IEEE
// Transactions on Industrial Electronics 50(6), 2003. The torque here leaves each turning point as
// steeply as it began, which Dahl's friction does not: equations (1) to (4) of
// docs/derivations/strain_wave_hysteresis.md.
#include <cmath>
#include <limits>

#include "actuator/effects/every_effect.hpp"

namespace torquewright::actuator::effects {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr double kLeastTurn_rad = 1e-9;

constexpr Parameter kParameters[] = {
    {"amplitude_Nm", 0.0, kInfinity, 0.0,
     "Half the width of a wide loop in torque, at the output."},
    {"turn_rad", kLeastTurn_rad, kInfinity, 1.0,
     "Twist over which it turns from one side of the loop to the other, by a factor of e.", true},
};

/// Z (6 u - u^3) / 5, eq. (2).
double law(const Effect& effect, const Instant& at) {
  const double u = at.state;
  return effect.values[0] * u * (6.0 - u * u) / 5.0;
}

/// du/dt = (dx/dt - |dx/dt| u) / s, eq. (1).
double state_rate(const Effect& effect, const Instant& at) {
  const double rate_rad_s = at.twist_rate_rad_s;
  return (rate_rad_s - std::abs(rate_rad_s) * at.state) / effect.values[1];
}

/// (6 - 3 u^2)(1 - u) / 5 has its maximum, 1.579, at u = -0.549.
constexpr double kSteepest = 1.579;

double stiffness_Nm_rad(const Effect& effect) {
  return kSteepest * effect.values[0] / effect.values[1];
}

constexpr Excitation kWindUp = {
    35,
    "the load's torque raised and lowered slowly in both directions, to several heights, with an "
    "encoder on either side of the gear"};

/// A twentieth of the greatest torque, by the twist of a stiff gear and of a soft one.
std::vector<std::vector<double>> starts(const Ranges& ranges) {
  std::vector<std::vector<double>> all;
  for (const double turn_rad : {1e-4, 1e-3, 1e-2})
    all.push_back({0.05 * ranges.torque_Nm, turn_rad});
  return all;
}

/// The whole width of the loop is what the train carries or not by its past.
double misjudged_Nm(const Effect& effect, const MotionExtremes& /*motion*/) {
  return effect.values[0];
}

}  // namespace

const EffectKind strain_wave_hysteresis = {
    .name = "strain_wave_hysteresis",
    .acts = Acts::kDynamics,
    .sentence =
        "The flexspline of a strain-wave gear rubs as it winds up: beside the spring of a "
        "torsional_compliance, a torque that lags behind the twist, at every speed alike.",
    .parameters = kParameters,
    .has_harmonics = false,
    .law = law,
    .state_rate = state_rate,
    .state = "place on the loop, from -1 to 1",
    .in_train = TrainPart::kHysteresis,
    .stiffness_Nm_rad = stiffness_Nm_rad,
    .excited_by = kWindUp,
    .starts = starts,
    .misjudged_Nm = misjudged_Nm,
};

}  // namespace torquewright::actuator::effects
