// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/plane/sagittal_dynamics.hpp"

#include <limits>

#include "dynamics/inverse_dynamics.hpp"
#include "dynamics/jet.hpp"
#include "dynamics/jet_functions.hpp"
#include "dynamics/passive_forces.hpp"
#include "dynamics/point.hpp"

namespace torquewright::hopper {

using dynamics::BodyPoint;
using dynamics::VectorX;
using Eigen::Index;

namespace {

/// Dry friction of joints turns from one way to the other over some of this speed: fast against a
/// jump's 10 rad/s, slow against the instants of a mesh. A choice of ours.
constexpr double kFrictionWidth_rad_s = 0.05;

constexpr double kNotReached = std::numeric_limits<double>::quiet_NaN();

template <typename T>
Eigen::Matrix<T, 2, 1> in_plane(const dynamics::Vector3<T>& vector) {
  return {vector.x(), vector.z()};
}

}  // namespace

template <typename T>
SagittalDynamicsOf<T>::SagittalDynamicsOf(const SagittalRobot& robot)
    : robot_(&robot), body_(robot.robot) {}

template <typename T>
T SagittalDynamicsOf<T>::turned(const VectorX<T>& moving) const {
  T sum(0.0);
  for (std::size_t i = 0; i < robot_->joints.size(); ++i) {
    sum += robot_->directions[i] * moving[3 + static_cast<Index>(i)];
  }
  return sum;
}

template <typename T>
VectorX<T> SagittalDynamicsOf<T>::unplaced(const VectorX<T>& moving) const {
  VectorX<T> rows = VectorX<T>::Zero(robot_->robot.tree.velocity_size());
  rows[2] = moving[2];
  if (frame_ == PlanFrame::kSole) rows[2] -= turned(moving);
  for (std::size_t i = 3; i < robot_->moving.size(); ++i) {
    rows[robot_->moving[i]] = moving[static_cast<Index>(i)];
  }
  return rows;
}

template <typename T>
Eigen::Matrix<T, 2, 1> SagittalDynamicsOf<T>::origin_m(PlanFrame frame) const {
  if (frame == PlanFrame::kSole) {
    return in_plane<T>(dynamics::point_position_m(state(), robot_->sole.front().point));
  }
  Eigen::Matrix<T, 2, 1> sum = Eigen::Matrix<T, 2, 1>::Zero();
  for (std::size_t i = 0; i < robot_->robot.tree.bodies.size(); ++i) {
    const dynamics::RigidInertia& body = robot_->robot.tree.bodies[i].inertia;
    sum += (body.mass_kg / robot_->mass_kg) *
           in_plane<T>(dynamics::point_position_m(state(), {i, body.center_of_mass_m}));
  }
  return sum;
}

template <typename T>
Eigen::Matrix<T, 2, 1> SagittalDynamicsOf<T>::origin_m_s(PlanFrame frame) const {
  if (frame == PlanFrame::kSole) {
    return in_plane<T>(dynamics::point_velocity_m_s(state(), robot_->sole.front().point));
  }
  Eigen::Matrix<T, 2, 1> sum = Eigen::Matrix<T, 2, 1>::Zero();
  for (std::size_t i = 0; i < robot_->robot.tree.bodies.size(); ++i) {
    const dynamics::RigidInertia& body = robot_->robot.tree.bodies[i].inertia;
    sum += (body.mass_kg / robot_->mass_kg) *
           in_plane<T>(dynamics::point_velocity_m_s(state(), {i, body.center_of_mass_m}));
  }
  return sum;
}

template <typename T>
VectorX<T> SagittalDynamicsOf<T>::accelerated(const VectorX<T>& acceleration) {
  VectorX<T> rows = unplaced(acceleration);
  Eigen::Matrix<T, 2, 1> relative;
  if (frame_ == PlanFrame::kSole) {
    const BodyPoint& rear = robot_->sole.front().point;
    Eigen::Matrix<T, 3, Eigen::Dynamic> jacobian(3, rows.size());
    dynamics::point_jacobian(state(), rear, jacobian);
    const dynamics::Vector3<T> sum =
        jacobian * rows + dynamics::point_bias_acceleration_m_s2(state(), rear);
    relative = in_plane<T>(sum);
  } else {
    // Newton's law of the whole tells how its mass accelerates.
    VectorX<T> force(rows.size());
    dynamics::inverse_dynamics(body_.state(), rows, force);
    relative << force[0] * (1.0 / robot_->mass_kg),
        force[1] * (1.0 / robot_->mass_kg) - robot_->robot.tree.gravity_m_s2;
  }
  rows.template head<2>() = acceleration.template head<2>() - relative;
  return rows;
}

template <typename T>
VectorX<T> SagittalDynamicsOf<T>::position_in(PlanFrame frame) const {
  VectorX<T> out = position_;
  out.template head<2>() = base_m_ + origin_m(frame);
  if (frame != frame_) {
    out[2] += frame == PlanFrame::kSole ? turned(position_) : -turned(position_);
  }
  return out;
}

template <typename T>
VectorX<T> SagittalDynamicsOf<T>::velocity_in(PlanFrame frame) const {
  VectorX<T> out = velocity_;
  out.template head<2>() = base_m_s_ + origin_m_s(frame);
  if (frame != frame_) {
    out[2] += frame == PlanFrame::kSole ? turned(velocity_) : -turned(velocity_);
  }
  return out;
}

template <typename T>
VectorX<T> SagittalDynamicsOf<T>::picked(const VectorX<T>& rows, bool with_held) const {
  const Index held = with_held ? static_cast<Index>(robot_->held.size()) : 0;
  const Index moving = robot_->moving_count();
  VectorX<T> out(moving + held);
  for (Index i = 0; i < moving; ++i) out[i] = rows[robot_->moving[static_cast<std::size_t>(i)]];
  for (Index i = 0; i < held; ++i) {
    out[moving + i] = rows[robot_->held[static_cast<std::size_t>(i)]];
  }
  if (!is_reached_) out[0] = T(kNotReached);
  return out;
}

template <typename T>
void SagittalDynamicsOf<T>::set(PlanFrame frame, const VectorX<T>& position,
                                const VectorX<T>& velocity) {
  frame_ = frame;
  position_ = position;
  velocity_ = velocity;
  is_reached_ = body_.set(unplaced(position), unplaced(velocity));
  base_m_ = position.template head<2>() - origin_m(frame);
  base_m_s_ = velocity.template head<2>() - origin_m_s(frame);
}

template <typename T>
void SagittalDynamicsOf<T>::subtract(const std::vector<SoleForceOf<T>>& forces,
                                     VectorX<T>& rows) const {
  for (const SoleForceOf<T>& force : forces) {
    dynamics::add_point_force(state(), robot_->sole[force.sole_point].point,
                              dynamics::Vector3<T>(-force.x, T(0.0), -force.z), rows);
  }
}

template <typename T>
VectorX<T> SagittalDynamicsOf<T>::residual(const VectorX<T>& acceleration,
                                           const VectorX<T>& drive_Nm,
                                           const std::vector<SoleForceOf<T>>& forces) {
  VectorX<T> rows = VectorX<T>::Zero(robot_->robot.tree.velocity_size());
  if (is_reached_) {
    body_.inverse_dynamics(accelerated(acceleration), rows);
    dynamics::add_smooth_friction(body_.state(), kFrictionWidth_rad_s, rows);
    body_.add_drive_torques(-drive_Nm, rows);
    subtract(forces, rows);
  }
  return picked(rows, true);
}

template <typename T>
VectorX<T> SagittalDynamicsOf<T>::impact_residual(const VectorX<T>& change,
                                                  const std::vector<SoleForceOf<T>>& impulses) {
  const Index size = robot_->robot.tree.velocity_size();
  VectorX<T> rows = VectorX<T>::Zero(size);
  if (is_reached_) {
    Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic> mass(size, size);
    body_.mass_matrix(mass);
    // The change of the base's velocity that goes with that of the foot's.
    const BodyPoint& rear = robot_->sole.front().point;
    Eigen::Matrix<T, 3, Eigen::Dynamic> jacobian(3, size);
    dynamics::point_jacobian(body_.state(), rear, jacobian);
    VectorX<T> base = unplaced(change);
    const dynamics::Vector3<T> relative = jacobian * base;
    base[0] = change[0] - relative.x();
    base[1] = change[1] - relative.z();
    rows = mass * base;
    subtract(impulses, rows);
  }
  return picked(rows, false);
}

template <typename T>
Eigen::Matrix<T, 2, 1> SagittalDynamicsOf<T>::place_m(const BodyPoint& point) const {
  return base_m_ + in_plane<T>(dynamics::point_position_m(state(), point));
}

template <typename T>
Eigen::Matrix<T, 2, 1> SagittalDynamicsOf<T>::velocity_m_s(const BodyPoint& point) const {
  return base_m_s_ + in_plane<T>(dynamics::point_velocity_m_s(state(), point));
}

template <typename T>
Eigen::Matrix<T, 2, 1> SagittalDynamicsOf<T>::acceleration_m_s2(const BodyPoint& point,
                                                                const VectorX<T>& acceleration) {
  Eigen::Matrix<T, 3, Eigen::Dynamic> jacobian(3, robot_->robot.tree.velocity_size());
  dynamics::point_jacobian(state(), point, jacobian);
  const dynamics::Vector3<T> sum =
      jacobian * accelerated(acceleration) + dynamics::point_bias_acceleration_m_s2(state(), point);
  return in_plane<T>(sum);
}

namespace {

/// Of the joints of a drivetrain: those of the ones that move, 0 of the others.
template <typename T>
SmallVectorOf<T> of_drivetrain(const SagittalRobot& robot, const Drivetrain& drivetrain,
                               const VectorX<T>& values) {
  SmallVectorOf<T> out(static_cast<Index>(drivetrain.joints.size()));
  for (std::size_t k = 0; k < drivetrain.joints.size(); ++k) {
    out[static_cast<Index>(k)] = T(0.0);
    for (std::size_t i = 0; i < robot.joints.size(); ++i) {
      if (robot.joints[i] == drivetrain.joints[k]) {
        out[static_cast<Index>(k)] = values[static_cast<Index>(i)];
      }
    }
  }
  return out;
}

}  // namespace

template <typename T>
DriveMotionOf<T> drive_motion(const SagittalRobot& robot, const VectorX<T>& joint_rad,
                              const VectorX<T>& joint_rad_s, const VectorX<T>& joint_rad_s2,
                              const VectorX<T>& drive_Nm) {
  const auto drives = static_cast<Index>(robot.drive_count());
  DriveMotionOf<T> out{VectorX<T>::Constant(drives, T(kNotReached)),
                       VectorX<T>::Constant(drives, T(kNotReached)),
                       VectorX<T>::Zero(static_cast<Index>(robot.joints.size()))};
  Index first = 0;
  for (const Drivetrain& drivetrain : robot.robot.drivetrains) {
    const auto count = static_cast<Index>(drivetrain.actuators.size());
    const SmallVectorOf<T> rates = of_drivetrain(robot, drivetrain, joint_rad_s);
    const auto transfer =
        transfer_of<T>(*drivetrain.mechanism, of_drivetrain(robot, drivetrain, joint_rad), rates);
    if (transfer) {
      out.speed_rad_s.segment(first, count) = transfer->jacobian * rates;
      out.acceleration_rad_s2.segment(first, count) =
          transfer->jacobian * of_drivetrain(robot, drivetrain, joint_rad_s2) +
          transfer->jacobian_rate_1_s * rates;
      const SmallVectorOf<T> torque = drive_Nm.segment(first, count);
      const SmallVectorOf<T> at_joints = joint_torque_Nm<T>(*transfer, torque);
      for (std::size_t k = 0; k < drivetrain.joints.size(); ++k) {
        for (std::size_t i = 0; i < robot.joints.size(); ++i) {
          if (robot.joints[i] == drivetrain.joints[k]) {
            out.joint_Nm[static_cast<Index>(i)] += at_joints[static_cast<Index>(k)];
          }
        }
      }
    }
    first += count;
  }
  return out;
}

template class SagittalDynamicsOf<double>;
template class SagittalDynamicsOf<dynamics::Jet>;
template class SagittalDynamicsOf<dynamics::Jet2>;
template DriveMotionOf<double> drive_motion(const SagittalRobot&, const VectorX<double>&,
                                            const VectorX<double>&, const VectorX<double>&,
                                            const VectorX<double>&);
template DriveMotionOf<dynamics::Jet> drive_motion(const SagittalRobot&,
                                                   const VectorX<dynamics::Jet>&,
                                                   const VectorX<dynamics::Jet>&,
                                                   const VectorX<dynamics::Jet>&,
                                                   const VectorX<dynamics::Jet>&);
template DriveMotionOf<dynamics::Jet2> drive_motion(const SagittalRobot&,
                                                    const VectorX<dynamics::Jet2>&,
                                                    const VectorX<dynamics::Jet2>&,
                                                    const VectorX<dynamics::Jet2>&,
                                                    const VectorX<dynamics::Jet2>&);

}  // namespace torquewright::hopper
