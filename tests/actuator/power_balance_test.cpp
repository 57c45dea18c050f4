// SPDX-License-Identifier: Apache-2.0
// Oracle: conservation of energy, at every point of every region. What the bus delivers is copper
// loss, the bridge's loss, friction (drag, iron loss being part of it, and the mesh), what periodic
// torque stores at its worst angle, and the power at the load; all but the first and the last
// worked out here from currents and speeds.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "actuator/mor/mor_table.hpp"
#include "actuator/motor/actuator_spec.hpp"
#include "actuator/motor/convention.hpp"
#include "tests/actuator/example_actuator.hpp"
#include "tests/actuator/random_actuator.hpp"

namespace torquewright::actuator {
namespace {

constexpr double kRounding = 1e-9;  // of the powers that are added up

class Balance {
 public:
  Balance(const Actuator& actuator, const OperatingConditions& conditions)
      : actuator_(actuator),
        temperature_K_(winding_temperature_K(actuator, conditions)),
        joint_(actuator, conditions),
        motor_(actuator, conditions, Side::kMotor) {}

  void check_every_row() {
    for (const MorRow& row : mor_table(joint_).rows) {
      if (row.range.is_empty) continue;
      check_bound(row.speed_rad_s, row.range.greatest, true);
      check_bound(row.speed_rad_s, row.range.least, false);
    }
  }
  int points() const { return points_; }

 private:
  const PhaseModel& model() const { return joint_.model(); }
  double ratio() const { return actuator_.transmission.ratio; }

  /// Torque at the rotor, from the current; with field weakening, which splits the current, from
  /// the rotor's own region.
  double rotor_torque_Nm(double speed_rad_s, const JointBound& bound, double amplitude_A,
                         bool is_upper) const {
    const bool has_d = model().field_weakening || model().inductance_d_H != model().inductance_q_H;
    if (!has_d) {
      return torque_Nm(model(), {0.0, std::copysign(amplitude_A, bound.current_A)});
    }
    const JointRange range = motor_.at(ratio() * speed_rad_s);
    return is_upper == (ratio() > 0.0) ? range.greatest.torque_Nm : range.least.torque_Nm;
  }

  /// Friction's law summed up, and its factors: signed, against the motion.
  double drag_Nm(double speed_rad_s) const {
    Instant at;
    at.speed_rad_s = speed_rad_s;
    at.direction = std::copysign(1.0, speed_rad_s);
    at.winding_temperature_K = temperature_K_;
    at.reference_temperature_K = actuator_.motor.winding_temperature_K;
    double drag_Nm = 0.0;
    for (const Effect& effect : actuator_.effects) {
      if (effect.kind->acts == Acts::kDrag) drag_Nm += effect.kind->law(effect, at);
    }
    return drag_Nm;
  }

  /// Amplitude of the one harmonic, if any.
  double amplitude_of(Acts acts) const {
    for (const Effect& effect : actuator_.effects) {
      if (effect.kind->acts == acts) return effect.harmonics.at(0).amplitude;
    }
    return 0.0;
  }

  double load_coefficient(bool is_driving) const {
    double k = 0.0;
    for (const Effect& effect : actuator_.effects) {
      if (effect.kind->acts == Acts::kLoadFriction) k += effect.values[is_driving ? 0 : 1];
    }
    return k;
  }

  void check_bound(double speed_rad_s, const JointBound& bound, bool is_upper) {
    ++points_;
    const double amplitude_A = std::abs(bound.current_A) *
                               phase_amperes_per_ampere(actuator_.motor.torque_constant_convention);
    const double rotor_Nm = rotor_torque_Nm(speed_rad_s, bound, amplitude_A, is_upper);
    const double copper_W = 1.5 * model().resistance_ohm * amplitude_A * amplitude_A;
    const double bridge_W = 1.5 * model().dead_time_V * amplitude_A;
    const double shaft_W = rotor_Nm * ratio() * speed_rad_s;
    const double scale_W = copper_W + bridge_W + std::abs(shaft_W) + 1e-6;
    // Reluctance gives the shaft what it takes; of the q current the back-EMF takes 3/2 K_e.
    const bool is_round = model().inductance_d_H == model().inductance_q_H;
    if (is_round) {
      const double q_A = q_current_A(model(), rotor_Nm, 0.0);
      const double between_W =
          (1.5 * model().back_emf_V_s_rad * q_A - rotor_Nm) * ratio() * speed_rad_s;
      EXPECT_NEAR(bound.bus_power_W, copper_W + bridge_W + shaft_W + between_W,
                  kRounding * (scale_W + std::abs(between_W)))
          << actuator_.name << " at " << speed_rad_s;
    }
    if (speed_rad_s == 0.0) return;

    // Between the rotor and the load.
    const double inward = is_upper ? -1.0 : 1.0;  // periodic torque at its worst angle
    const double cogging_Nm = inward * amplitude_of(Acts::kMotorSideTorque);
    const double load_sign = std::copysign(1.0, bound.torque_Nm);
    const double ripple = inward * load_sign * amplitude_of(Acts::kOutputTorque);
    const double meshed_Nm = bound.torque_Nm / (1.0 + ripple);
    const bool is_driving = meshed_Nm * speed_rad_s > 0.0;
    const double passed =
        is_driving ? actuator_.transmission.forward_efficiency / (1.0 + load_coefficient(true))
                   : actuator_.transmission.backward_efficiency * (1.0 - load_coefficient(false));
    const double load_W = bound.torque_Nm * speed_rad_s;
    const double mesh_W =
        std::abs(meshed_Nm * speed_rad_s) * (is_driving ? 1.0 / passed - 1.0 : 1.0 - passed);
    const double drag_W = -drag_Nm(speed_rad_s) * speed_rad_s;
    const double stored_W = -(cogging_Nm + ripple * meshed_Nm) * speed_rad_s;
    EXPECT_GE(mesh_W, 0.0);
    EXPECT_GE(drag_W, 0.0);
    EXPECT_NEAR(shaft_W, load_W + mesh_W + drag_W + stored_W,
                kRounding * (scale_W + std::abs(load_W)))
        << actuator_.name << " at " << speed_rad_s << (is_upper ? " upper" : " lower");
  }

  Actuator actuator_;
  double temperature_K_;
  Region joint_;
  Region motor_;
  int points_ = 0;
};

TEST(PowerBalance, HoldsAtEveryPointOfTheExamples) {
  const auto folder = std::filesystem::path(TORQUEWRIGHT_SOURCE_DIR) / "specs/actuator";
  int points = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const Actuator actuator = read_actuator(entry.path()).actuator;
    for (const Rating rating : {Rating::kPeak, Rating::kContinuous}) {
      OperatingConditions conditions;
      conditions.rating = rating;
      if (!objections(actuator, conditions).empty()) continue;
      Balance balance(actuator, conditions);
      balance.check_every_row();
      points += balance.points();
    }
  }
  EXPECT_GT(points, 1000);
}

// With effects, gear losses, sagging batteries, regeneration limits, every convention.
TEST(PowerBalance, HoldsAtEveryPointOfRandomActuators) {
  int points = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    RandomActuatorOptions options;
    options.field_weakening = seed % 20 == 0;
    Balance balance(random_actuator(seed, options), {});
    balance.check_every_row();
    points += balance.points();
    if (HasFailure()) FAIL() << "seed " << seed;
  }
  EXPECT_GT(points, 20000);
}

// At another temperature of the winding, where R, Kt and the grease differ.
TEST(PowerBalance, HoldsWarm) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    OperatingConditions warm;
    warm.winding_temperature_K = 373.15;
    Actuator actuator = random_actuator(seed, {});
    actuator.effects.push_back(effect("torque_constant_temperature", {-0.0011}));
    Balance balance(actuator, warm);
    balance.check_every_row();
  }
}

}  // namespace
}  // namespace torquewright::actuator
