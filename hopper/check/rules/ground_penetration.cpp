// SPDX-License-Identifier: Apache-2.0
// Contact points below the ground.
#include <fmt/format.h>

#include "hopper/check/rules/every_rule.hpp"

namespace torquewright::hopper {
namespace {

constexpr double kSoftGround_m = 0.01;  // so far feet sink into that of simulators

}  // namespace

std::vector<Finding> ground_penetration(const CheckedMotion& checked) {
  std::vector<Finding> findings;
  const Eigen::MatrixXd& heights_m = checked.contacts.height_m;
  const double limit_m = checked.contacts.thresholds.height_m;
  for (Eigen::Index i = 0; i < heights_m.rows(); ++i) {
    Eigen::Index sample = 0;
    const double least_m = heights_m.row(i).minCoeff(&sample);
    if (least_m >= -limit_m) continue;
    const std::string& name = checked.robot.contacts[static_cast<std::size_t>(i)].name;
    const bool is_soft = !checked.options.contact.height_m && least_m >= -kSoftGround_m;
    findings.push_back(
        {is_soft ? actuator::Severity::kWarning : actuator::Severity::kViolation,
         "contact-below-ground", name, checked.motion.time_s(sample), least_m, -limit_m, "m",
         fmt::format("{}: {:.4g} m below the ground at t = {:.6g} s (up to {:.4g} m counts as "
                     "touching; is the ground at {:.4g} m? --ground-height, --contact-height)",
                     name, -least_m, checked.motion.time_s(sample), limit_m,
                     checked.options.contact.ground_height_m)});
  }
  return findings;
}

}  // namespace torquewright::hopper
