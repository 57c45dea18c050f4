// SPDX-License-Identifier: Apache-2.0
// How near linkages come to what they cannot do: dead centres, rods at the end of their sockets.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <map>

#include "hopper/check/rules/every_rule.hpp"
#include "io/text/time_text.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;

struct Least {
  MechanismMargin margin;
  double time_s = 0.0;
};

Finding finding_of(const Drivetrain& drivetrain, const Least& least) {
  const bool is_broken = least.margin.margin < 0.0;
  return {is_broken ? actuator::Severity::kViolation : actuator::Severity::kNote,
          "mechanism-margin",
          drivetrain.actuator_names.front(),
          least.time_s,
          least.margin.value,
          least.margin.limit,
          least.margin.unit,
          fmt::format("{} ({}): {} comes to {:.4g} {} at t = {} s, limit {:.4g} {}, margin "
                      "{:.3g}",
                      fmt::join(drivetrain.actuator_names, ", "), drivetrain.mechanism->type(),
                      least.margin.name, least.margin.value, least.margin.unit,
                      io::time_text(least.time_s), least.margin.limit, least.margin.unit,
                      least.margin.margin)};
}

/// Of its own size: margins have units of their own.
double relative(const MechanismMargin& margin) {
  return margin.margin / (std::abs(margin.value) + std::abs(margin.limit));
}

/// All that are broken; else the one that comes nearest.
void add_findings(const Drivetrain& drivetrain, const std::map<std::string, Least>& least,
                  std::vector<Finding>& findings) {
  const Least* nearest = nullptr;
  for (const auto& [name, one] : least) {
    if (one.margin.margin < 0.0) findings.push_back(finding_of(drivetrain, one));
    if (nearest == nullptr || relative(one.margin) < relative(nearest->margin)) nearest = &one;
  }
  if (nearest == nullptr || nearest->margin.margin < 0.0) return;
  Finding finding = finding_of(drivetrain, *nearest);
  finding.sentence += fmt::format(", the least of {}", least.size());
  findings.push_back(std::move(finding));
}

}  // namespace

std::vector<Finding> mechanism_margins(const CheckedMotion& checked) {
  std::vector<Finding> findings;
  const Motion& motion = checked.motion;
  const Index joints = static_cast<Index>(checked.robot.tree.bodies.size()) - 1;
  for (const Drivetrain& drivetrain : checked.robot.drivetrains) {
    std::map<std::string, Least> least;
    SmallVector joint_rad(static_cast<Index>(drivetrain.joints.size()));
    for (Index sample = 0; sample < motion.samples(); ++sample) {
      for (Index i = 0; i < joint_rad.size(); ++i) {
        const auto body = static_cast<Index>(drivetrain.joints[static_cast<std::size_t>(i)]);
        joint_rad[i] = motion.positions(motion.positions.rows() - joints + body - 1, sample);
      }
      for (const MechanismMargin& margin : drivetrain.mechanism->margins(joint_rad)) {
        const auto [place, is_new] = least.try_emplace(margin.name, Least{margin, 0.0});
        if (!is_new && margin.margin >= place->second.margin.margin) continue;
        place->second = {margin, motion.time_s(sample)};
      }
    }
    add_findings(drivetrain, least, findings);
  }
  return findings;
}

}  // namespace torquewright::hopper
