// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/programme/standing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "dynamics/momentum.hpp"
#include "io/faults/refusal.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using optimization::Bounds;

constexpr int kSteps = 400;        // of the balancing joint's range
constexpr double kPostures = 2e4;  // looked at where several joints are free, about

double within(const Bounds& range, int i, int steps) {
  return range.lower + (range.upper - range.lower) * i / steps;
}

/// How far the mass is in front of the sole's middle.
class Lean {
 public:
  explicit Lean(const PlanModel& model) : model_(model), state_(model.plane.robot.tree) {}

  double m(const VectorXd& joint_rad) {
    VectorXd moving(model_.plane.moving_count());
    moving << 0.0, 0.0, standing_foot_rad(model_.plane, joint_rad), joint_rad;
    const VectorXd at = model_.plane.all_rows(moving);
    const VectorXd still = VectorXd::Zero(at.size());
    state_.set(tree_motion(model_.plane, PlanFrame::kSole, {at, still, still}).position, still);
    return dynamics::centroid(state_).position_m.x() - 0.5 * model_.foot_length_m;
  }

 private:
  const PlanModel& model_;
  dynamics::TreeState state_;
};

/// Over a box of postures. It is continuous: whatever lies between is the lean of one of them.
Bounds leans_m(const PlanModel& model, const std::vector<Bounds>& joint_rad) {
  const auto is_free = [](const Bounds& range) { return range.upper > range.lower; };
  const auto free = std::count_if(joint_rad.begin(), joint_rad.end(), is_free);
  const int steps =
      free > 1 ? static_cast<int>(std::pow(kPostures, 1.0 / static_cast<double>(free))) : kSteps;
  Lean lean(model);
  std::vector<int> at(joint_rad.size(), 0);
  VectorXd posture(static_cast<Index>(joint_rad.size()));
  Bounds out{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (std::size_t carry = 0; carry < at.size();) {
    for (std::size_t i = 0; i < at.size(); ++i) {
      posture[static_cast<Index>(i)] = within(joint_rad[i], at[i], steps);
    }
    const double here_m = lean.m(posture);
    out = {std::min(out.lower, here_m), std::max(out.upper, here_m)};
    for (carry = 0; carry < at.size(); at[carry++] = 0) {
      if (is_free(joint_rad[carry]) && ++at[carry] <= steps) break;
    }
  }
  return out;
}

}  // namespace

std::size_t balancing_joint(const SagittalRobot& plane) {
  return plane.sole.size() == 1 ? 0 : plane.joints.size() - 1;
}

double standing_foot_rad(const SagittalRobot& plane, const VectorXd& joint_rad) {
  if (plane.sole.size() > 1) return 0.0;
  double turned_rad = 0.0;
  for (std::size_t i = 0; i < plane.directions.size(); ++i) {
    turned_rad += plane.directions[i] * joint_rad[static_cast<Index>(i)];
  }
  return turned_rad;
}

VectorXd balanced(const PlanModel& model, VectorXd joint_rad) {
  const std::size_t joint = balancing_joint(model.plane);
  Lean lean(model);
  VectorXd best = joint_rad;
  double least_m = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= kSteps; ++i) {
    joint_rad[static_cast<Index>(joint)] = within(model.joint_rad[joint], i, kSteps);
    const double lean_m = std::abs(lean.m(joint_rad));
    if (lean_m < least_m) {
      least_m = lean_m;
      best = joint_rad;
    }
  }
  return best;
}

void require_standing(const PlanModel& model, const PlanGoal& goal) {
  const Robot& robot = model.plane.robot;
  for (std::size_t i = 0; i < goal.standing_rad.size(); ++i) {
    const Bounds& stands = goal.standing_rad[i];
    const Bounds& range = model.joint_rad[i];
    if (stands.lower <= stands.upper && stands.lower >= range.lower &&
        stands.upper <= range.upper) {
      continue;
    }
    io::refuse(robot.name,
               fmt::format("cannot stand: joint '{}' would be at {:.4g} rad, and what it reaches, "
                           "margins taken off, is {:.4g} to {:.4g} rad",
                           robot.tree.bodies[model.plane.joints[i]].joint.name, stands.lower,
                           range.lower, range.upper));
  }
  const Bounds lean_m = leans_m(model, goal.standing_rad);
  const double most_m = kStandsWithin * model.foot_length_m;
  if (lean_m.lower <= most_m && lean_m.upper >= -most_m) return;
  io::refuse(
      robot.name,
      fmt::format("cannot stand: wherever joint '{}' is, its centre of mass is at least "
                  "{:.3g} m {} the middle of its foot (posture \"stand\")",
                  robot.tree.bodies[model.plane.joints[balancing_joint(model.plane)]].joint.name,
                  std::min(std::abs(lean_m.lower), std::abs(lean_m.upper)),
                  lean_m.lower > 0.0 ? "in front of" : "behind"));
}

}  // namespace torquewright::hopper
