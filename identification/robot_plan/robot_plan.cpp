// SPDX-License-Identifier: Apache-2.0
#include "identification/robot_plan/robot_plan.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "identification/robot_plan/motion_information.hpp"
#include "io/faults/refusal.hpp"
#include "io/text/wording.hpp"

namespace torquewright::identification {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kWidest_rad = 1.0;  ///< Of a joint that has no limits, to each side.
constexpr double kOfRange = 0.9;     ///< Of what is left to a joint's limit.
constexpr double kShrink = 0.8;
constexpr int kMostShrinking = 30;
constexpr double kLeastReach_rad = 0.02;
constexpr double kNothingKnown =
    1e-9;  ///< In squared sizes, so that what nothing shows has an end.
constexpr double kStandsFor = 0.9;

/// A limb's values, and what the runs that are planned say of them.
struct LimbPlan {
  std::vector<FreeValue> values;
  MatrixXd information, by_sweep;  ///< (values x values), with what was known before.
};

bool is_of(const Limb& limb, const FreeValue& value) {
  return !value.is_of_all() &&
         std::find(limb.joints.begin(), limb.joints.end(), value.joint) != limb.joints.end();
}

double log_determinant(const MatrixXd& information) {
  return 2.0 * information.llt().matrixLLT().diagonal().array().log().sum();
}

void keep_least(Room& room, const Room& other) {
  if (other.left < room.left) room = other;
}

void keep_least(MotionRoom& room, const MotionRoom& other) {
  keep_least(room.position_rad, other.position_rad);
  keep_least(room.speed_share, other.speed_share);
  keep_least(room.torque_share, other.torque_share);
  keep_least(room.bodies_m, other.bodies_m);
  keep_least(room.ground_m, other.ground_m);
}

/// What is left of everything that limits a motion.
std::string words_of(const MotionRoom& room) {
  std::vector<std::string> words;
  const auto add = [&](const Room& one, const char* what) {
    if (std::isfinite(one.left))
      words.push_back(fmt::format("{:.3g} {} ({})", one.left, what, one.place));
  };
  add(room.ground_m, "m are left to the ground");
  add(room.bodies_m, "m between bodies");
  add(room.position_rad, "rad to a joint's limit");
  add(room.torque_share, "of a drive's torque");
  return io::listed(words);
}

class Planner {
 public:
  Planner(const RobotModel& stated, const hopper::Robot& robot,
          const std::vector<double>& centre_rad, const RobotPlanOptions& options)
      : model_(stated), robot_(robot), centre_rad_(centre_rad), options_(options) {
    add_plain_friction(model_);
    std::vector<FreeValue> values = free_values(model_);
    for (FreeValue& each : controller_values(model_)) values.push_back(std::move(each));
    for (FreeValue& each : body_values(model_)) values.push_back(std::move(each));
    for (const Limb& limb : limbs_of(model_.load)) {
      LimbPlan& own = limbs_.emplace_back();
      std::copy_if(values.begin(), values.end(), std::back_inserter(own.values),
                   [&](const FreeValue& each) { return is_of(limb, each); });
      own.information = known_before(own.values).asDiagonal();
      own.information.diagonal().array() += kNothingKnown;
      own.by_sweep = own.information;
    }
    require_room_to_stand();
  }

  RobotPlan run(const std::function<void(double)>& on_progress) {
    std::mt19937_64 random(options_.seed);
    const auto all = static_cast<double>(options_.runs.size() * (options_.candidates + 1));
    const auto show = [&] {
      if (on_progress) on_progress(static_cast<double>(plan_.tried) / all);
    };
    for (const std::string& name : options_.runs) {
      CommandedMotion sweeping = motion_at_centre(name);
      sweep(sweeping);
      add_to(&LimbPlan::by_sweep, informations(within_limits(std::move(sweeping)).first));
      show();
      add_best_of_drawn(name, random, show);
    }
    for (LimbPlan& limb : limbs_) tell(limb);
    return std::move(plan_);
  }

 private:
  CommandedMotion motion_at_centre(const std::string& run) const {
    CommandedMotion motion;
    motion.run = run;
    motion.duration_s = options_.duration_s / static_cast<double>(options_.runs.size());
    for (std::size_t joint = 0; joint < centre_rad_.size(); ++joint) {
      const dynamics::JointLimits& limits =
          model_.load.robot->tree.bodies[model_.load.robot->bodies[joint]].joint.limits;
      const double centre = centre_rad_[joint];
      const double room = std::min({limits.position_max - centre, centre - limits.position_min,
                                    options_.limits.from_start_rad, kWidest_rad / kOfRange});
      motion.joints.push_back({centre, kOfRange * room, {}});
    }
    return motion;
  }

  /// Nobody moves about a place where nobody can stand.
  void require_room_to_stand() const {
    CommandedMotion still = motion_at_centre("");
    for (JointCommand& each : still.joints) each.reach_rad = 0.0;
    still.duration_s = std::min(2.0, still.duration_s);
    const RoomOfMotion standing = room_of(model_, robot_, options_.limits, still);
    const auto& too_far = standing.goes_too_far;
    if (std::find(too_far.begin(), too_far.end(), true) == too_far.end()) return;
    io::refuse("--posture",
               fmt::format("the robot cannot stand where its motion is to begin: {}; name another "
                           "posture, or a greater --base-height",
                           words_of(standing.room)));
  }

  const std::string& joint_name(std::size_t joint) const {
    return model_.load.robot->joints[joint].name;
  }

  /// Takes reach from the joints that go too far until none does.
  std::pair<CommandedMotion, MotionRoom> within_limits(CommandedMotion motion) {
    ++plan_.tried;
    for (int round = 0; round < kMostShrinking; ++round) {
      const RoomOfMotion found = room_of(model_, robot_, options_.limits, motion);
      bool is_within = true;
      for (std::size_t joint = 0; joint < motion.joints.size(); ++joint) {
        if (!found.goes_too_far[joint]) continue;
        is_within = false;
        motion.joints[joint].reach_rad *= kShrink;
        if (motion.joints[joint].reach_rad < kLeastReach_rad) refuse_joint(joint);
      }
      if (is_within) return {std::move(motion), found.room};
    }
    io::refuse("--posture", "no motion about it keeps within the robot's limits");
  }

  [[noreturn]] void refuse_joint(std::size_t joint) const {
    io::refuse("--posture",
               fmt::format("{} cannot move by {} rad about where it begins ({:.4g} rad) within its "
                           "limits, its drive's region and clear of bodies and ground",
                           joint_name(joint), kLeastReach_rad, centre_rad_[joint]));
  }

  /// By limb; empty where a simulation grows without bound.
  std::vector<MatrixXd> informations(const CommandedMotion& motion) const {
    std::vector<MatrixXd> all;
    for (std::size_t limb = 0; limb < limbs_.size(); ++limb) {
      all.push_back(
          information_of(model_, limb, limbs_[limb].values, motion, options_.position_noise_rad));
      if (all.back().size() == 0 && !limbs_[limb].values.empty()) return {};
    }
    return all;
  }

  void add_to(MatrixXd LimbPlan::*which, const std::vector<MatrixXd>& all) {
    for (std::size_t limb = 0; limb < all.size(); ++limb) limbs_[limb].*which += all[limb];
  }

  double score_with(const std::vector<MatrixXd>& all) const {
    double score = 0.0;
    for (std::size_t limb = 0; limb < all.size(); ++limb)
      score += log_determinant(limbs_[limb].information + all[limb]);
    return score;
  }

  void add_best_of_drawn(const std::string& name, std::mt19937_64& random,
                         const std::function<void()>& show) {
    std::optional<CommandedMotion> best;
    std::vector<MatrixXd> best_adds;
    MotionRoom best_room;
    for (std::size_t k = 0; k < options_.candidates; ++k) {
      CommandedMotion drawn = motion_at_centre(name);
      draw_waves(drawn, random);
      auto [motion, room] = within_limits(std::move(drawn));
      std::vector<MatrixXd> adds = informations(motion);
      show();
      if (adds.empty() || (best && score_with(adds) <= score_with(best_adds))) continue;
      best = std::move(motion);
      best_adds = std::move(adds);
      best_room = room;
    }
    if (!best) io::refuse("--rig", "every motion that was drawn grows without bound");
    add_to(&LimbPlan::information, best_adds);
    plan_.motions.push_back(std::move(*best));
    keep_least(plan_.room, best_room);
  }

  FittedValue expected(const FreeValue& which, double standard_error) const {
    FittedValue value;
    value.which = which;
    value.stated = value.value = value_in(model_, which);
    value.standard_error = standard_error * which.size;
    return value;
  }

  void tell(const LimbPlan& limb) {
    const auto n = static_cast<Index>(limb.values.size());
    const MatrixXd one = MatrixXd::Identity(n, n);
    const MatrixXd covariance = limb.information.ldlt().solve(one);
    const VectorXd sweep_error = limb.by_sweep.ldlt().solve(one).diagonal().cwiseSqrt();
    const VectorXd error = covariance.diagonal().cwiseSqrt();
    for (Index k = 0; k < n; ++k) {
      const FreeValue& which = limb.values[static_cast<std::size_t>(k)];
      PlannedValue& planned = plan_.values.emplace_back();
      planned.by_plan = expected(which, error[k]);
      planned.by_sweep = expected(which, sweep_error[k]);
      double greatest = kStandsFor;
      for (Index other = 0; other < n; ++other) {
        const double correlation = std::abs(covariance(k, other)) / (error[k] * error[other]);
        if (other == k || correlation <= greatest) continue;
        greatest = correlation;
        planned.stands_for_it = limb.values[static_cast<std::size_t>(other)];
      }
    }
  }

  RobotModel model_;
  const hopper::Robot& robot_;
  const std::vector<double>& centre_rad_;
  const RobotPlanOptions& options_;
  std::vector<LimbPlan> limbs_;
  RobotPlan plan_;
};

}  // namespace

bool RobotPlan::tells_all() const {
  return std::all_of(values.begin(), values.end(),
                     [](const PlannedValue& each) { return each.by_plan.is_told(); });
}

RobotPlan plan_robot(const RobotModel& stated, const hopper::Robot& robot,
                     const std::vector<double>& centre_rad, const RobotPlanOptions& options,
                     const std::function<void(double share)>& on_progress) {
  return Planner(stated, robot, centre_rad, options).run(on_progress);
}

}  // namespace torquewright::identification
