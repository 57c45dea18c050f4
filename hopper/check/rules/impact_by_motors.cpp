// SPDX-License-Identifier: Apache-2.0
// A jump of velocity that no impact of rigid bodies makes asks for an impulse of the motors, which
// have only the time between two samples for it.
#include <fmt/format.h>

#include <cmath>

#include "actuator/region/joint_region.hpp"
#include "hopper/check/rules/every_rule.hpp"
#include "io/text/time_text.hpp"

namespace torquewright::hopper {
namespace {

constexpr double kNegligible = 1e-3;  // of weight times size times the window

double peak_torque_Nm(const actuator::Actuator& actuator,
                      const actuator::OperatingConditions& conditions) {
  const actuator::JointRange range = actuator::Region(actuator, conditions).at(0.0);
  return std::max(range.greatest.torque_Nm, -range.least.torque_Nm);
}

}  // namespace

std::vector<Finding> impact_by_motors(const CheckedMotion& checked) {
  std::vector<Finding> findings;
  const Demand& demand = checked.demand;
  const double small_Nm_s =
      kNegligible * demand.weight_N * demand.size_m * checked.options.load_window_s;
  Eigen::Index drive = 0;
  for (const Drivetrain& drivetrain : checked.robot.drivetrains) {
    for (std::size_t i = 0; i < drivetrain.actuators.size(); ++i, ++drive) {
      const Jolt* worst = nullptr;
      for (const Jolt& jolt : demand.jolts) {
        const bool is_more = worst == nullptr ||
                             std::abs(jolt.drive_Nm_s[drive]) > std::abs(worst->drive_Nm_s[drive]);
        if (is_more) worst = &jolt;
      }
      if (worst == nullptr || std::abs(worst->drive_Nm_s[drive]) <= small_Nm_s) continue;
      const double step_s = worst->sample > 0 ? checked.motion.step_s(worst->sample - 1) : 0.0;
      const double limit_Nm_s =
          step_s * peak_torque_Nm(drivetrain.actuators[i], checked.options.conditions);
      const double asked_Nm_s = std::abs(worst->drive_Nm_s[drive]);
      const bool is_possible = asked_Nm_s <= limit_Nm_s;
      findings.push_back(
          {is_possible ? actuator::Severity::kNote : actuator::Severity::kWarning,
           "impact-by-motors", drivetrain.actuator_names[i], worst->time_s, asked_Nm_s, limit_Nm_s,
           "Nm s",
           fmt::format("{}: velocities jump at t = {} s by more than the impact of rigid "
                       "bodies makes; its motor would have to give {:.4g} Nm s, and can give "
                       "{:.4g} Nm s in the {:.3g} ms between the samples",
                       drivetrain.actuator_names[i], io::time_text(worst->time_s), asked_Nm_s,
                       limit_Nm_s, 1e3 * step_s)});
    }
  }
  return findings;
}

}  // namespace torquewright::hopper
