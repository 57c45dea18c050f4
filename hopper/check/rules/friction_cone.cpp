// SPDX-License-Identifier: Apache-2.0
// How much of the friction the motion uses. Forces that were solved lie in their cones, but may
// stand at the edge; those of a file may lie outside.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "hopper/check/rules/every_rule.hpp"
#include "io/text/time_text.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;

constexpr double kRoundOff = 1e-6;

}  // namespace

std::vector<Finding> friction_cone(const CheckedMotion& checked) {
  std::vector<Finding> findings;
  const Demand& demand = checked.demand;
  if (!demand.has_dynamics) return findings;
  const Eigen::MatrixXd& forces_N =
      checked.motion.has_forces ? checked.motion.forces_N : demand.forces_N;
  const double small_N = kBearsLoad * demand.weight_N;
  std::optional<Finding> most_used;
  double most_share = 0.0;
  for (Index i = 0; i < static_cast<Index>(checked.robot.contacts.size()); ++i) {
    const ContactPoint& contact = checked.robot.contacts[static_cast<std::size_t>(i)];
    double most = 0.0;
    double most_time_s = 0.0;
    double pull_N = 0.0;
    double pull_time_s = 0.0;
    for (Index sample = 0; sample < checked.motion.samples(); ++sample) {
      const Eigen::Vector3d force_N = forces_N.block<3, 1>(3 * i, sample);
      const double time_s = checked.motion.time_s(sample);
      if (-force_N.z() > std::max(pull_N, small_N)) {
        pull_N = -force_N.z();
        pull_time_s = time_s;
      }
      if (force_N.norm() < small_N || force_N.z() <= 0.0) continue;
      const double ratio = force_N.head<2>().norm() / force_N.z();
      if (ratio <= most) continue;
      most = ratio;
      most_time_s = time_s;
    }
    if (pull_N > 0.0) {
      findings.push_back({actuator::Severity::kViolation, "ground-pulls", contact.name, pull_time_s,
                          -pull_N, 0.0, "N",
                          fmt::format("{}: the ground would have to pull, with {:.4g} N at t = "
                                      "{} s",
                                      contact.name, pull_N, io::time_text(pull_time_s))});
    }
    if (most == 0.0) continue;
    const bool slips = most > contact.friction_coefficient * (1.0 + kRoundOff) + kRoundOff;
    Finding finding{
        slips ? actuator::Severity::kViolation : actuator::Severity::kNote,
        "friction-cone",
        contact.name,
        most_time_s,
        most,
        contact.friction_coefficient,
        "",
        fmt::format("{}: tangential over normal force reaches {:.3g} at t = {} "
                    "s, the friction coefficient is {:.3g}",
                    contact.name, most, io::time_text(most_time_s), contact.friction_coefficient)};
    const double share = most / std::max(contact.friction_coefficient, kRoundOff);
    if (slips) {
      findings.push_back(std::move(finding));
    } else if (share > most_share) {
      most_share = share;
      most_used = std::move(finding);
    }
  }
  if (most_used) findings.push_back(std::move(*most_used));
  return findings;
}

}  // namespace torquewright::hopper
