// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/planning/plane/sagittal_robot.hpp"
#include "robot/model/whole_body.hpp"

namespace torquewright::hopper {

/// A point of the sole and the force or impulse of the ground on it, in N or N s along x and z.
template <typename T>
struct SoleForceOf {
  std::size_t sole_point = 0;
  T x{0.0};
  T z{0.0};
};

/// The equations of motion in the plane, on any scalar for which dynamics/ stands. Vectors of what
/// moves by SagittalRobot::moving, in a frame. On its place nothing depends but places of points.
/// Keeps its room: for one thread. A mechanism that does not reach a posture makes numbers that are
/// not finite: a solver steps back from there.
template <typename T>
class SagittalDynamicsOf {
 public:
  explicit SagittalDynamicsOf(const SagittalRobot& robot);

  /// Sets a frame's robot to a position and a velocity (moving x 1 each).
  void set(PlanFrame frame, const dynamics::VectorX<T>& position,
           const dynamics::VectorX<T>& velocity);
  /// Returns the position of the same instant in the other frame (moving x 1).
  dynamics::VectorX<T> position_in(PlanFrame frame) const;
  dynamics::VectorX<T> velocity_in(PlanFrame frame) const;

  /// Returns M a + h + rotors - A^T drives - J^T forces, by moving row, then by held row: 0 in a
  /// motion.
  dynamics::VectorX<T> residual(const dynamics::VectorX<T>& acceleration,
                                const dynamics::VectorX<T>& drive_Nm,
                                const std::vector<SoleForceOf<T>>& forces);
  /// Returns M change - J^T impulses, by moving row: 0 across an impact. Held rows belong to the
  /// ground. Only where the state was set about the sole, whose velocities change.
  dynamics::VectorX<T> impact_residual(const dynamics::VectorX<T>& change,
                                       const std::vector<SoleForceOf<T>>& impulses);
  /// Returns x and z of a point of the robot.
  Eigen::Matrix<T, 2, 1> place_m(const dynamics::BodyPoint& point) const;
  Eigen::Matrix<T, 2, 1> velocity_m_s(const dynamics::BodyPoint& point) const;
  Eigen::Matrix<T, 2, 1> acceleration_m_s2(const dynamics::BodyPoint& point,
                                           const dynamics::VectorX<T>& acceleration);
  const SagittalRobot& robot() const { return *robot_; }

 private:
  /// Returns rows of the tree from rows of the foot and joints, with the base's place and motion at
  /// 0.
  dynamics::VectorX<T> unplaced(const dynamics::VectorX<T>& moving) const;
  /// The same with the base's acceleration such that the frame's origin accelerates as asked.
  dynamics::VectorX<T> accelerated(const dynamics::VectorX<T>& acceleration);
  /// Returns the place of a frame's origin, in m, with the base's own place and velocity at 0.
  Eigen::Matrix<T, 2, 1> origin_m(PlanFrame frame) const;
  Eigen::Matrix<T, 2, 1> origin_m_s(PlanFrame frame) const;
  T turned(const dynamics::VectorX<T>& moving) const;
  const dynamics::TreeStateOf<T>& state() const { return body_.state(); }
  dynamics::VectorX<T> picked(const dynamics::VectorX<T>& rows, bool with_held) const;
  void subtract(const std::vector<SoleForceOf<T>>& forces, dynamics::VectorX<T>& rows) const;

  const SagittalRobot* robot_;
  WholeBodyOf<T> body_;
  bool is_reached_ = true;
  PlanFrame frame_ = PlanFrame::kSole;
  dynamics::VectorX<T> position_;  ///< Position as it was set.
  dynamics::VectorX<T> velocity_;
  Eigen::Matrix<T, 2, 1> base_m_;    ///< Where the base is, and how it moves: set() leaves the
  Eigen::Matrix<T, 2, 1> base_m_s_;  ///< tree's own at 0.
};

/// How drives move with the joints: A, and its rates. For drives and limits, which depend on joints
/// alone.
template <typename T>
struct DriveMotionOf {
  dynamics::VectorX<T> speed_rad_s;          ///< (drives x 1)
  dynamics::VectorX<T> acceleration_rad_s2;  ///< (drives x 1)
  dynamics::VectorX<T> joint_Nm;  ///< Torques of the joints that move, made by the drives.
};

/// Returns the motion of every drive's output from that of the joints that move, with the drives'
/// torques (drives x 1). Not finite where a mechanism does not reach.
template <typename T>
DriveMotionOf<T> drive_motion(const SagittalRobot& robot, const dynamics::VectorX<T>& joint_rad,
                              const dynamics::VectorX<T>& joint_rad_s,
                              const dynamics::VectorX<T>& joint_rad_s2,
                              const dynamics::VectorX<T>& drive_Nm);

}  // namespace torquewright::hopper
