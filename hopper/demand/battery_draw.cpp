// SPDX-License-Identifier: Apache-2.0
// A curve says no current, so that what its drive takes from the battery is not known; that is no
// less than what leaves its output.
#include "hopper/demand/battery_draw.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/text/wording.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;

/// Of drives that are known by their curve: what they give at their outputs.
struct GivenByCurves {
  std::vector<std::string> names;
  double energy_J = 0.0;
  double greatest_W = 0.0;
};

GivenByCurves given_by_curves(const CheckedMotion& checked) {
  GivenByCurves given;
  Eigen::VectorXd power_W = Eigen::VectorXd::Zero(checked.motion.samples());
  std::size_t drive = 0;
  for (const Drivetrain& drivetrain : checked.robot.drivetrains) {
    for (std::size_t i = 0; i < drivetrain.actuators.size(); ++i, ++drive) {
      if (!drivetrain.actuators[i].envelope) continue;
      given.names.push_back(drivetrain.actuator_names[i]);
      for (Index sample = 0; sample < power_W.size(); ++sample) {
        const DriveInstant& at = checked.demand.drives[drive][static_cast<std::size_t>(sample)];
        power_W[sample] += std::max(0.0, at.torque_Nm * at.speed_rad_s);
      }
    }
  }
  for (Index sample = 1; sample < power_W.size(); ++sample) {
    given.energy_J +=
        0.5 * checked.motion.step_s(sample - 1) * (power_W[sample - 1] + power_W[sample]);
  }
  if (power_W.size() > 0) given.greatest_W = power_W.maxCoeff();
  return given;
}

}  // namespace

std::vector<Finding> battery_draw(const CheckedMotion& checked) {
  if (checked.robot.battery.empty()) return {};
  const GivenByCurves given = given_by_curves(checked);
  if (given.names.empty()) return {};
  Finding finding;
  finding.rule = "battery-draw-unknown";
  const std::string least =
      checked.demand.has_dynamics
          ? fmt::format(", but for what leaves their outputs: {:.4g} J, {:.4g} W at most",
                        given.energy_J, given.greatest_W)
          : "";
  finding.sentence = fmt::format(
      "what {} take from the robot's battery is not known, for curves say no current{}; a winding "
      "in their documents (/motor and /drive, which `actuator lint` estimates from a torque "
      "constant, resistance, voltage or current) says it",
      io::listed(given.names), least);
  return {finding};
}

}  // namespace torquewright::hopper
