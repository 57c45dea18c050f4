// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/programme/plan_setup.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dynamics/gravity.hpp"
#include "hopper/planning/programme/hops.hpp"
#include "hopper/planning/programme/standing.hpp"
#include "io/faults/refusal.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using optimization::Bounds;

/// What a phase is for: how long it lasts at least, how long a guess takes it to last, and its
/// share of the intervals.
struct Kind {
  double shortest_s;
  double usual_s;
  double share;
  double LongestPhases::*longest_s;
  const char* option;  ///< That bounds it.
};
constexpr Kind kFirst{0.2, 0.5, 20.0, &LongestPhases::first_s, "--longest-first"};
constexpr Kind kLast{0.4, 0.7, 40.0, &LongestPhases::last_s, "--longest-last"};
// Where contacts change, torques do so fastest (trial: a push-off cut coarsely found motions that
// are none).
constexpr Kind kPushOff{0.02, 0.085, 30.0, &LongestPhases::push_off_s, "--longest-push-off"};
constexpr Kind kLanding{0.02, 0.16, 30.0, &LongestPhases::landing_s, "--longest-landing"};
// As long as it takes to catch the last hop and gather for the next.
constexpr Kind kBetween{0.05, 0.2, 30.0, &LongestPhases::between_s, "--longest-between"};
constexpr Kind kFlight{0.05, 0.425, 60.0, &LongestPhases::flight_s, "--longest-flight"};
constexpr std::size_t kFewestIntervals = 4;  // of a phase

Kind kind_of(const std::vector<Stance>& stances, std::size_t phase) {
  if (stances[phase].is_flight()) return kFlight;
  if (phase == 0) return kFirst;
  if (phase + 1 == stances.size()) return kLast;
  const auto flies_in = [&](std::size_t from, std::size_t to) {
    return std::any_of(stances.begin() + static_cast<std::ptrdiff_t>(from),
                       stances.begin() + static_cast<std::ptrdiff_t>(to),
                       [](const Stance& one) { return one.is_flight(); });
  };
  const bool has_flown = flies_in(0, phase);
  if (has_flown && flies_in(phase, stances.size()) && stances[phase].name == "flat") {
    return kBetween;
  }
  // After the last time that it stood whole or flew.
  std::size_t since = phase;
  while (since > 0 && stances[since - 1].name != "flat" && !stances[since - 1].is_flight()) --since;
  return has_flown && stances[since - 1].is_flight() ? kLanding : kPushOff;
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

/// Of all phases but those after the first flight up to the last: a motion of many flights has as
/// many intervals for each.
double shares_of_one_flight(const std::vector<Stance>& stances) {
  double shares = 0.0;
  std::size_t flights = 0, last = 0;
  for (std::size_t p = 0; p < stances.size(); ++p) {
    if (stances[p].is_flight()) last = p;
  }
  for (std::size_t p = 0; p < stances.size(); ++p) {
    if (flights == 0 || p > last) shares += kind_of(stances, p).share;
    if (stances[p].is_flight()) ++flights;
  }
  return shares;
}

/// A flight reaches its apex, and every phase lasts a little.
void require_duration(const Bounds& duration_s, const Kind& kind) {
  if (duration_s.lower <= duration_s.upper) return;
  io::refuse(kind.option, fmt::format("is {:g} s, and this phase takes {:.3g} s at least",
                                      duration_s.upper, duration_s.lower));
}

}  // namespace

std::vector<MeshPhase> first_mesh(const std::vector<Stance>& stances, const PlanOptions& options) {
  // A flight that rises has its apex within.
  const double rise_m = options.task->takes_rise ? options.rise_m : 0.0;
  const double to_apex_s = std::sqrt(2.0 * rise_m / dynamics::kGravity_m_s2);
  const double shares = shares_of_one_flight(stances);
  std::vector<MeshPhase> mesh;
  for (std::size_t p = 0; p < stances.size(); ++p) {
    const Kind kind = kind_of(stances, p);
    const auto intervals =
        static_cast<std::size_t>(std::lround(options.intervals * kind.share / shares));
    Bounds duration_s{kind.shortest_s, options.longest.*kind.longest_s};
    double guess_s = kind.usual_s;
    if (stances[p].is_flight() && to_apex_s > duration_s.lower) {
      duration_s.lower = to_apex_s;
      guess_s = 0.5 * (to_apex_s + 2.0 * kind.usual_s - kind.shortest_s);
    }
    require_duration(duration_s, kind);
    mesh.push_back({stances[p], even_knots(std::max(kFewestIntervals, intervals)), duration_s,
                    std::clamp(guess_s, duration_s.lower, duration_s.upper)});
  }
  return mesh;
}

PlanGoal plan_goal(const PlanModel& model, const PlanOptions& options) {
  PlanGoal goal;
  options.task->set_goal(options, goal);
  set_hops(plan_stances(model.plane, options), model, options, goal);
  goal.has_level_base = model.plane.sole.size() == 1;
  for (const Bounds& range : model.joint_rad) {
    const double quarter = 0.25 * (range.upper - range.lower);
    goal.standing_rad.push_back({range.lower + quarter, range.upper - quarter});
  }
  if (const Posture* posture = standing_posture(model.plane.robot.postures)) {
    for (std::size_t i = 0; i < model.plane.joints.size(); ++i) {
      const double rad = posture->joints[static_cast<Index>(model.plane.joints[i]) - 1];
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
  std::vector<std::string> once{"flat", "flight", "flat"};
  const auto& of_a_sole = options.task->stances_of_a_sole;
  if (plane.sole.size() > 1) once.assign(of_a_sole.begin(), of_a_sole.end());
  std::vector<std::string> names = once;
  // The last stance is the next one's first.
  for (int i = 1; i < options.repeat; ++i) names.insert(names.end(), once.begin() + 1, once.end());
  return stances_of(plane, names);
}

}  // namespace torquewright::hopper
