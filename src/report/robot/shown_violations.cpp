// SPDX-License-Identifier: Apache-2.0
#include "src/report/robot/shown_violations.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::report {
namespace {

using Eigen::Index;
using hopper::Motion;
using hopper::Robot;

constexpr double kRoundOff = 1e-9;              // relative, as the checks'
constexpr double kInvisibleShare = 1.0 / 2000;  // of the motion's time

/// The bodies that a drive, a joint, a contact or a body of that name moves or is.
std::vector<std::size_t> bodies_of(const Robot& robot, const std::string& name) {
  for (const hopper::Drivetrain& drivetrain : robot.drivetrains) {
    const auto& names = drivetrain.actuator_names;
    if (std::find(names.begin(), names.end(), name) != names.end()) return drivetrain.joints;
  }
  if (const auto joint = robot.find_joint(name)) return {*joint};
  for (const hopper::ContactPoint& contact : robot.contacts) {
    if (contact.name == name) return {contact.point.body};
  }
  for (std::size_t body = 0; body < robot.tree.bodies.size(); ++body) {
    if (robot.tree.bodies[body].name == name) return {body};
  }
  return {};
}

/// When a joint lies beyond the limit that the rule is about.
std::vector<Interval> beyond_limit(const HopperPage& page, const hopper::Series& series,
                                   const ShownViolation& shown) {
  const Motion& motion = page.motion;
  const std::size_t body = *page.robot.find_joint(shown.name);
  const dynamics::JointLimits& limits = page.robot.tree.bodies[body].joint.limits;
  const auto above_end = static_cast<Index>(page.robot.tree.bodies.size() - body);
  const auto passes = [](double value, double limit) {
    return value - limit > kRoundOff * std::max(1.0, std::abs(limit));
  };
  if (shown.rule == "joint-range") {
    const auto at = motion.positions.row(motion.positions.rows() - above_end);
    return stretches(motion.times_s, [&](Index i) {
      return passes(at[i], limits.position_max) || passes(-at[i], -limits.position_min);
    });
  }
  if (shown.rule == "joint-speed") {
    const auto at = motion.velocities.row(motion.velocities.rows() - above_end);
    return stretches(motion.times_s,
                     [&](Index i) { return passes(std::abs(at[i]), limits.speed_max); });
  }
  const bool is_given = motion.has_effort[body - 1];
  const Eigen::VectorXd* made = hopper::find_column(series, shown.name + "_joint_torque_Nm");
  if (made == nullptr) made = hopper::find_column(series, shown.name + "_joint_force_N");
  if (!is_given && made == nullptr) return {};
  return stretches(motion.times_s, [&](Index i) {
    const double effort = is_given ? motion.efforts(static_cast<Index>(body) - 1, i) : (*made)[i];
    return passes(std::abs(effort), limits.effort_max);
  });
}

std::vector<Interval> times_of(const HopperPage& page, const hopper::Series& series,
                               const ShownViolation& shown) {
  if (shown.rule == "motor-operating-region") {
    const Eigen::VectorXd outside = outside_region(series, shown.name);
    return stretches(page.motion.times_s, [&outside](Index i) { return outside[i] > 0.0; });
  }
  if (shown.rule.starts_with("joint-") && page.robot.find_joint(shown.name)) {
    return beyond_limit(page, series, shown);
  }
  if (shown.rule == "transmission-load") {
    return {{shown.worst_s, shown.worst_s + page.options.load_window_s}};
  }
  return {};
}

}  // namespace

bool ShownViolation::holds_at(double time_s) const {
  return std::any_of(times.begin(), times.end(), [time_s](const Interval& interval) {
    return interval.from_s <= time_s && time_s <= interval.until_s;
  });
}

std::vector<Interval> stretches(const std::vector<double>& times_s,
                                const std::function<bool(Index)>& is_so) {
  std::vector<Interval> found;
  const double invisible_s = kInvisibleShare * (times_s.back() - times_s.front());
  bool goes_on = false;
  for (std::size_t i = 0; i < times_s.size(); ++i) {
    const bool was_so = goes_on;
    goes_on = is_so(static_cast<Index>(i));
    if (!goes_on) continue;
    if (!found.empty() && (was_so || times_s[i] - found.back().until_s < invisible_s)) {
      found.back().until_s = times_s[i];
    } else {
      found.push_back({times_s[i], times_s[i]});
    }
  }
  return found;
}

std::vector<ShownViolation> shown_violations(const HopperPage& page, const hopper::Series& series) {
  std::vector<ShownViolation> all;
  for (const actuator::Finding& finding : page.report.check.findings) {
    if (finding.severity != actuator::Severity::kViolation || !finding.time_s) continue;
    ShownViolation& shown = all.emplace_back();
    shown.name = finding.joint;
    shown.rule = finding.rule;
    shown.sentence = finding.sentence;
    shown.bodies = bodies_of(page.robot, finding.joint);
    shown.worst_s = *finding.time_s;
    shown.times = times_of(page, series, shown);
    if (shown.times.empty()) shown.times = {{shown.worst_s, shown.worst_s}};
  }
  return all;
}

Eigen::VectorXd outside_region(const hopper::Series& series, const std::string& drive) {
  const Eigen::VectorXd& margin_Nm = *hopper::find_column(series, drive + "_torque_margin_Nm");
  const Eigen::VectorXd& torque_Nm = *hopper::find_column(series, drive + "_drive_torque_Nm");
  const double round_off_Nm = kRoundOff * torque_Nm.cwiseAbs().maxCoeff();
  // An empty region has no margin: all torque lies outside.
  return margin_Nm.unaryExpr(
      [round_off_Nm](double margin) { return margin >= -round_off_Nm ? 0.0 : 1.0; });
}

}  // namespace torquewright::report
