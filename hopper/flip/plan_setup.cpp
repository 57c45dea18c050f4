// SPDX-License-Identifier: Apache-2.0
#include "hopper/flip/plan_setup.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using optimization::Bounds;

static double envd(const char* n,double d){const char*v=getenv(n);return v?atof(v):d;}
static const Bounds kStanding_s{0.2, envd("HS",0.6)};
static const Bounds kTipping_s{0.02, envd("HT",0.15)};
constexpr Bounds kFlight_s{0.05, 0.8};
// Shares of the intervals: where contacts change, torques do so fastest (trial: a push-off cut
// coarsely found motions that are none).
constexpr double kStandingShare = 16.0;
constexpr double kTippingShare = 24.0;
constexpr double kFlightShare = 20.0;
constexpr std::size_t kFewestIntervals = 4;  // of a phase

struct Kind {
  Bounds duration_s;
  double share;
};

Kind kind_of(const std::vector<Stance>& stances, std::size_t phase) {
  if (stances[phase].is_flight()) return {kFlight_s, envd("SF",60)};
  if (phase == 0) return {{0.2, envd("HA", 0.8)}, envd("SA",20)};
  if (phase + 1 == stances.size()) return {{0.4, envd("HZ", 2.0)}, envd("SZ",40.0)};
  return {{0.02, phase==1 ? envd("H1",0.3) : envd("H3",0.3)}, phase==1?envd("S1",30):envd("S3",30)};
}

std::vector<double> even_knots(std::size_t intervals) {
  std::vector<double> knots;
  for (std::size_t i = 0; i <= intervals; ++i) {
    knots.push_back(static_cast<double>(i) / static_cast<double>(intervals));
  }
  return knots;
}

}  // namespace

std::vector<MeshPhase> first_mesh(const std::vector<Stance>& stances, const PlanOptions& options) {
  double shares = 0.0;
  for (std::size_t p = 0; p < stances.size(); ++p) shares += kind_of(stances, p).share;
  std::vector<MeshPhase> mesh;
  for (std::size_t p = 0; p < stances.size(); ++p) {
    const Kind kind = kind_of(stances, p);
    const auto intervals =
        static_cast<std::size_t>(std::lround(options.intervals * kind.share / shares));
    mesh.push_back({stances[p], even_knots(std::max(kFewestIntervals, intervals)),
                    kind.duration_s});
  }
  return mesh;
}

PlanGoal plan_goal(const PlanModel& model, const PlanOptions& options) {
  PlanGoal goal;
  if (options.task == PlanTask::kFlip) goal.turn_rad = 2.0 * std::numbers::pi;
  if (options.task == PlanTask::kJump) goal.stride_m = 0.0;
  if (options.task == PlanTask::kHop) goal.stride_m = options.stride_m;
  if (options.task != PlanTask::kFlip) goal.rise_m = options.rise_m;
  for (const Bounds& range : model.joint_rad) {
    const double quarter = 0.25 * (range.upper - range.lower);
    goal.standing_rad.push_back({range.lower + quarter, range.upper - quarter});
  }
  for (const Posture& posture : model.plane.robot.postures) {
    if (posture.name != "stand") continue;
    for (std::size_t i = 0; i + 1 < model.plane.joints.size(); ++i) {
      const double rad = posture.joints[static_cast<Index>(model.plane.joints[i]) - 1];
      goal.standing_rad[i] = {rad, rad};
    }
    goal.standing_rad.back() = model.joint_rad.back();
  }
  return goal;
}

std::vector<Stance> plan_stances(const SagittalRobot& plane, const PlanOptions& options) {
  if (!options.stances.empty()) return stances_of(plane, options.stances);
  if (plane.sole.size() > 1 && options.task == PlanTask::kFlip) {
    return stances_of(plane, {"flat", "heel", "flight", "heel", "flat"});
  }
  return stances_of(plane, {"flat", "flight", "flat"});
}

}  // namespace torquewright::hopper
