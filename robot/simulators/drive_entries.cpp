// SPDX-License-Identifier: Apache-2.0
// Joint torques are J^T those of the actuators, docs/derivations/mechanisms.md eq. (2): of a joint
// alone, actuator k carries A_kj with A = J^-T, and turns with J_kj.
#include "robot/simulators/drive_entries.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "actuator/exporters/exporter.hpp"
#include "actuator/exporters/simulator_file.hpp"
#include "actuator/exporters/text.hpp"
#include "dynamics/passive_forces.hpp"
#include "io/faults/spec_error.hpp"
#include "io/text/one_line.hpp"
#include "robot/draft/postures_in_range.hpp"
#include "robot/draft/rotors_in_joints.hpp"
#include "robot/model/mechanism_reach.hpp"

namespace torquewright::hopper {
namespace {

using actuator::DriveEntry;
using actuator::FrictionPlace;
using actuator::JointFriction;
using actuator::PosturePoint;
using actuator::Shape;

constexpr double kNoShare = 1e-9;  // of an actuator's torque or speed: it takes no part
constexpr double kSame = 1e-6;     // of a ratio: no posture changes it
constexpr int kPostureSteps = 32;  // over a joint's range, of a table of postures

/// An actuator by the law of the simulator, at its own output.
struct Fitted {
  std::string file;
  Shape shape;
  std::vector<std::string> note;
  std::optional<JointFriction> friction;  ///< Beside the law; none: in it.
  double armature_kg_m2 = 0.0;            ///< By its own document; 0: that states none.
};

Fitted fitted(const actuator::Actuator& document, const std::string& file,
              const actuator::Exporter& exporter, FrictionPlace friction) {
  if (actuator::Region(document, {}).at(0.0).is_empty) {
    throw io::SpecError({{file, "", "no torque is possible at rest: there is no region to write"}});
  }
  if (friction == FrictionPlace::kJoint) {
    friction = usual_place(exporter, document, actuator::Side::kJoint);
  }
  const actuator::ExportedDrive drive(document, exporter, {.friction = friction});
  actuator::SimulatorFile written = actuator::simulator_file(drive.subject(), exporter, {});
  return {file, std::move(written.shape), std::move(written.note), drive.subject().friction,
          drive.subject().armature_kg_m2()};
}

/// What each actuator carries and how fast it turns for a joint alone, per unit of the joint's.
struct Shares {
  SmallMatrix torque;  ///< (actuators x joints)
  SmallMatrix speed;   ///< (actuators x joints)
};

std::optional<Shares> shares_at(const Mechanism& mechanism, const SmallVector& joint_rad) {
  const auto transfer = mechanism.transfer(joint_rad, SmallVector::Zero(joint_rad.size()));
  if (!transfer) return std::nullopt;
  const SmallMatrix inverse = transfer->jacobian.inverse();
  return Shares{inverse.transpose(), transfer->jacobian};
}

bool is_torque(const actuator::ShapeParameter& parameter) {
  return parameter.name.ends_with("_Nm");
}

/// The law of a joint alone: of each number the least that an actuator leaves. Empty where no
/// actuator takes part.
Shape shape_of_joint(const actuator::Exporter& exporter, const std::vector<const Fitted*>& drives,
                     const Shares& shares, Eigen::Index joint) {
  Shape shape(exporter.parameters.size(), std::numeric_limits<double>::infinity());
  for (std::size_t k = 0; k < drives.size(); ++k) {
    const auto row = static_cast<Eigen::Index>(k);
    for (std::size_t i = 0; i < shape.size(); ++i) {
      const double share = std::abs(is_torque(exporter.parameters[i]) ? shares.torque(row, joint)
                                                                      : shares.speed(row, joint));
      if (share > kNoShare) shape[i] = std::min(shape[i], drives[k]->shape[i] / share);
    }
  }
  const bool is_bounded =
      std::all_of(shape.begin(), shape.end(), [](double value) { return std::isfinite(value); });
  return is_bounded ? shape : Shape();
}

/// The friction of a joint alone: by virtual work, what each actuator's own does through the speed
/// with which it turns.
JointFriction friction_of_joint(const std::vector<const Fitted*>& drives, const Shares& shares,
                                Eigen::Index joint) {
  JointFriction sum;
  for (std::size_t k = 0; k < drives.size(); ++k) {
    const double share = std::abs(shares.speed(static_cast<Eigen::Index>(k), joint));
    const JointFriction own = drives[k]->friction.value_or(JointFriction{});
    sum.coulomb_Nm += share * own.coulomb_Nm;
    sum.breakaway_Nm += share * own.breakaway_Nm;
    sum.viscous_Nm_s_rad += share * share * own.viscous_Nm_s_rad;
  }
  return sum;
}

/// What the drives' rotors are at a joint alone, by their own documents.
double armature_of_joint(const std::vector<const Fitted*>& drives, const Shares& shares,
                         Eigen::Index joint) {
  double sum_kg_m2 = 0.0;
  for (std::size_t k = 0; k < drives.size(); ++k) {
    const double share = shares.speed(static_cast<Eigen::Index>(k), joint);
    sum_kg_m2 += share * share * drives[k]->armature_kg_m2;
  }
  return sum_kg_m2;
}

/// A simulator's drive overrules what its robot's file says of the joint, so that what the joint
/// has itself counts here.
void add_own(const dynamics::PassiveForces& passive, JointFriction& friction) {
  friction.coulomb_Nm += passive.dry_friction;
  friction.breakaway_Nm += dynamics::friction_limit(passive, 0.0);
  friction.viscous_Nm_s_rad += passive.damping;
}

/// The number of the law that bounds torque at any speed: the last that is a torque.
std::size_t cap_of(const actuator::Exporter& exporter) {
  std::size_t cap = 0;
  for (std::size_t i = 0; i < exporter.parameters.size(); ++i) {
    if (is_torque(exporter.parameters[i])) cap = i;
  }
  return cap;
}

class Collector {
 public:
  Collector(const Robot& robot, const actuator::Exporter& exporter, FrictionPlace friction)
      : robot_(robot),
        exporter_(exporter),
        friction_(friction),
        tree_(tree_with_rotors(robot, notes_)) {}

  DriveEntries run() {
    for (const Drivetrain& drivetrain : robot_.drivetrains) {
      for (std::size_t k = 0; k < drivetrain.actuators.size(); ++k) known(drivetrain, k);
    }
    for (const Drivetrain& drivetrain : robot_.drivetrains) add(drivetrain);
    note_armatures();
    notes_.emplace_back(
        "drives share the battery and warm up: a line between torque and speed holds neither");
    std::vector<ActuatorNote> actuators;
    for (Fitted& actuator : fitted_) {
      actuators.push_back({std::move(actuator.file), std::move(actuator.note)});
    }
    return {std::move(entries_), std::move(notes_), std::move(actuators), std::move(tree_)};
  }

 private:
  std::size_t known(const Drivetrain& drivetrain, std::size_t k) {
    const std::string& file = drivetrain.actuator_files[k];
    for (std::size_t i = 0; i < fitted_.size(); ++i) {
      if (fitted_[i].file == file) return i;
    }
    fitted_.push_back(fitted(drivetrain.actuators[k], file, exporter_, friction_));
    return fitted_.size() - 1;
  }

  const std::string& joint_name(std::size_t body) const {
    return robot_.tree.bodies[body].joint.name;
  }

  std::string names_of(const Drivetrain& drivetrain) const {
    std::vector<std::string> names;
    for (const std::size_t body : drivetrain.joints) names.push_back(joint_name(body));
    return fmt::format("{}", fmt::join(names, ", "));
  }

  void add(const Drivetrain& drivetrain) {
    std::vector<const Fitted*> drives;
    for (std::size_t k = 0; k < drivetrain.actuators.size(); ++k) {
      drives.push_back(&fitted_[known(drivetrain, k)]);
    }
    const SmallVector home = home_posture_rad(robot_.tree, drivetrain.joints);
    const auto shares = shares_at(*drivetrain.mechanism, home);
    if (!shares) {
      notes_.push_back(fmt::format("{}: not driven, the mechanism is singular nearest to zero",
                                   names_of(drivetrain)));
      return;
    }
    std::vector<Shape> shapes;
    for (Eigen::Index j = 0; j < home.size(); ++j) {
      shapes.push_back(shape_of_joint(exporter_, drives, *shares, j));
      std::optional<JointFriction> friction;
      if (friction_ == FrictionPlace::kJoint) friction = friction_of_joint(drives, *shares, j);
      const std::size_t body = drivetrain.joints[static_cast<std::size_t>(j)];
      if (friction) add_own(robot_.tree.bodies[body].joint.passive, *friction);
      see_armature(body, armature_of_joint(drives, *shares, j));
      add_joint(drivetrain, static_cast<std::size_t>(j), *shares, shapes.back(), friction,
                postures_of(drivetrain, drives, j));
    }
    note_coupling(drivetrain, drives, *shares, shapes);
    note_postures(drivetrain, drives, shapes);
  }

  void see_armature(std::size_t body, double of_drives_kg_m2) {
    const double written_kg_m2 = tree_.bodies[body].joint.reflected_inertia;
    const double off_kg_m2 = std::abs(written_kg_m2 - of_drives_kg_m2);
    if (off_kg_m2 <= kSame * std::max(written_kg_m2, of_drives_kg_m2)) return;
    other_armatures_[{written_kg_m2, of_drives_kg_m2}].push_back(joint_name(body));
  }

  /// Below stands what a drive's document says of its rotor: where the robot says another number,
  /// that one is written.
  void note_armatures() {
    for (const auto& [armatures, joints] : other_armatures_) {
      const auto& [written_kg_m2, of_drives_kg_m2] = armatures;
      notes_.push_back(fmt::format(
          "{}: the armature written here, {:.4g} kg m^2, is the robot's own; by the drive's "
          "document it would be {}",
          fmt::join(joints, ", "), written_kg_m2,
          of_drives_kg_m2 > 0.0 ? fmt::format("{:.4g} kg m^2 (below)", of_drives_kg_m2)
                                : "unknown: that states no inertia of the rotor"));
    }
  }

  void add_joint(const Drivetrain& drivetrain, std::size_t j, const Shares& shares,
                 const Shape& shape, const std::optional<JointFriction>& friction,
                 std::vector<PosturePoint> postures) {
    const std::size_t body = drivetrain.joints[j];
    if (shape.empty()) {
      notes_.push_back(fmt::format("{}: not driven nearest to zero", joint_name(body)));
      return;
    }
    const double armature_kg_m2 = tree_.bodies[body].joint.reflected_inertia;
    for (DriveEntry& entry : entries_) {
      const bool is_alike = entry.shape == shape && entry.armature_kg_m2 == armature_kg_m2 &&
                            entry.friction == friction && entry.postures == postures;
      if (!is_alike) continue;
      entry.joints.push_back(joint_name(body));
      return;
    }
    const bool is_plain =
        shares.speed.size() == 1 && std::abs(std::abs(shares.speed(0, 0)) - 1.0) <= kSame;
    const std::string& name = is_plain ? drivetrain.actuators[0].name : joint_name(body);
    entries_.push_back({unique(actuator::identifier(name)),
                        {joint_name(body)},
                        shape,
                        armature_kg_m2,
                        friction,
                        std::move(postures)});
  }

  /// Ratio and torque of a joint alone over its range, the others nearest to zero; empty where
  /// neither changes or the simulator takes none.
  std::vector<PosturePoint> postures_of(const Drivetrain& drivetrain,
                                        const std::vector<const Fitted*>& drives,
                                        Eigen::Index joint) const {
    if (!exporter_.takes_postures) return {};
    const std::size_t cap = cap_of(exporter_);
    const SmallVector home = home_posture_rad(robot_.tree, drivetrain.joints);
    const std::size_t body = drivetrain.joints[static_cast<std::size_t>(joint)];
    const dynamics::JointLimits& limits = robot_.tree.bodies[body].joint.limits;
    const bool has_range = std::isfinite(limits.position_min) && std::isfinite(limits.position_max);
    const double low_rad = has_range ? limits.position_min : home[joint] - 1.0;
    const double high_rad = has_range ? limits.position_max : home[joint] + 1.0;
    std::vector<PosturePoint> postures;
    for (int i = 0; i <= kPostureSteps; ++i) {
      SmallVector posture = home;
      posture[joint] = std::lerp(low_rad, high_rad, static_cast<double>(i) / kPostureSteps);
      const auto shares = shares_at(*drivetrain.mechanism, posture);
      if (!shares) continue;
      const Shape shape = shape_of_joint(exporter_, drives, *shares, joint);
      if (shape.empty()) continue;
      postures.push_back(
          {posture[joint], shares->speed.col(joint).cwiseAbs().maxCoeff(), shape[cap]});
    }
    const auto is_first = [&](const PosturePoint& at) {
      return std::abs(at.torque_Nm / postures.front().torque_Nm - 1.0) <= kSame;
    };
    if (std::all_of(postures.begin(), postures.end(), is_first)) postures.clear();
    return postures;
  }

  std::string unique(const std::string& wanted) {
    std::string name = wanted;
    for (int i = 2; !names_.insert(name).second; ++i) name = fmt::format("{}_{}", wanted, i);
    return name;
  }

  /// What all joints at their own limits would ask of one actuator, in its own limit.
  double together(const std::vector<const Fitted*>& drives, const Shares& shares,
                  const std::vector<Shape>& shapes) const {
    const std::size_t cap = cap_of(exporter_);
    double greatest = 0.0;
    for (std::size_t k = 0; k < drives.size(); ++k) {
      double sum_Nm = 0.0;
      for (std::size_t j = 0; j < shapes.size(); ++j) {
        sum_Nm += shapes[j][cap] * std::abs(shares.torque(static_cast<Eigen::Index>(k),
                                                          static_cast<Eigen::Index>(j)));
      }
      greatest = std::max(greatest, sum_Nm / drives[k]->shape[cap]);
    }
    return greatest;
  }

  void note_coupling(const Drivetrain& drivetrain, const std::vector<const Fitted*>& drives,
                     const Shares& shares, const std::vector<Shape>& shapes) {
    const auto is_driven = [](const Shape& shape) { return !shape.empty(); };
    if (shapes.size() < 2 || !std::all_of(shapes.begin(), shapes.end(), is_driven)) return;
    notes_.push_back(fmt::format(
        "{} are coupled ({}, driven by {}): each has here what it has alone, while the other "
        "carries no torque and rests. Both at their limits would ask an actuator for {:.3g} times "
        "its torque, and their speeds add up likewise: that is left out, as is the inertia that "
        "couples them",
        names_of(drivetrain), drivetrain.mechanism->type(),
        fmt::join(drivetrain.actuator_names, ", "), together(drives, shares, shapes)));
  }

  /// How the law changes over the joints' ranges, where it does.
  void note_postures(const Drivetrain& drivetrain, const std::vector<const Fitted*>& drives,
                     const std::vector<Shape>& shapes) {
    const std::size_t cap = cap_of(exporter_);
    for (std::size_t j = 0; j < shapes.size(); ++j) {
      if (shapes[j].empty()) continue;
      double least = 1.0;
      double greatest = 1.0;
      for (const SmallVector& posture : postures_in_range(robot_.tree, drivetrain)) {
        const auto shares = shares_at(*drivetrain.mechanism, posture);
        if (!shares) continue;
        const Shape there =
            shape_of_joint(exporter_, drives, *shares, static_cast<Eigen::Index>(j));
        const double ratio = there.empty() ? 0.0 : there[cap] / shapes[j][cap];
        least = std::min(least, ratio);
        greatest = std::max(greatest, ratio);
      }
      if (greatest - least <= kSame) continue;
      notes_.push_back(
          fmt::format("{} turns at a ratio that changes with posture ({}): the file holds {:.4g} "
                      "Nm, that of the "
                      "posture nearest to zero; within the joints' ranges it is {:.4g} to {:.4g} "
                      "Nm, and the speeds "
                      "change the other way",
                      joint_name(drivetrain.joints[j]), drivetrain.mechanism->type(),
                      shapes[j][cap], least * shapes[j][cap], greatest * shapes[j][cap]));
    }
  }

  const Robot& robot_;
  const actuator::Exporter& exporter_;
  FrictionPlace friction_;
  std::vector<std::string> notes_;
  dynamics::Tree tree_;
  std::vector<Fitted> fitted_;
  std::vector<DriveEntry> entries_;
  std::set<std::string> names_;
  /// Joints by what is written and what their drives' documents say, where these differ [kg m^2].
  std::map<std::pair<double, double>, std::vector<std::string>> other_armatures_;
};

}  // namespace

DriveEntries drive_entries(const Robot& robot, const actuator::Exporter& exporter,
                           FrictionPlace friction) {
  if (robot.drivetrains.empty()) {
    throw io::SpecError({{robot.name, "/mechanisms", "the robot has no drives to write"}});
  }
  return Collector(robot, exporter, friction).run();
}

void note_own_forces(const Robot& robot, FrictionPlace friction, std::vector<std::string>& notes) {
  std::vector<std::string> dragged, sprung;
  for (const dynamics::Body& body : robot.tree.bodies) {
    const dynamics::PassiveForces& passive = body.joint.passive;
    if (passive.damping > 0 || passive.dry_friction > 0) dragged.push_back(body.joint.name);
    if (passive.stiffness > 0) sprung.push_back(body.joint.name);
  }
  if (!dragged.empty()) {
    notes.push_back(fmt::format(
        "damping and friction of the joints themselves ({}) {}", fmt::join(dragged, ", "),
        friction == FrictionPlace::kJoint
            ? "are in the friction of their drives here, which overrules the robot's file"
            : "are left to the robot's file"));
  }
  if (!sprung.empty()) {
    notes.push_back(fmt::format("springs of joints ({}) are left to the robot's file",
                                fmt::join(sprung, ", ")));
  }
}

std::vector<std::string> actuator_lines(const DriveEntries& drives) {
  std::vector<std::string> head;
  for (const ActuatorNote& actuator : drives.actuators) {
    head.push_back(fmt::format("-- {}", io::name_in_text(actuator.file)));
    head.insert(head.end(), actuator.lines.begin(), actuator.lines.end());
  }
  return head;
}

}  // namespace torquewright::hopper
