// SPDX-License-Identifier: Apache-2.0
#include "hopper/replay/verdict.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "dynamics/momentum.hpp"
#include "dynamics/position_step.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kShortestFlight_s = 0.01;  ///< A shorter loss of contact is chatter.
constexpr double kLeastTurn_rad = 0.1;      ///< Less has no axis of its own: pitch is taken.

struct Span {
  double from_s = 0.0, until_s = 0.0;
};

/// The longest stretch without contact that ends with one.
std::optional<Span> longest_flight(const Record& record) {
  std::optional<Span> longest;
  double last_contact_s = record.rows.empty() ? 0.0 : record.rows.front().time_s;
  for (const RecordRow& row : record.rows) {
    if (!row.touches.any()) continue;
    const double length_s = row.time_s - last_contact_s;
    const bool is_longest = !longest || length_s > longest->until_s - longest->from_s;
    if (length_s >= kShortestFlight_s && is_longest) longest = {last_contact_s, row.time_s};
    last_contact_s = row.time_s;
  }
  return longest;
}

std::optional<Span> longest_flight(const Reference& reference) {
  std::optional<Span> longest;
  const std::vector<ContactMode>& modes = reference.modes();
  for (std::size_t i = 0; i + 1 < modes.size(); ++i) {
    if (modes[i].touches.any()) continue;
    const double length_s = modes[i].until_s - modes[i].from_s;
    const bool is_longest = !longest || length_s > longest->until_s - longest->from_s;
    if (length_s >= kShortestFlight_s && is_longest) longest = {modes[i].from_s, modes[i].until_s};
  }
  return longest;
}

Eigen::Matrix3d attitude(const dynamics::Tree& tree, const VectorXd& position) {
  if (tree.base != dynamics::BaseKind::kSpatial) {
    const double pitch = tree.base == dynamics::BaseKind::kPlanar ? position[2] : 0.0;
    return Eigen::AngleAxisd(pitch, Vector3d::UnitY()).toRotationMatrix();
  }
  return Eigen::Quaterniond(position[3], position[4], position[5], position[6])
      .normalized()
      .toRotationMatrix();
}

/// The base's rotation from one position to the next, in the world's axes.
Vector3d turn_rad(const dynamics::Tree& tree, const VectorXd& from, const VectorXd& to) {
  if (tree.base == dynamics::BaseKind::kFixed) return Vector3d::Zero();
  if (tree.base == dynamics::BaseKind::kPlanar) return (to[2] - from[2]) * Vector3d::UnitY();
  VectorXd way(tree.velocity_size());
  dynamics::position_difference(tree, from, to, way);
  return attitude(tree, from) * way.segment<3>(3);
}

/// Turned since the begin until a time, as the run's rows see the motion.
Vector3d planned_turn_rad(const dynamics::Tree& tree, const Reference& reference, double period_s,
                          double until_s) {
  Vector3d sum = Vector3d::Zero();
  ReferenceInstant before, after;
  reference.at(reference.begins_s(), before);
  const auto steps = static_cast<int>(std::ceil((until_s - reference.begins_s()) / period_s));
  for (int i = 1; i <= steps; ++i) {
    reference.at(std::min(until_s, reference.begins_s() + i * period_s), after);
    sum += turn_rad(tree, before.position, after.position);
    std::swap(before, after);
  }
  return sum;
}

Vector3d turned_rad(const dynamics::Tree& tree, const Record& record, double until_s) {
  Vector3d sum = Vector3d::Zero();
  for (std::size_t i = 1; i < record.rows.size() && record.rows[i].time_s <= until_s; ++i) {
    sum += turn_rad(tree, record.rows[i - 1].position, record.rows[i].position);
  }
  return sum;
}

std::optional<TouchDown> touch_down_of(const Robot& robot, const Reference& reference,
                                       const Record& record) {
  const auto planned = longest_flight(reference);
  const auto flown = longest_flight(record);
  if (!planned || !flown) return std::nullopt;
  const Vector3d plan_rad =
      planned_turn_rad(robot.tree, reference, record.control_period_s, planned->until_s);
  const Vector3d axis =
      plan_rad.norm() > kLeastTurn_rad ? plan_rad.normalized() : Vector3d(Vector3d::UnitY());
  const Vector3d run_rad = turned_rad(robot.tree, record, flown->until_s);
  return TouchDown{flown->until_s, planned->until_s, axis.dot(plan_rad - run_rad)};
}

double foot_at_rest_s(const Record& record, const StandingRule& rule) {
  double since_s = record.end_s;
  for (auto row = record.rows.rbegin(); row != record.rows.rend(); ++row) {
    if (!row->touches.any() || row->slip_m_s > rule.foot_speed_m_s) break;
    since_s = row->time_s;
  }
  return record.end_s - since_s;
}

/// Why a robot that was watched to the end does not stand; empty: it does.
std::string objection(const Robot& robot, const Reference& reference, const Record& record,
                      double at_rest_s, const StandingRule& rule) {
  const RecordRow& last = record.rows.back();
  if (last.touches.size() > 0 && !last.touches.any()) {
    return "at the end of the time that it is watched, no foot touches the ground";
  }
  if (at_rest_s < rule.at_rest_s) {
    return fmt::format(
        "at the end of the time that it is watched, its feet are at rest for {:.3g} s only, where "
        "standing takes {:.3g} s",
        at_rest_s, rule.at_rest_s);
  }
  dynamics::TreeState state(robot.tree);
  state.set(last.position, last.velocity);
  const double speed_m_s = dynamics::centroid(state).velocity_m_s.norm();
  if (speed_m_s > rule.body_speed_m_s) {
    return fmt::format("its feet are at rest, but its centre of mass still moves at {:.3g} m/s",
                       speed_m_s);
  }
  ReferenceInstant goal;
  reference.at(reference.ends_s(), goal);
  const Eigen::Matrix3d off =
      attitude(robot.tree, goal.position).transpose() * attitude(robot.tree, last.position);
  const double tilt_rad = Eigen::AngleAxisd(off).angle();
  if (tilt_rad > rule.tilt_rad) {
    return fmt::format(
        "it came to rest with its base {:.0f} degrees from the posture that the motion ends in",
        tilt_rad * 180.0 / std::numbers::pi);
  }
  return "";
}

}  // namespace

std::string_view name_of(ReplayVerdict verdict) {
  switch (verdict) {
    case ReplayVerdict::kStands:
      return "stands";
    case ReplayVerdict::kFell:
      return "fell";
    case ReplayVerdict::kUndecided:
      return "undecided";
    default:
      return "unfinished";
  }
}

ReplayOutcome outcome_of(const Robot& robot, const Reference& reference, const Record& record,
                         const StandingRule& rule) {
  ReplayOutcome outcome;
  outcome.end_s = record.end_s;
  outcome.reason = record.reason;
  if (record.rows.empty()) return outcome;
  outcome.touch_down = touch_down_of(robot, reference, record);
  outcome.foot_at_rest_s = foot_at_rest_s(record, rule);
  if (record.end == RunEnd::kStopped || record.end == RunEnd::kAsked) return outcome;
  if (record.end == RunEnd::kDone) {
    outcome.reason = objection(robot, reference, record, outcome.foot_at_rest_s, rule);
  }
  outcome.verdict = outcome.reason.empty() ? ReplayVerdict::kStands : ReplayVerdict::kFell;
  return outcome;
}

}  // namespace torquewright::hopper
