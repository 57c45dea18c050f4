// SPDX-License-Identifier: Apache-2.0
#include "hopper/flip/plan_setup.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dynamics/gravity.hpp"
#include "hopper/flip/standing.hpp"
#include "io/refusal.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using optimization::Bounds;

/// How long a phase may last, and its share of the intervals.
struct Kind {
  Bounds duration_s;
  double share;
};
// Long enough for a robot of a metre to gather itself and to come to rest; the last one short
// enough that it does not creep: a replay falls while it does (trial: 1.6 s fell, 1.0 s stood).
constexpr Kind kFirst{{0.2, 0.8}, 20.0};
constexpr Kind kLast{{0.4, 1.0}, 40.0};
// Where contacts change, torques do so fastest (trial: a push-off cut coarsely found motions that
// are none). A push-off on an edge that lasts has the foot hover: there the whole sole stands.
constexpr Kind kPushOff{{0.02, 0.15}, 30.0};
constexpr Kind kLanding{{0.02, 0.3}, 30.0};
constexpr Kind kFlight{{0.05, 0.8}, 60.0};
constexpr std::size_t kFewestIntervals = 4;  // of a phase

Kind kind_of(const std::vector<Stance>& stances, std::size_t phase) {
  if (stances[phase].is_flight()) return kFlight;
  if (phase == 0) return kFirst;
  if (phase + 1 == stances.size()) return kLast;
  const auto flight = std::find_if(stances.begin(), stances.end(),
                                   [](const Stance& one) { return one.is_flight(); });
  return stances.begin() + static_cast<std::ptrdiff_t>(phase) < flight ? kPushOff : kLanding;
}

std::vector<double> even_knots(std::size_t intervals) {
  std::vector<double> knots;
  for (std::size_t i = 0; i <= intervals; ++i) {
    knots.push_back(static_cast<double>(i) / static_cast<double>(intervals));
  }
  return knots;
}

/// A turn, a rise and a stride happen in the air: where there is none, standing still would do.
void require_flight(const std::vector<Stance>& stances, const PlanTask& task) {
  const bool has_flight = std::any_of(stances.begin(), stances.end(),
                                      [](const Stance& one) { return one.is_flight(); });
  if (has_flight) return;
  std::vector<std::string> names;
  for (const Stance& one : stances) names.push_back(one.name);
  io::refuse("--contacts", fmt::format("{} never leaves the ground, and a {} does: it has a "
                                       "'flight' among its contacts, as flat,flight,flat",
                                       fmt::join(names, ","), task.name));
}

}  // namespace

std::vector<MeshPhase> first_mesh(const std::vector<Stance>& stances, const PlanOptions& options) {
  // A flight that rises has its apex within.
  const double rise_m = options.task->takes_rise ? options.rise_m : 0.0;
  const double to_apex_s = std::sqrt(2.0 * rise_m / dynamics::kGravity_m_s2);
  double shares = 0.0;
  for (std::size_t p = 0; p < stances.size(); ++p) shares += kind_of(stances, p).share;
  std::vector<MeshPhase> mesh;
  for (std::size_t p = 0; p < stances.size(); ++p) {
    const Kind kind = kind_of(stances, p);
    const auto intervals =
        static_cast<std::size_t>(std::lround(options.intervals * kind.share / shares));
    Bounds duration_s = kind.duration_s;
    if (stances[p].is_flight()) duration_s.lower = std::max(duration_s.lower, to_apex_s);
    mesh.push_back({stances[p], even_knots(std::max(kFewestIntervals, intervals)), duration_s});
  }
  return mesh;
}

PlanGoal plan_goal(const PlanModel& model, const PlanOptions& options) {
  PlanGoal goal;
  options.task->set_goal(options, goal);
  goal.has_level_base = model.plane.sole.size() == 1;
  for (const Bounds& range : model.joint_rad) {
    const double quarter = 0.25 * (range.upper - range.lower);
    goal.standing_rad.push_back({range.lower + quarter, range.upper - quarter});
  }
  for (const Posture& posture : model.plane.robot.postures) {
    if (posture.name != "stand") continue;
    for (std::size_t i = 0; i < model.plane.joints.size(); ++i) {
      const double rad = posture.joints[static_cast<Index>(model.plane.joints[i]) - 1];
      goal.standing_rad[i] = {rad, rad};
    }
    const std::size_t free = balancing_joint(model.plane);
    goal.standing_rad[free] = model.joint_rad[free];
  }
  require_standing(model, goal);
  return goal;
}

std::vector<Stance> plan_stances(const SagittalRobot& plane, const PlanOptions& options) {
  if (!options.stances.empty()) {
    std::vector<Stance> stances = stances_of(plane, options.stances);
    require_flight(stances, *options.task);
    return stances;
  }
  if (plane.sole.size() == 1) return stances_of(plane, {"flat", "flight", "flat"});
  const auto& of_a_sole = options.task->stances_of_a_sole;
  return stances_of(plane, {of_a_sole.begin(), of_a_sole.end()});
}

}  // namespace torquewright::hopper
