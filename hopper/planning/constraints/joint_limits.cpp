// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "hopper/planning/constraints/every_constraint.hpp"

namespace torquewright::hopper {
namespace {

double at_joint(int first, const Site& site, const std::vector<double>& values) {
  return values[static_cast<std::size_t>(first + 3) + static_cast<std::size_t>(site.row)];
}

std::string named(const Site& site, const Constraint& constraint) {
  const std::size_t body = site.model.plane.joints[static_cast<std::size_t>(site.row)];
  return site.model.plane.robot.tree.bodies[body].joint.name + ": " + std::string(constraint.name);
}

std::vector<PlanLimit> ranges(const Site& site, const std::vector<double>& values) {
  const auto joint = static_cast<std::size_t>(site.row);
  const optimization::Bounds& range =
      site.stance().is_flight() ? site.model.flight_rad[joint] : site.model.joint_rad[joint];
  const double at = at_joint(site.point().position, site, values);
  return {{named(site, constraints::range), std::min(at - range.lower, range.upper - at),
           range.upper - range.lower}};
}

std::vector<PlanLimit> speeds(const Site& site, const std::vector<double>& values) {
  const double most_rad_s = site.model.joint_rad_s[static_cast<std::size_t>(site.row)];
  const double speed_rad_s = std::abs(at_joint(site.point().velocity, site, values));
  return {{named(site, constraints::speed), most_rad_s - speed_rad_s, most_rad_s}};
}

}  // namespace

const Constraint constraints::range{
    "range",       "rad",   "each joint is within its range, by the bounds of the unknowns",
    Where::kJoint, nullptr, ranges};

const Constraint constraints::speed{
    "speed",       "rad/s", "each joint is within its speed limit, by the bounds of the unknowns",
    Where::kJoint, nullptr, speeds};

}  // namespace torquewright::hopper
