// SPDX-License-Identifier: Apache-2.0
#include "identification/robot_plan/motion_room.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "actuator/region/joint_region.hpp"
#include "actuator/region/operating_conditions.hpp"
#include "dynamics/point.hpp"
#include "identification/log/delayed.hpp"
#include "identification/rollout/rollout.hpp"
#include "identification/simulated/rig_plant.hpp"
#include "io/faults/refusal.hpp"

namespace torquewright::identification {
namespace {

constexpr double kStep_s = 1e-3;           ///< Of integration.
constexpr std::size_t kLookedAt = 2;       ///< Samples from one that is looked at to the next.
constexpr double kLeastRange_rad = 0.02;   ///< To a joint's limit.
constexpr double kLeastTorqueShare = 0.1;  ///< Of a drive's region.
constexpr double kLeastSpeedShare = 0.05;
constexpr double kLeastGap_m = 0.01;

/// Positions and speeds of all joints as the robot's own loops move them.
struct Simulated {
  std::vector<std::vector<double>> position_rad, speed_rad_s;  ///< By joint.
};

std::vector<double> slopes_of(const std::vector<double>& values) {
  std::vector<double> slopes(values.size(), 0.0);
  for (std::size_t i = 1; i + 1 < values.size(); ++i) {
    slopes[i] = (values[i + 1] - values[i - 1]) / (2.0 * kCommandStep_s);
  }
  return slopes;
}

/// From the second sample on, where a window begins.
Simulated simulated(const RobotModel& model, const Run& run) {
  Simulated all;
  all.position_rad.resize(model.drives.size());
  all.speed_rad_s.resize(model.drives.size());
  const Window whole{0, 1, run.time_s.size() - 2};
  for (const Limb& limb : limbs_of(model.load)) {
    const auto off_rad = limb_errors_rad(model, limb, run, whole, kStep_s);
    if (off_rad.empty()) {
      io::refuse("--rig",
                 "the robot under the controllers of the rig grows without bound in the "
                 "simulation; their gains or the drives' inertia are not the robot's");
    }
    for (std::size_t i = 0; i < limb.joints.size(); ++i) {
      const std::size_t joint = limb.joints[i];
      std::vector<double> position = off_rad[i];
      for (std::size_t k = 0; k < position.size(); ++k) {
        position[k] +=
            model.offset_rad[joint] + run.joints[joint][Quantity::kOutputPosition][whole.first + k];
      }
      all.speed_rad_s[joint] = slopes_of(position);
      all.position_rad[joint] = std::move(position);
    }
  }
  return all;
}

/// Keeps the least that is left.
void keep(Room& room, double left, const std::string& place) {
  if (left < room.left) room = {left, place};
}

/// Goes through one motion with all that limits it.
class MotionCheck {
 public:
  MotionCheck(const RobotModel& model, const hopper::Robot& robot, const MotionLimits& limits,
              const CommandedMotion& motion)
      : model_(model),
        robot_(robot),
        limits_(limits),
        motion_(motion),
        load_(*model.load.robot),
        run_(log_of({motion}).runs.front()),
        simulated_(simulated(model, run_)) {
    result_.goes_too_far.assign(model.drives.size(), false);
  }

  RoomOfMotion run() {
    for (std::size_t joint = 0; joint < model_.drives.size(); ++joint) check_joint(joint);
    check_bodies();
    return std::move(result_);
  }

 private:
  const dynamics::Joint& joint_of(std::size_t joint) const {
    return load_.tree.bodies[load_.bodies[joint]].joint;
  }

  void check_joint(std::size_t joint) {
    const dynamics::Joint& own = joint_of(joint);
    const actuator::Region region(model_.drives[joint], {});
    const JointController& controller = model_.controllers[joint];
    const std::vector<double> command =
        delayed(run_.time_s, run_.joints[joint][Quantity::kCommandedPosition], controller.delay_s);
    const double fastest_rad_s = std::min(own.limits.speed_max, limits_.speed_rad_s);
    double range_rad = std::numeric_limits<double>::infinity(), speed_share = 1.0,
           torque_share = 1.0;
    for (std::size_t k = 0; k < simulated_.position_rad[joint].size(); k += kLookedAt) {
      const double at_rad = simulated_.position_rad[joint][k];
      const double speed_rad_s = simulated_.speed_rad_s[joint][k];
      range_rad =
          std::min({range_rad, own.limits.position_max - at_rad, at_rad - own.limits.position_min,
                    limits_.from_start_rad - std::abs(at_rad - motion_.joints[joint].centre_rad)});
      speed_share = std::min(speed_share, 1.0 - std::abs(speed_rad_s) / fastest_rad_s);
      const double torque_Nm = controller.law.torque_Nm(command[k + 1], at_rad, speed_rad_s);
      torque_share = std::min(torque_share, left_of(region, speed_rad_s, torque_Nm));
    }
    keep(result_.room.position_rad, range_rad, own.name);
    if (std::isfinite(fastest_rad_s)) keep(result_.room.speed_share, speed_share, own.name);
    keep(result_.room.torque_share, torque_share, own.name);
    if (range_rad < kLeastRange_rad || speed_share < kLeastSpeedShare ||
        torque_share < kLeastTorqueShare)
      result_.goes_too_far[joint] = true;
  }

  /// The share of what a drive gives that a torque leaves.
  static double left_of(const actuator::Region& region, double speed_rad_s, double torque_Nm) {
    const actuator::JointRange range = region.at(speed_rad_s);
    if (range.is_empty) return -1.0;
    const double bound_Nm = torque_Nm < 0.0 ? range.least.torque_Nm : range.greatest.torque_Nm;
    if (!(torque_Nm * bound_Nm > 0.0)) return torque_Nm == 0.0 ? 1.0 : -1.0;
    return 1.0 - torque_Nm / bound_Nm;
  }

  void check_bodies() {
    if (robot_.spheres.empty() && !limits_.base_height_m) return;
    dynamics::TreeState state(robot_tree_of(model_.load));
    Eigen::VectorXd position = held_positions_of(model_.load);
    const Eigen::VectorXd at_rest = Eigen::VectorXd::Zero(position.size());
    for (std::size_t k = 0; k < simulated_.position_rad.front().size(); k += kLookedAt) {
      for (std::size_t joint = 0; joint < load_.bodies.size(); ++joint) {
        position[static_cast<Eigen::Index>(load_.bodies[joint]) - 1] =
            simulated_.position_rad[joint][k];
      }
      state.set(position, at_rest);
      check_spheres(state);
      if (limits_.base_height_m) check_ground(state);
    }
  }

  void check_spheres(const dynamics::TreeState& state) {
    for (std::size_t i = 0; i < robot_.spheres.size(); ++i) {
      for (std::size_t j = i + 1; j < robot_.spheres.size(); ++j) {
        const hopper::CollisionSphere& one = robot_.spheres[i];
        const hopper::CollisionSphere& other = robot_.spheres[j];
        if (are_joined(one.center.body, other.center.body)) continue;
        const double gap_m = (dynamics::point_position_m(state, one.center) -
                              dynamics::point_position_m(state, other.center))
                                 .norm() -
                             one.radius_m - other.radius_m;
        keep(result_.room.bodies_m, gap_m,
             fmt::format("{} and {}", name_of(one.center.body), name_of(other.center.body)));
        if (gap_m >= kLeastGap_m) continue;
        hold_back(one.center.body);
        hold_back(other.center.body);
      }
    }
  }

  void check_ground(const dynamics::TreeState& state) {
    const auto check = [&](const dynamics::BodyPoint& point, double radius_m) {
      const double height_m =
          *limits_.base_height_m +
          (dynamics::point_position_m(state, point) - state.motion(0).origin_m).z() - radius_m;
      keep(result_.room.ground_m, height_m, name_of(point.body));
      if (height_m < kLeastGap_m) hold_back(point.body);
    };
    for (const hopper::CollisionSphere& each : robot_.spheres) check(each.center, each.radius_m);
    for (const hopper::ContactPoint& each : robot_.contacts) check(each.point, each.radius_m);
  }

  bool are_joined(std::size_t one, std::size_t other) const {
    const auto carries = [&](std::size_t parent, std::size_t child) {
      return child > 0 && load_.tree.bodies[child].parent == parent;
    };
    return one == other || carries(one, other) || carries(other, one);
  }

  const std::string& name_of(std::size_t body) const { return load_.tree.bodies[body].name; }

  /// All joints between the base and a body.
  void hold_back(std::size_t body) {
    for (; body > 0; body = load_.tree.bodies[body].parent) {
      const auto found = std::find(load_.bodies.begin(), load_.bodies.end(), body);
      if (found == load_.bodies.end()) continue;
      result_.goes_too_far[static_cast<std::size_t>(found - load_.bodies.begin())] = true;
    }
  }

  const RobotModel& model_;
  const hopper::Robot& robot_;
  const MotionLimits& limits_;
  const CommandedMotion& motion_;
  const RobotLoad& load_;
  const Run run_;
  const Simulated simulated_;
  RoomOfMotion result_;
};

}  // namespace

RoomOfMotion room_of(const RobotModel& model, const hopper::Robot& robot,
                     const MotionLimits& limits, const CommandedMotion& motion) {
  return MotionCheck(model, robot, limits, motion).run();
}

}  // namespace torquewright::identification
