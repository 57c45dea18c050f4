// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/plane/sagittal_robot.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "dynamics/inverse_dynamics.hpp"
#include "dynamics/momentum.hpp"
#include "dynamics/point.hpp"
#include "io/faults/refusal.hpp"
#include "robot/model/whole_body.hpp"

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
// How far a joint's unit axis may lean out of +-y (docs/derivations/collocation.md, "The plane").
constexpr double kLean = 1e-9;

[[noreturn]] void refuse(const Robot& robot, const std::string& why) {
  io::refuse(robot.name, why);
}

/// Where the frames of all bodies are in the base's at position zero.
struct ZeroPose {
  std::vector<Eigen::Matrix3d> frames;
  std::vector<Vector3d> places_m;
};

ZeroPose zero_pose(const dynamics::Tree& tree) {
  ZeroPose pose{{tree.bodies.size(), Eigen::Matrix3d::Identity()},
                {tree.bodies.size(), Vector3d::Zero()}};
  for (std::size_t i = 1; i < tree.bodies.size(); ++i) {
    const dynamics::Body& body = tree.bodies[i];
    const Eigen::Matrix3d& parent = pose.frames[body.parent];
    pose.frames[i] = parent * body.joint.R_PB;
    pose.places_m[i] = pose.places_m[body.parent] + parent * body.joint.p_PB_m;
  }
  return pose;
}

bool carries(const dynamics::Tree& tree, std::size_t body, std::size_t carried) {
  while (carried > body) carried = tree.bodies[carried].parent;
  return carried == body;
}

/// Where it stays at 0 it must be able to stand there.
void require_holdable(const Robot& robot, const dynamics::Joint& joint) {
  const dynamics::JointLimits& limits = joint.limits;
  if (limits.position_min <= 0.0 && limits.position_max >= 0.0) return;
  refuse(robot, fmt::format("joint '{}' does not move it in its sagittal plane and cannot stay at "
                            "0: its range is {:.4g} to {:.4g}",
                            joint.name, limits.position_min, limits.position_max));
}

/// Turns about the plane's normal at position zero are such turns at every posture in the plane,
/// and so is what has nothing of one.
void find_joints(const Robot& robot, const ZeroPose& pose, SagittalRobot& out) {
  for (std::size_t i = 1; i < robot.tree.bodies.size(); ++i) {
    const dynamics::Joint& joint = robot.tree.bodies[i].joint;
    const double across = (pose.frames[i] * joint.axis).y();
    const bool turns = joint.kind == dynamics::JointKind::kRevolute;
    const bool is_across = std::abs(std::abs(across) - 1.0) < kLean;
    if (!is_across && std::abs(across) > kLean) {
      refuse(robot, fmt::format("the axis of joint '{}' leans out of the sagittal plane: {:.4g} of "
                                "it stands across (allowed: 0 or 1)",
                                joint.name, across));
    }
    if (!turns && !is_across) {
      refuse(robot, fmt::format("joint '{}' slides in the sagittal plane; planned is for joints "
                                "that turn",
                                joint.name));
    }
    const Index row = 3 + static_cast<Index>(i) - 1;
    if (!turns || !is_across) {
      require_holdable(robot, joint);
      out.held.push_back(row);
      continue;
    }
    out.joints.push_back(i);
    out.moving.push_back(row);
    out.directions.push_back(carries(robot.tree, i, out.foot) ? (across > 0 ? 1.0 : -1.0) : 0.0);
  }
}

void require_mass_in_plane(const Robot& robot, const ZeroPose& pose, double mass_kg) {
  double moment = 0.0;
  for (std::size_t i = 0; i < robot.tree.bodies.size(); ++i) {
    const dynamics::RigidInertia& inertia = robot.tree.bodies[i].inertia;
    moment += inertia.mass_kg * (pose.places_m[i] + pose.frames[i] * inertia.center_of_mass_m).y();
  }
  if (std::abs(moment) <= kMoment) return;
  refuse(robot, fmt::format("its centre of mass lies {:.4g} m beside the sagittal plane, which no "
                            "plan in the plane keeps upright",
                            moment / mass_kg));
}

std::string sole_name(std::size_t index, std::size_t count) {
  if (count == 1) return "foot";
  if (index == 0) return "heel";
  if (index + 1 == count) return "toe";
  return fmt::format("sole {}", index);
}

/// Bodies that have contact points.
std::vector<std::string> feet_of(const Robot& robot) {
  std::vector<std::string> names;
  for (const ContactPoint& contact : robot.contacts) {
    const std::string& name = robot.tree.bodies[contact.point.body].name;
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

void require_foot(const Robot& robot) {
  const std::vector<std::string> feet = feet_of(robot);
  if (feet.size() > 1) {
    refuse(robot, fmt::format("it stands on {} bodies ({}), and planned is for robots that stand "
                              "on one: `hopper check` and `hopper replay` take a motion of it that "
                              "another program made; one leg under a base of its own, as "
                              "specs/robot/planar_leg.json, can be planned",
                              feet.size(), fmt::join(feet, ", ")));
  }
  for (const ContactPoint& contact : robot.contacts) {
    if (contact.radius_m > 0.0) {
      refuse(robot,
             fmt::format("contact point '{0}' is a ball; planned is for feet of points: in a "
                         "copy of the document put it {1:g} m lower, where the ball meets "
                         "the ground, without radius_m; plan with that, and replay with the "
                         "ball",
                         contact.name, contact.radius_m));
    }
  }
}

/// What stands on the ground at pitch zero.
void require_level(const Robot& robot, const std::vector<SolePoint>& sole) {
  const double rear_m = sole.front().point.p_B_m.z(), front_m = sole.back().point.p_B_m.z();
  if (std::abs(rear_m - front_m) > kLength_m) {
    refuse(robot,
           fmt::format("heel and toe are not level at position zero: the toe stands {:.4g} m "
                       "higher",
                       front_m - rear_m));
  }
  for (const SolePoint& one : sole) {
    if (one.point.p_B_m.z() >= rear_m - kLength_m) continue;
    refuse(robot,
           fmt::format("the contact points at its {} are lower than heel and toe; planned is "
                       "for a level sole",
                       one.name));
  }
}

void find_sole(const Robot& robot, const ZeroPose& pose, SagittalRobot& out) {
  if (robot.contacts.empty()) refuse(robot, "has no contact points to stand on");
  out.foot = robot.contacts.front().point.body;
  require_foot(robot);
  if (!pose.frames[out.foot].isIdentity(kLean)) {
    refuse(robot, fmt::format("the frame of '{}' is turned against the base's at position zero; "
                              "planned is for feet whose axes are the base's there",
                              robot.tree.bodies[out.foot].name));
  }
  const double foot_beside_m = pose.places_m[out.foot].y();
  for (std::size_t i = 0; i < robot.contacts.size(); ++i) {
    const ContactPoint& contact = robot.contacts[i];
    const Vector3d& place = contact.point.p_B_m;
    auto same = std::find_if(out.sole.begin(), out.sole.end(), [&](const SolePoint& one) {
      return std::abs(one.point.p_B_m.x() - place.x()) < kLength_m &&
             std::abs(one.point.p_B_m.z() - place.z()) < kLength_m;
    });
    if (same == out.sole.end()) {
      out.sole.push_back({"",
                          {out.foot, {place.x(), -foot_beside_m, place.z()}},
                          {},
                          contact.friction_coefficient});
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
      beside_m += foot_beside_m + robot.contacts[member].point.p_B_m.y();
    }
    if (std::abs(beside_m) > kLength_m) {
      refuse(robot, fmt::format("the contact points at its {} are not mirror images about the "
                                "sagittal plane: their places across it add up to {:.4g} m",
                                one.name, beside_m));
    }
  }
  require_level(robot, out.sole);
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
      joint_rad[moving] =
          std::isfinite(limits.position_min) && std::isfinite(limits.position_max)
              ? limits.position_min + 0.1 * step * (limits.position_max - limits.position_min)
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

/// A plan's dynamics are those of the tree's bodies.
void require_light_links(const Robot& robot) {
  const double links_kg = robot.links_kg();
  const WholeBody body(robot);
  if (body.links().empty()) return;
  refuse(robot,
         fmt::format("links of its loops weigh {:.4g} kg, or have springs or friction, which "
                     "a plan does not hold yet (hopper check and hopper replay do); robot import "
                     "--link-error gives "
                     "the mass of cranks and rods to their neighbours where a mechanism of "
                     "closed form stands for them",
                     links_kg));
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
  const char* const names[] = {"", "a force across it", "", "a rolling moment",
                               "", "a yawing moment"};
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
          in_plane(jacobian * acceleration + dynamics::point_bias_acceleration_m_s2(state, point))};
}

FrameOrigin center_of_mass(dynamics::TreeState& state, const Eigen::VectorXd& acceleration) {
  const dynamics::Centroid centroid = dynamics::centroid(state);
  Eigen::VectorXd force(acceleration.size());
  dynamics::inverse_dynamics(state, acceleration, force);
  return {in_plane(centroid.position_m), in_plane(centroid.velocity_m_s),
          force.head<2>() / centroid.mass_kg - Eigen::Vector2d(0.0, state.tree().gravity_m_s2)};
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
  for (const dynamics::Body& body : robot.tree.bodies) out.mass_kg += body.inertia.mass_kg;
  const ZeroPose pose = zero_pose(robot.tree);
  out.moving = {0, 1, 2};
  find_sole(robot, pose, out);
  find_joints(robot, pose, out);
  if (out.joints.empty()) refuse(robot, "no joint moves it in its sagittal plane");
  require_mass_in_plane(robot, pose, out.mass_kg);
  require_light_links(robot);
  require_mirrored(robot, out);
  if (robot.tree.base == dynamics::BaseKind::kSpatial) require_plane(robot, out);
  out.robot = robot;
  out.robot.tree.base = dynamics::BaseKind::kPlanar;
  return out;
}

}  // namespace torquewright::hopper
