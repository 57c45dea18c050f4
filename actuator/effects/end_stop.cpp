// SPDX-License-Identifier: Apache-2.0
// A joint's travel ends at a buffer, a bracket or a hard corner: two effects, one for each end, as
// a log may reach one of them only.
#include <algorithm>
#include <limits>

#include "actuator/effects/every_effect.hpp"

namespace torquewright::actuator::effects {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr double kSteepness = 300.0;  ///< All torque within a three-hundredth of the travel.

constexpr Parameter kParameters[] = {
    {.name = "stiffness_Nm_rad",
     .lowest = 0.0,
     .highest = kInfinity,
     .neutral = 0.0,
     .meaning = "Torque per angle beyond the stop.",
     .steepness = kSteepness},
    {"angle_rad", -kInfinity, kInfinity, 0.0, "Of the output, at which it touches."},
};

double upper_law(const Effect& effect, const Instant& at) {
  return -effect.values[0] * std::max(0.0, at.output_angle_rad - effect.values[1]);
}

double lower_law(const Effect& effect, const Instant& at) {
  return effect.values[0] * std::max(0.0, effect.values[1] - at.output_angle_rad);
}

/// Touched at the other end of all motion, it is a spring.
constexpr std::string_view kTendsTo[] = {"parallel_spring"};

/// Shares of the width of a range about zero: more of them at its end, which is touched seldom.
constexpr double kPlaces[] = {0.1, 0.25, 0.35, 0.45};

std::vector<std::vector<double>> starts_on(double side, const Ranges& ranges) {
  std::vector<std::vector<double>> starts;
  for (const double share : kPlaces) starts.push_back({0.0, side * share * ranges.angle_rad});
  return starts;
}

constexpr EffectKind stop(std::string_view name, std::string_view sentence,
                          double (*law)(const Effect&, const Instant&),
                          std::vector<std::vector<double>> (*starts)(const Ranges&)) {
  EffectKind kind;
  kind.name = name;
  kind.acts = Acts::kOutputTorque;
  kind.sentence = sentence;
  kind.parameters = kParameters;
  kind.law = law;
  kind.stiffness_Nm_rad = [](const Effect& effect) { return effect.values[0]; };
  kind.tends_to = kTendsTo;
  kind.starts = starts;
  return kind;
}

}  // namespace

const EffectKind upper_end_stop = {
    stop("upper_end_stop", "The travel ends above: an elastic stop pushes back from an angle on.",
         upper_law, [](const Ranges& ranges) { return starts_on(1.0, ranges); })};

const EffectKind lower_end_stop = {
    stop("lower_end_stop", "The travel ends below: an elastic stop pushes back up to an angle.",
         lower_law, [](const Ranges& ranges) { return starts_on(-1.0, ranges); })};

}  // namespace torquewright::actuator::effects
