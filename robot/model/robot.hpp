// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "actuator/motor/actuator.hpp"
#include "dynamics/point.hpp"
#include "dynamics/tree.hpp"
#include "robot/mechanisms/closed_links.hpp"
#include "robot/mechanisms/mechanism.hpp"
#include "robot/model/posture.hpp"
#include "robot/model/transmission_limit.hpp"

namespace torquewright::hopper {

/// Where the robot may touch the ground.
struct ContactPoint {
  std::string name;
  dynamics::BodyPoint point;
  double friction_coefficient = 0;
  double restitution = 0;
  double radius_m = 0;  ///< Of a ball about the point; 0: the point itself touches.
};

/// A ball that stands for part of a body where bodies must not meet.
struct CollisionSphere {
  dynamics::BodyPoint center;
  double radius_m = 0.0;
};

/// Joints, the actuators that move them, and what stands between.
struct Drivetrain {
  std::shared_ptr<const Mechanism> mechanism;
  std::vector<std::size_t> joints;  ///< By the body that the joint carries.
  std::vector<actuator::Actuator> actuators;
  std::vector<std::string> actuator_names;  ///< The joint's where one actuator moves one joint.
  std::vector<std::string> actuator_files;  ///< As the document names them.
  /// Whether each actuator's document states no battery, so that the robot's feeds it if there is
  /// one.
  std::vector<bool> on_robots_battery;
  /// Whether the joints' reflected inertia in the tree holds that of these rotors already.
  bool rotors_in_tree = true;
  /// Whether a joint's document says what rotors weigh there: it knows nothing then of what an
  /// actuator's effects add.
  bool joints_state_rotors = false;
  /// Inertia of rotor and gears at each actuator's output, in kg m^2, where the mechanism itself
  /// states it; else empty.
  std::vector<double> stated_rotors_kg_m2;
  /// Inertia of each crank about its axis, behind the gears, in kg m^2; empty: cranks weigh
  /// nothing.
  std::vector<double> cranks_kg_m2;
  std::optional<dynamics::BodyPoint> mount;  ///< Where its actuators' mass sits, if stated.
  std::optional<TransmissionLimit> transmission_limit;  ///< Of each of its actuators.
  bool is_of_limits = false;  ///< Made of what its joint states, for its document names no drive.
};

/// Links that no drive turns: they close on joints of the robot, which are driven or free by
/// themselves, as the rod to a leaf spring does.
struct Follower {
  std::shared_ptr<const ClosedLinks> links;
  std::vector<std::size_t> joints;  ///< By the body that the joint carries.
};

/// Rotor and gears at an actuator's output: as stated, else N^2 J of the actuator.
double rotor_at_output_kg_m2(const Drivetrain& drivetrain, std::size_t actuator);
/// The same and the crank that it turns.
double turned_at_output_kg_m2(const Drivetrain& drivetrain, std::size_t actuator);

struct Robot {
  std::string name;
  dynamics::Tree tree;  ///< Joints carry their names.
  std::vector<ContactPoint> contacts;
  std::vector<Drivetrain> drivetrains;
  std::vector<Follower> followers;
  std::vector<CollisionSphere> spheres;
  std::string battery;            ///< JSON as stated, for drives that state none; or empty.
  std::vector<Posture> postures;  ///< By name.
  /// Joints, by the body that each carries, of which it is stated that they have no reflected
  /// inertia: none of an actuator's either.
  std::vector<std::size_t> without_rotor;
  std::vector<std::string> assumed;  ///< JSON pointers into its document.

  /// Index of the body that the joint carries; none if no joint has that name.
  std::optional<std::size_t> find_joint(const std::string& name) const;
  /// Whether reflected inertia of the joint that carries the body is known: some, or stated as
  /// none.
  bool states_rotor(std::size_t body, const dynamics::Joint& joint) const;
  /// What the links of its loops weigh, which are none of the tree's bodies.
  double links_kg() const;
};

}  // namespace torquewright::hopper
