// SPDX-License-Identifier: Apache-2.0
#include "hopper/flip/sagittal_robot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dynamics/inverse_dynamics.hpp"
#include "dynamics/momentum.hpp"
#include "dynamics/point.hpp"
#include "hopper/robot/whole_body.hpp"
#include "io/refusal.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::Vector3d;

// How far a robot may be from mirror images: of lengths in m, of masses' moments in kg m, and of
// the shares of two drives that bear one torque. 1 % of a share is what rods of a pair differ by
// where they have different lengths; the plan itself knows each drive's share exactly.
constexpr double kLength_m = 1e-6;
constexpr double kMoment = 1e-6;
constexpr double kShare = 0.02;

[[noreturn]] void refuse(const Robot& robot, const std::string& why) {
  io::refuse(robot.name, why);
}

bool is_across(const Vector3d& axis) { return std::abs(std::abs(axis.y()) - 1.0) < 1e-9; }

/// Axes of all joints in the base's frame at position zero.
void find_joints(const Robot& robot, SagittalRobot& out) {
  std::vector<Eigen::Matrix3d> frames(robot.tree.bodies.size(), Eigen::Matrix3d::Identity());
  std::vector<Vector3d> places(robot.tree.bodies.size(), Vector3d::Zero());
  for (std::size_t i = 1; i < robot.tree.bodies.size(); ++i) {
    const dynamics::Body& body = robot.tree.bodies[i];
    frames[i] = frames[body.parent] * body.joint.R_PB;
    places[i] = places[body.parent] + frames[body.parent] * body.joint.p_PB_m;
    const Vector3d axis = frames[i] * body.joint.axis;
    const Index row = 3 + static_cast<Index>(i) - 1;
    const bool moves = body.joint.kind == dynamics::JointKind::kRevolute && is_across(axis);
    if (!moves) {
      out.held.push_back(row);
      continue;
    }
    out.joints.push_back(i);
    out.moving.push_back(row);
    out.directions.push_back(axis.y() > 0 ? 1.0 : -1.0);
  }
  Vector3d moment = Vector3d::Zero();
  for (std::size_t i = 0; i < robot.tree.bodies.size(); ++i) {
    const dynamics::RigidInertia& inertia = robot.tree.bodies[i].inertia;
    moment += inertia.mass_kg * (places[i] + frames[i] * inertia.center_of_mass_m);
  }
  if (std::abs(moment.y()) > kMoment) {
    refuse(robot, fmt::format("its centre of mass lies {:.4g} m beside the sagittal plane, which "
                              "no plan in the plane keeps upright",
                              moment.y()));
  }
}

std::string sole_name(std::size_t index, std::size_t count) {
  if (count == 1) return "foot";
  if (index == 0) return "heel";
  if (index + 1 == count) return "toe";
  return fmt::format("sole {}", index);
}

void find_sole(const Robot& robot, SagittalRobot& out) {
  if (robot.contacts.empty()) refuse(robot, "has no contact points to stand on");
  out.foot = robot.contacts.front().point.body;
  for (std::size_t i = 0; i < robot.contacts.size(); ++i) {
    const ContactPoint& contact = robot.contacts[i];
    if (contact.point.body != out.foot) {
      refuse(robot, fmt::format("'{}' and '{}' are contact points of two bodies; planned is for "
                                "robots that stand on one",
                                robot.contacts.front().name, contact.name));
    }
    if (contact.radius_m > 0.0) {
      refuse(robot, fmt::format("contact point '{}' is a ball; planned is for feet of points",
                                contact.name));
    }
    const Vector3d& place = contact.point.p_B_m;
    auto same = std::find_if(out.sole.begin(), out.sole.end(), [&](const SolePoint& one) {
      return std::abs(one.point.p_B_m.x() - place.x()) < kLength_m &&
             std::abs(one.point.p_B_m.z() - place.z()) < kLength_m;
    });
    if (same == out.sole.end()) {
      out.sole.push_back({"", {out.foot, {place.x(), 0.0, place.z()}}, {}, contact.friction_coefficient});
      same = std::prev(out.sole.end());
    }
    same->members.push_back(i);
    same->friction_coefficient = std::min(same->friction_coefficient, contact.friction_coefficient);
  }
  std::sort(out.sole.begin(), out.sole.end(), [](const SolePoint& a, const SolePoint& b) {
    return a.point.p_B_m.x() < b.point.p_B_m.x();
  });
  for (std::size_t i = 0; i < out.sole.size(); ++i) {
    SolePoint& one = out.sole[i];
    one.name = sole_name(i, out.sole.size());
    double beside_m = 0.0;
    for (const std::size_t member : one.members) {
      beside_m += robot.contacts[member].point.p_B_m.y();
    }
    if (std::abs(beside_m) > kLength_m) {
      refuse(robot, fmt::format("the contact points at its {} are not mirror images about the "
                                "sagittal plane: their places across it add up to {:.4g} m",
                                one.name, beside_m));
    }
  }
}

/// Where joints that stay at 0 are driven by a mechanism together with one that moves, each drive
/// bears its share of that one's torque; mirror images bear the same.
void require_mirrored(const Robot& robot, const SagittalRobot& plane) {
  const auto moves = [&](std::size_t body) {
    return std::find(plane.joints.begin(), plane.joints.end(), body) != plane.joints.end();
  };
  for (const Drivetrain& drivetrain : robot.drivetrains) {
    if (drivetrain.joints.size() != 2) continue;
    const bool first = moves(drivetrain.joints[0]);
    if (first == moves(drivetrain.joints[1])) continue;
    const Index moving = first ? 0 : 1;
    const dynamics::JointLimits& limits =
        robot.tree.bodies[drivetrain.joints[static_cast<std::size_t>(moving)]].joint.limits;
    for (int step = 0; step <= 10; ++step) {
      SmallVector joint_rad = SmallVector::Zero(2);
      joint_rad[moving] = std::isfinite(limits.position_min) && std::isfinite(limits.position_max)
                              ? limits.position_min + 0.1 * step *
                                    (limits.position_max - limits.position_min)
                              : -0.5 + 0.1 * step;
      const auto transfer = drivetrain.mechanism->transfer(joint_rad, SmallVector::Zero(2));
      if (!transfer) continue;
      SmallVector needed = SmallVector::Zero(2);
      needed[moving] = 1.0;
      const SmallVector shares = actuator_torque_Nm(*transfer, needed);
      const double apart = std::abs(std::abs(shares[0]) - std::abs(shares[1])) /
                           std::max(std::abs(shares[0]), std::abs(shares[1]));
      if (apart <= kShare) continue;
      refuse(robot,
             fmt::format("the mechanism of {} and {} is not symmetric about the sagittal plane: at "
                         "{:.4g} rad its drives bear {:.4g} and {:.4g} of a torque in the plane, "
                         "{:.2g} % apart (allowed: {:g} %); a motion in the plane would not stay "
                         "there",
                         robot.tree.bodies[drivetrain.joints[0]].joint.name,
                         robot.tree.bodies[drivetrain.joints[1]].joint.name, joint_rad[moving],
                         shares[0], shares[1], 100.0 * apart, 100.0 * kShare));
    }
  }
}

/// Forces out of the plane that a motion in it would need, over those in it.
void require_plane(const Robot& robot, const SagittalRobot& plane) {
  dynamics::TreeState state(robot.tree);
  const Index size = robot.tree.velocity_size();
  Eigen::VectorXd position = dynamics::zero_position(robot.tree);
  Eigen::VectorXd velocity = Eigen::VectorXd::Zero(size);
  Eigen::VectorXd acceleration = Eigen::VectorXd::Zero(size);
  // One lively instant: every joint of the plane bent, turning and accelerating, no two alike.
  velocity.head<6>() << 0.7, 0.0, -0.4, 0.0, 3.0, 0.0;
  acceleration.head<6>() << 2.0, 0.0, 5.0, 0.0, 20.0, 0.0;
  for (std::size_t i = 0; i < plane.joints.size(); ++i) {
    const auto row = static_cast<Index>(plane.joints[i]) - 1;
    position[7 + row] = 0.4 + 0.2 * static_cast<double>(i);
    velocity[6 + row] = 5.0 - 2.0 * static_cast<double>(i);
    acceleration[6 + row] = -30.0 + 11.0 * static_cast<double>(i);
  }
  state.set(position, velocity);
  Eigen::VectorXd force(size);
  dynamics::inverse_dynamics(state, acceleration, force);
  const double in_plane = std::max({std::abs(force[0]), std::abs(force[2]), std::abs(force[4])});
  const char* const names[] = {"", "a force across it", "", "a rolling moment", "", "a yawing moment"};
  for (const Index row : {1, 3, 5}) {
    if (std::abs(force[row]) <= kMoment * in_plane) continue;
    refuse(robot, fmt::format("is not symmetric about the sagittal plane: a motion in the plane "
                              "would need {} of {:.3g} (in the plane up to {:.3g}); masses or "
                              "products of inertia are not mirrored",
                              names[row], force[row], in_plane));
  }
}

}  // namespace

std::size_t SagittalRobot::drive_count() const {
  std::size_t count = 0;
  for (const Drivetrain& drivetrain : robot.drivetrains) count += drivetrain.actuators.size();
  return count;
}

Eigen::VectorXd SagittalRobot::all_rows(const Eigen::VectorXd& moving_rows) const {
  Eigen::VectorXd out = Eigen::VectorXd::Zero(robot.tree.velocity_size());
  for (std::size_t i = 0; i < moving.size(); ++i) {
    out[moving[i]] = moving_rows[static_cast<Index>(i)];
  }
  return out;
}

namespace {

/// x and z of a frame's origin, base at the origin and not moving along.
struct FrameOrigin {
  Eigen::Vector2d place_m, velocity_m_s, acceleration_m_s2;
};

Eigen::Vector2d in_plane(const Vector3d& vector) { return {vector.x(), vector.z()}; }

FrameOrigin rear_of_sole(const SagittalRobot& robot, dynamics::TreeState& state,
                    const Eigen::VectorXd& acceleration) {
  const dynamics::BodyPoint& point = robot.sole.front().point;
  Eigen::Matrix<double, 3, Eigen::Dynamic> jacobian(3, acceleration.size());
  dynamics::point_jacobian(state, point, jacobian);
  return {in_plane(dynamics::point_position_m(state, point)),
          in_plane(dynamics::point_velocity_m_s(state, point)),
          in_plane(jacobian * acceleration +
                   dynamics::point_bias_acceleration_m_s2(state, point))};
}

FrameOrigin center_of_mass(dynamics::TreeState& state, const Eigen::VectorXd& acceleration) {
  const dynamics::Centroid centroid = dynamics::centroid(state);
  Eigen::VectorXd force(acceleration.size());
  dynamics::inverse_dynamics(state, acceleration, force);
  return {in_plane(centroid.position_m), in_plane(centroid.velocity_m_s),
          force.head<2>() / centroid.mass_kg -
              Eigen::Vector2d(0.0, state.tree().gravity_m_s2)};
}

/// `still`: the base's place and what it does are 0.
FrameOrigin origin_of(const SagittalRobot& robot, PlanFrame frame, const TreeMotion& still) {
  dynamics::TreeState state(robot.robot.tree);
  state.set(still.position, still.velocity);
  return frame == PlanFrame::kSole ? rear_of_sole(robot, state, still.acceleration)
                                   : center_of_mass(state, still.acceleration);
}

/// What joints that move turn the foot by beyond the base.
double turned(const SagittalRobot& robot, const Eigen::VectorXd& rows) {
  double sum = 0.0;
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    sum += robot.directions[i] * rows[static_cast<Index>(robot.joints[i]) + 2];
  }
  return sum;
}

}  // namespace

TreeMotion tree_motion(const SagittalRobot& robot, PlanFrame frame, const TreeMotion& rows) {
  TreeMotion out = rows;
  for (Eigen::VectorXd* of : {&out.position, &out.velocity, &out.acceleration}) {
    of->head<2>().setZero();
    if (frame == PlanFrame::kSole) (*of)[2] -= turned(robot, *of);
  }
  const FrameOrigin origin = origin_of(robot, frame, out);
  out.position.head<2>() = rows.position.head<2>() - origin.place_m;
  out.velocity.head<2>() = rows.velocity.head<2>() - origin.velocity_m_s;
  out.acceleration.head<2>() = rows.acceleration.head<2>() - origin.acceleration_m_s2;
  return out;
}

TreeMotion frame_motion(const SagittalRobot& robot, PlanFrame frame, const TreeMotion& tree) {
  TreeMotion out = tree;
  for (Eigen::VectorXd* of : {&out.position, &out.velocity, &out.acceleration}) {
    of->head<2>().setZero();
  }
  const FrameOrigin origin = origin_of(robot, frame, out);
  out.position.head<2>() = tree.position.head<2>() + origin.place_m;
  out.velocity.head<2>() = tree.velocity.head<2>() + origin.velocity_m_s;
  out.acceleration.head<2>() = tree.acceleration.head<2>() + origin.acceleration_m_s2;
  if (frame == PlanFrame::kMass) return out;
  for (Eigen::VectorXd* of : {&out.position, &out.velocity, &out.acceleration}) {
    (*of)[2] += turned(robot, *of);
  }
  return out;
}

SagittalRobot sagittal(const Robot& robot) {
  SagittalRobot out;
  if (robot.tree.base == dynamics::BaseKind::kFixed) {
    refuse(robot, "its base is fixed: it cannot leave the ground");
  }
  if (!(robot.tree.gravity_m_s2 > 0.0)) {
    refuse(robot, fmt::format("gravity is {:g} m/s2: without it nothing comes down again",
                              robot.tree.gravity_m_s2));
  }
  out.moving = {0, 1, 2};
  find_joints(robot, out);
  if (out.joints.empty()) refuse(robot, "no joint moves it in its sagittal plane");
  find_sole(robot, out);
  require_mirrored(robot, out);
  if (robot.tree.base == dynamics::BaseKind::kSpatial) require_plane(robot, out);
  out.robot = robot;
  out.robot.tree.base = dynamics::BaseKind::kPlanar;
  for (const dynamics::Body& body : robot.tree.bodies) out.mass_kg += body.inertia.mass_kg;
  return out;
}

}  // namespace torquewright::hopper
