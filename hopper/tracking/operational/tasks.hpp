// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// What a task moves as the motion moves it.
enum class TaskKind {
  kCenterOfMass,  ///< Of all bodies, along the world's axes, from the feet that stand.
  kBaseAttitude,  ///< About the axes of the base.
  kPoint,         ///< A contact point while it is not to touch, from the centre of mass.
  kJoint,
};
std::string_view name_of(TaskKind kind);

/// When a task is active.
enum class TaskTime { kAlways, kStance, kFlight };

/// Acceleration wanted: the motion's, and stiffness and damping times the errors of place and rate.
struct OperationalTask {
  TaskKind kind = TaskKind::kCenterOfMass;
  std::size_t of = 0;  ///< Contact of a point, body that a joint carries; else without meaning.
  std::array<bool, 3> along = {true, true, true};  ///< Axes; of a joint without meaning.
  TaskTime when = TaskTime::kAlways;
  double weight = 1.0;  ///< Of its residual's square, in (m/s^2)^-2 or (rad/s^2)^-2.
  double frequency_rad_s = 10.0;
  double damping_ratio = 1.0;

  double stiffness_1_s2() const { return frequency_rad_s * frequency_rad_s; }
  double damping_1_s() const { return 2.0 * damping_ratio * frequency_rad_s; }
};

/// A spring that the controller takes for rigid: a joint of the tree by the body that it carries,
/// or behind those a link of a loop that follows (WholeBody::links()).
struct RigidJoint {
  bool is_link = false;
  std::size_t of = 0;
};

/// What operational-space control weighs, and against what.
struct OperationalTasks {
  std::string name;
  std::vector<OperationalTask> tasks;
  std::vector<RigidJoint> rigid;
  double contact_weight = 1000.0;  ///< Of accelerations of points that are to stand.
  double contact_time_s = 0.05;    ///< In which such points come to rest.
  /// Time constant of the low-pass through which rates of rigid springs are fed back; 0: they are
  /// not.
  double rigid_rate_time_s = 0.0;
  /// Price of each drive's peak torque, as a residual of so many m/s^2 of weight 1, and of the
  /// robot's weight as a force on a contact.
  double effort_weight = 0.01;
  /// Of each contact's friction: the pyramid lies inside the cone of that share.
  double friction_share = 0.9;
};

/// What a robot is controlled by for which no document says otherwise: its centre of mass while it
/// stands, its base, all driven joints a little while it stands and much while it flies; springs
/// without a drive are rigid.
OperationalTasks usual_tasks(const Robot& robot);

/// Its kind and what it is of, in words.
std::string words_of(const OperationalTask& task, const Robot& robot);

}  // namespace torquewright::hopper
