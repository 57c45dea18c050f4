// SPDX-License-Identifier: Apache-2.0
// Geometry: docs/derivations/mechanisms.md.
#include "robot/loops/closed_loops.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "robot/mechanisms/constant_jacobian.hpp"
#include "robot/mechanisms/four_bar.hpp"
#include "robot/mechanisms/loop.hpp"
#include "robot/mechanisms/parallel_ankle.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kLink_kg = 1e-3;
constexpr double kLink_kg_m2 = 1e-6;

void weigh(dynamics::Body& link) {
  link.inertia.mass_kg = kLink_kg;
  link.inertia.inertia_kg_m2 = kLink_kg_m2 * Matrix3d::Identity();
}

/// Adds a loop's links as they are, all joints of it counted from where the loop starts.
class LinkAdder {
 public:
  explicit LinkAdder(LoopedRobot& looped) : looped_(looped) {}

  /// Where each body of the loop's tree is then.
  std::vector<std::size_t> add(const ClosedLinks& links, const std::vector<std::size_t>& joints) {
    const LoopGeometry& geometry = links.geometry();
    const Eigen::VectorXd home = geometry.start.head(geometry.joints);
    const Eigen::VectorXd closed =
        links.follow<double>(home, Eigen::VectorXd::Zero(home.size()))->position;
    std::vector<std::size_t> place{bodies()[joints.front()].parent};
    for (std::size_t k = 0; k < joints.size(); ++k) {
      stand_at(joints[k], closed[static_cast<Eigen::Index>(k)]);
      place.push_back(joints[k]);
    }
    const std::size_t first = bodies().size();
    for (std::size_t i = place.size(); i < geometry.tree.bodies.size(); ++i) {
      dynamics::Body link = geometry.tree.bodies[i];
      link.parent = place[link.parent];
      begin_at(closed[static_cast<Eigen::Index>(i) - 1], link.joint);
      place.push_back(bodies().size());
      bodies().push_back(std::move(link));
    }
    for (std::size_t i = first; i < bodies().size(); ++i) {
      if (bodies()[i].inertia.mass_kg > 0 || carries_another(i)) continue;
      weigh(bodies()[i]);
      makes_weight_ = true;
    }
    for (const LoopClosure& closure : geometry.closures) {
      looped_.pins.push_back({place[closure[0].body], place[closure[1].body], closure[0].p_B_m});
    }
    return place;
  }

  /// Whether links weigh something because MuJoCo asks for it.
  bool makes_weight() const { return makes_weight_; }

 private:
  std::vector<dynamics::Body>& bodies() { return looped_.robot.tree.bodies; }

  bool carries_another(std::size_t body) {
    const auto& all = bodies();
    return std::any_of(all.begin() + 1, all.end(),
                       [&](const dynamics::Body& other) { return other.parent == body; });
  }

  static void turn_to(double position, dynamics::Joint& joint) {
    if (joint.kind == dynamics::JointKind::kRevolute) {
      joint.R_PB = joint.R_PB * Eigen::AngleAxisd(position, joint.axis).toRotationMatrix();
    } else {
      joint.p_PB_m += joint.R_PB * joint.axis * position;
    }
  }

  /// One of the robot's own, which still counts its position as before; once, where loops share it.
  void stand_at(std::size_t body, double position) {
    looped_.references.resize(bodies().size(), 0.0);
    if (position == 0 || looped_.references[body] != 0) return;
    looped_.references[body] = position;
    turn_to(position, bodies()[body].joint);
  }

  /// Counts a joint's position from there.
  static void begin_at(double position, dynamics::Joint& joint) {
    turn_to(position, joint);
    joint.limits.position_min -= position;
    joint.limits.position_max -= position;
    joint.passive.rest_position -= position;
  }

  LoopedRobot& looped_;
  bool makes_weight_ = false;
};

class LoopCloser {
 public:
  LoopCloser(LoopedRobot& looped, const Drivetrain& drivetrain)
      : looped_(looped), drivetrain_(drivetrain) {}

  /// False, and nothing done, where the mechanism has no linkage or does not reach zero.
  bool close() {
    if (const auto* loop = dynamic_cast<const Loop*>(drivetrain_.mechanism.get())) {
      close_loop(*loop);
      return true;
    }
    const auto count = static_cast<Eigen::Index>(drivetrain_.joints.size());
    const SmallVector rest = SmallVector::Zero(count);
    const auto transfer = drivetrain_.mechanism->transfer(rest, rest);
    if (!transfer) return false;
    const SmallVector& start_rad = transfer->actuator_position_rad;
    if (const auto* bar = dynamic_cast<const FourBar*>(drivetrain_.mechanism.get())) {
      close_four_bar(bar->geometry(), start_rad[0]);
    } else if (const auto* ankle =
                   dynamic_cast<const ParallelAnkle*>(drivetrain_.mechanism.get())) {
      for (std::size_t i = 0; i < 2; ++i) {
        close_rod(ankle->geometry().rods[i], i, start_rad[static_cast<Eigen::Index>(i)]);
      }
    } else {
      return false;
    }
    return true;
  }

  /// Whether links weigh something because MuJoCo asks for it.
  bool makes_weight() const { return makes_weight_; }

 private:
  std::vector<dynamics::Body>& bodies() { return looped_.robot.tree.bodies; }
  const dynamics::Body& carried(std::size_t joint) { return bodies()[drivetrain_.joints[joint]]; }

  std::size_t add_link(const std::string& name, std::size_t parent, const Vector3d& place_m,
                       const Vector3d& axis) {
    dynamics::Body link;
    link.name = name;
    link.parent = parent;
    link.joint.name = name;
    link.joint.p_PB_m = place_m;
    link.joint.axis = axis;
    weigh(link);
    makes_weight_ = true;
    bodies().push_back(std::move(link));
    return bodies().size() - 1;
  }

  /// Its drive turns it alone; the rotor is its own.
  void drive(std::size_t crank, std::size_t index, double rotor_kg_m2) {
    bodies()[crank].joint.reflected_inertia = rotor_kg_m2;
    Drivetrain direct;
    direct.mechanism = std::make_shared<ConstantJacobian>("direct", SmallMatrix::Identity(1, 1));
    direct.joints = {crank};
    direct.actuators = {drivetrain_.actuators[index]};
    direct.actuator_names = {drivetrain_.actuator_names[index]};
    direct.actuator_files = {drivetrain_.actuator_files[index]};
    looped_.robot.drivetrains.push_back(std::move(direct));
  }

  /// Joints that state what rotors weigh at them keep it: then a crank has none.
  double rotor_of(std::size_t index) const {
    return drivetrain_.rotors_in_tree ? 0 : turned_at_output_kg_m2(drivetrain_, index);
  }

  std::string link_name(std::size_t index, const char* part) const {
    return fmt::format("{}_{}", drivetrain_.actuator_names[index], part);
  }

  /// The ground link's direction is free: any across the joint's axis.
  void close_four_bar(const FourBarGeometry& bar, double start_rad) {
    const std::size_t held = drivetrain_.joints.front();
    dynamics::Joint& joint = bodies()[held].joint;
    const std::size_t parent = bodies()[held].parent;
    const Vector3d normal = bar.rocker_direction * (joint.R_PB * joint.axis);
    const Vector3d along = normal.unitOrthogonal();
    const auto at = [&](double length_m, double angle_rad) -> Vector3d {
      return length_m *
             (std::cos(angle_rad) * along + std::sin(angle_rad) * Vector3d(normal.cross(along)));
    };
    const Vector3d pivot_m = joint.p_PB_m - bar.ground_m * along;
    const Vector3d pin_m = at(bar.crank_m, bar.crank_zero_rad + bar.crank_direction * start_rad);
    const Vector3d far_m = bar.ground_m * along + at(bar.rocker_m, bar.rocker_zero_rad);
    // What one drive at a constant ratio weighs stands in its joint: it moves to the crank.
    double rotor_kg_m2 = rotor_of(0);
    const auto ratio = drivetrain_.mechanism->constant_jacobian();
    if (ratio && drivetrain_.rotors_in_tree) {
      rotor_kg_m2 = joint.reflected_inertia / ((*ratio)(0, 0) * (*ratio)(0, 0));
      joint.reflected_inertia = 0;
    }
    const std::size_t crank =
        add_link(link_name(0, "crank"), parent, pivot_m, bar.crank_direction * normal);
    const std::size_t rod = add_link(link_name(0, "rod"), crank, pin_m, normal);
    looped_.pins.push_back({rod, held, far_m - pin_m});
    drive(crank, 0, rotor_kg_m2);
  }

  /// The rod hangs on the crank by a hinge about the crank's axis and one across that and itself.
  void close_rod(const AnkleRod& stated, std::size_t index, double start_rad) {
    const dynamics::Joint& pitch = carried(0).joint;
    const dynamics::Joint& roll = carried(1).joint;
    const std::size_t calf = carried(0).parent;
    const Vector3d foot_m =
        pitch.p_PB_m + pitch.R_PB * (roll.p_PB_m + roll.R_PB * stated.foot_attachment_m);
    const Matrix3d R = Eigen::AngleAxisd(start_rad, stated.actuator_axis).toRotationMatrix();
    const Vector3d pin_m = stated.actuator_center_m + R * stated.crank_m;
    const Vector3d rod_m = R.transpose() * (foot_m - pin_m);
    const std::size_t crank =
        add_link(link_name(index, "crank"), calf, stated.actuator_center_m, stated.actuator_axis);
    bodies()[crank].joint.R_PB = R;
    const std::size_t fork =
        add_link(link_name(index, "fork"), crank, stated.crank_m, stated.actuator_axis);
    const std::size_t rod = add_link(link_name(index, "rod"), fork, Vector3d::Zero(),
                                     rod_m.cross(stated.actuator_axis).normalized());
    looped_.pins.push_back({rod, drivetrain_.joints[1], rod_m});
    drive(crank, index, rotor_of(index));
  }

  /// Rotors of own joints that drives turn stand in these joints already.
  void close_loop(const Loop& loop) {
    LinkAdder adder(looped_);
    const std::vector<std::size_t> place = adder.add(loop.links(), drivetrain_.joints);
    makes_weight_ = makes_weight_ || adder.makes_weight();
    const std::vector<std::size_t>& turned = loop.geometry().turned;
    for (std::size_t i = 0; i < turned.size(); ++i) {
      const std::size_t body = place[turned[i]];
      drive(body, i, bodies()[body].joint.reflected_inertia + rotor_of(i));
    }
  }

  LoopedRobot& looped_;
  const Drivetrain& drivetrain_;
  bool makes_weight_ = false;
};

bool is_linkage(const Mechanism& mechanism) {
  return mechanism.type() == "four_bar" || mechanism.type() == "parallel_ankle" ||
         mechanism.type() == "loop";
}

}  // namespace

LoopedRobot with_closed_loops(const Robot& robot, std::vector<std::string>& notes) {
  LoopedRobot looped{robot, {}, {}};
  looped.robot.drivetrains.clear();
  looped.robot.followers.clear();
  bool has_made_links = false;
  for (const Drivetrain& drivetrain : robot.drivetrains) {
    LoopCloser closer(looped, drivetrain);
    if (closer.close()) {
      has_made_links = has_made_links || closer.makes_weight();
      continue;
    }
    looped.robot.drivetrains.push_back(drivetrain);
    if (!is_linkage(*drivetrain.mechanism)) continue;
    notes.push_back(fmt::format("the linkage of {} is not held: it does not reach zero",
                                fmt::join(drivetrain.actuator_names, ", ")));
  }
  for (const Follower& follower : robot.followers) {
    LinkAdder adder(looped);
    adder.add(*follower.links, follower.joints);
    has_made_links = has_made_links || adder.makes_weight();
  }
  looped.references.resize(looped.robot.tree.bodies.size(), 0.0);
  if (has_made_links) {
    notes.push_back(fmt::format(
        "cranks and rods weigh {} kg each, for MuJoCo holds none without mass; they stand at zero "
        "where all joints do",
        kLink_kg));
  }
  return looped;
}

}  // namespace torquewright::hopper
