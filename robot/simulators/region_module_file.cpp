// SPDX-License-Identifier: Apache-2.0
// Joint torques are J^T those of the drives, and drives carry J^-T those of the joints
// (docs/derivations/mechanisms.md eq. (2)), so that drives that share joints are clipped each at
// its own output.
#include "robot/simulators/region_module_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <set>

#include "actuator/exporters/python_module.hpp"
#include "actuator/exporters/simulator_file.hpp"
#include "actuator/exporters/text.hpp"
#include "actuator/motor/servo_gains.hpp"
#include "actuator/source_text/python_source.hpp"
#include "dynamics/passive_forces.hpp"
#include "io/faults/spec_error.hpp"
#include "io/text/one_line.hpp"
#include "robot/draft/postures_in_range.hpp"
#include "robot/draft/rotors_in_joints.hpp"
#include "robot/model/mechanism_reach.hpp"
#include "robot/simulators/every_region_module.hpp"

namespace torquewright::hopper {
namespace {

using actuator::DryFriction;
using actuator::FrictionPlace;
using actuator::JointFriction;

constexpr double kSameRatio = 1e-6;  // of a ratio: no posture changes it

constexpr std::string_view kWithin = R"(
DRIVEN = tuple(name for group in GROUPS for name in group["joints"])


def _sum(factors, terms):
    return sum(factor * term for factor, term in zip(factors, terms))


def within(torques, velocities, voltage=None, temperature=None):
    """What the joints have [Nm] of torques [Nm] at velocities [rad/s], arrays whose last axis is
    DRIVEN. Each drive is held to its region at its own output."""
    columns = []
    for group in GROUPS:
        first, count = len(columns), len(group["joints"])
        asked = [torques[..., first + i] for i in range(count)]
        turned = [velocities[..., first + i] for i in range(count)]
        ends = []
        for drive, speeds, carried in zip(group["drives"], group["speeds"], group["torques"]):
            reach = drive.clip if getattr(drive, "drag", None) is None else drive.torque
            ends.append(reach(_sum(carried, asked), _sum(speeds, turned), voltage, temperature))
        columns += [_sum([row[i] for row in group["speeds"]], ends) for i in range(count)]
    return _namespace(columns[0]).stack(columns, -1)


def servo(targets, positions, velocities):
    """Torques [Nm] towards targets [rad] by the gains of JOINTS; the last axis is DRIVEN."""
    columns = []
    for i, name in enumerate(DRIVEN):
        gains = JOINTS[name]["gains"]
        if gains is None:
            raise ValueError(name + ": no gains, since no rotor's inertia is stated; set them")
        columns.append(
            gains[0] * (targets[..., i] - positions[..., i]) - gains[1] * velocities[..., i]
        )
    return _namespace(columns[0]).stack(columns, -1)
)";

/// An actuator with its region, under a name of Python's.
struct Held {
  std::string file;
  std::string name;
  actuator::PythonRegion region;
  std::vector<std::string> note;
  std::optional<JointFriction> friction;  ///< Beside the region.
  double peak_Nm = 0.0;
};

std::string tuple(const std::vector<std::string>& parts) {
  return fmt::format("({}{})", fmt::join(parts, ", "), parts.size() == 1 ? "," : "");
}

std::string rows(const SmallMatrix& matrix) {
  std::vector<std::string> lines;
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    std::vector<std::string> numbers;
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
      numbers.push_back(fmt::format("{}", matrix(i, j)));
    }
    lines.push_back(tuple(numbers));
  }
  return tuple(lines);
}

std::string number_or_none(bool is_known, double value) {
  return is_known ? fmt::format("{}", value) : "None";
}

class ModuleText {
 public:
  ModuleText(const Robot& robot, const RegionModule& module, FrictionPlace friction)
      : robot_(robot),
        module_(module),
        exporter_(*module.exporter),
        friction_(friction),
        tree_(tree_with_rotors(robot, notes_)),
        of_drives_(tree_.bodies.size()),
        peak_Nm_(tree_.bodies.size(), 0.0) {}

  Exported run(const std::vector<std::string>& origin) {
    for (const Drivetrain& drivetrain : robot_.drivetrains) add(drivetrain);
    if (groups_.empty()) {
      throw io::SpecError({{robot_.name, "/mechanisms", "no drive moves a joint at its home"}});
    }
    notes_.emplace_back("each drive is computed as if it alone loaded the battery and heated");
    note_springs();
    return {head(origin) + body(), notes_};
  }

 private:
  std::size_t held(const Drivetrain& drivetrain, std::size_t k) {
    const std::string& file = drivetrain.actuator_files[k];
    for (std::size_t i = 0; i < held_.size(); ++i) {
      if (held_[i].file == file) return i;
    }
    const actuator::Actuator& document = drivetrain.actuators[k];
    if (actuator::Region(document, {}).at(0.0).is_empty) {
      throw io::SpecError(
          {{file, "", "no torque is possible at rest: there is no region to write"}});
    }
    const FrictionPlace place = friction_ == FrictionPlace::kJoint
                                    ? usual_place(exporter_, document, actuator::Side::kJoint)
                                    : friction_;
    const actuator::ExportedDrive drive(document, exporter_, {.friction = place});
    const actuator::SimulatorFile written =
        actuator::simulator_file(drive.subject(), exporter_, {});
    Held next;
    next.file = file;
    next.name = unique(actuator::identifier(document.name));
    next.region = python_region(next.name, drive.subject(), written.shape, composes());
    next.note = written.note;
    next.friction = drive.subject().friction;
    next.peak_Nm = drive.subject().table.peak_torque_Nm;
    held_.push_back(std::move(next));
    return held_.size() - 1;
  }

  bool composes() const { return exporter_.friction.dry == DryFriction::kComposed; }

  std::string unique(std::string wanted) {
    std::transform(wanted.begin(), wanted.end(), wanted.begin(), [](char letter) {
      return letter >= 'a' && letter <= 'z' ? static_cast<char>(letter - 'a' + 'A') : letter;
    });
    wanted = "REGION_" + wanted;
    std::string name = wanted;
    for (int i = 2; !names_.insert(name).second; ++i) name = fmt::format("{}_{}", wanted, i);
    return name;
  }

  const std::string& joint_name(std::size_t body) const {
    return robot_.tree.bodies[body].joint.name;
  }

  std::vector<std::string> quoted(const Drivetrain& drivetrain) const {
    std::vector<std::string> names;
    for (const std::size_t body : drivetrain.joints) {
      names.push_back(actuator::python_string(joint_name(body)));
    }
    return names;
  }

  void add(const Drivetrain& drivetrain) {
    const SmallVector home = home_posture_rad(robot_.tree, drivetrain.joints);
    const auto transfer = drivetrain.mechanism->transfer(home, SmallVector::Zero(home.size()));
    std::vector<std::string> regions;
    std::vector<std::size_t> places;
    for (std::size_t k = 0; k < drivetrain.actuators.size(); ++k) {
      places.push_back(held(drivetrain, k));
      regions.push_back(held_[places.back()].name);
    }
    if (!transfer) {
      notes_.push_back(fmt::format("{}: not driven, the mechanism is singular nearest to zero",
                                   fmt::join(quoted(drivetrain), ", ")));
      return;
    }
    const SmallMatrix& speeds = transfer->jacobian;
    const SmallMatrix carried = speeds.inverse().transpose();
    groups_ += fmt::format(
        "    {{\n        \"joints\": {},\n        \"drives\": {},\n        \"speeds\": {},\n"
        "        \"torques\": {},\n    }},\n",
        tuple(quoted(drivetrain)), tuple(regions), rows(speeds), rows(carried));
    for (Eigen::Index j = 0; j < home.size(); ++j) {
      const std::size_t body = drivetrain.joints[static_cast<std::size_t>(j)];
      JointFriction sum;
      for (Eigen::Index k = 0; k < speeds.rows(); ++k) {
        const Held& drive = held_[places[static_cast<std::size_t>(k)]];
        const double share = std::abs(speeds(k, j));
        peak_Nm_[body] += share * drive.peak_Nm;
        if (!drive.friction || composes()) continue;
        sum.coulomb_Nm += share * drive.friction->coulomb_Nm;
        sum.breakaway_Nm += share * drive.friction->breakaway_Nm;
        sum.viscous_Nm_s_rad += share * share * drive.friction->viscous_Nm_s_rad;
      }
      of_drives_[body] = sum;
    }
    note_coupling(drivetrain);
    note_postures(drivetrain, speeds);
  }

  /// A joint has each drive's friction as that joint alone would feel it.
  void note_coupling(const Drivetrain& drivetrain) {
    if (drivetrain.joints.size() < 2 || composes() || friction_ == FrictionPlace::kLimits) return;
    notes_.push_back(fmt::format(
        "{} share their drives: limits are each drive's own, but each joint has the friction that "
        "it has while the other rests",
        fmt::join(quoted(drivetrain), ", ")));
  }

  void note_postures(const Drivetrain& drivetrain, const SmallMatrix& held) {
    double least = 1.0;
    double greatest = 1.0;
    for (const SmallVector& posture : postures_in_range(robot_.tree, drivetrain)) {
      const auto there = drivetrain.mechanism->transfer(posture, SmallVector::Zero(posture.size()));
      if (!there) continue;
      for (Eigen::Index k = 0; k < held.rows(); ++k) {
        const double share = there->jacobian.row(k).cwiseAbs().sum() / held.row(k).cwiseAbs().sum();
        least = std::min(least, share);
        greatest = std::max(greatest, share);
      }
    }
    if (greatest - least <= kSameRatio) return;
    notes_.push_back(fmt::format(
        "{} turn at ratios that change with posture ({}): those nearest to zero are held; within "
        "the joints' ranges drives bring {:.4g} to {:.4g} times that torque, and turn faster by "
        "that factor at the same speed of the joints",
        fmt::join(quoted(drivetrain), ", "), drivetrain.mechanism->type(), least, greatest));
  }

  void note_springs() {
    std::vector<std::string> sprung;
    for (const dynamics::Body& body : tree_.bodies) {
      if (body.joint.passive.stiffness > 0) sprung.push_back(body.joint.name);
    }
    if (sprung.empty()) return;
    notes_.push_back(fmt::format(
        "springs of joints ({}) {}", fmt::join(sprung, ", "),
        module_.holds_springs ? "are left to the robot's file" : "act here, explicitly"));
  }

  std::string head(const std::vector<std::string>& origin) const {
    std::vector<std::string> lines = origin;
    lines.push_back(fmt::format("{}: every drive, for {}.", robot_.name, exporter_.simulator));
    lines.push_back(fmt::format("Calls as in {}", module_.source));
    lines.emplace_back(module_.advice);
    lines.push_back(fmt::format(
        "Gains: kp = I w^2, kv = 2 z I w of the joint's armature, w = 2 pi {:.4g} Hz, z = {:.4g} "
        "({}).",
        actuator::kServo_Hz, actuator::kServoDamping, actuator::kServoSource));
    for (const std::string& note : notes_) lines.push_back(note + ".");
    std::string text = actuator::line_comment(lines, "# ");
    for (const Held& drive : held_) {
      std::vector<std::string> own{
          fmt::format("-- {}: {}", drive.name, io::name_in_text(drive.file))};
      own.insert(own.end(), drive.note.begin(), drive.note.end());
      own.insert(own.end(), drive.region.notes.begin(), drive.region.notes.end());
      text += actuator::line_comment(own, "# ");
    }
    return text;
  }

  std::string body() const {
    std::string text = actuator::python_source(composes()) + "\n";
    for (const Held& drive : held_) text += drive.region.text;
    text += "\nGROUPS = (\n" + groups_ + ")\n\nJOINTS = {\n";
    for (std::size_t i = 1; i < tree_.bodies.size(); ++i) text += joint_text(i);
    return text + "}\n" + std::string(kWithin) + std::string(module_.functions);
  }

  std::string joint_text(std::size_t index) const {
    const dynamics::Joint& joint = tree_.bodies[index].joint;
    const dynamics::PassiveForces& own = joint.passive;
    const JointFriction& drives = of_drives_[index];
    const double inertia_kg_m2 = joint.reflected_inertia;
    const bool is_driven = peak_Nm_[index] > 0.0;
    const actuator::ServoGains gains = actuator::servo_gains(inertia_kg_m2);
    return fmt::format(
        R"(    {}: {{
        "peak_torque_Nm": {},
        "armature_kg_m2": {},
        "dry_Nm": {},
        "dry_at_rest_Nm": {},
        "viscous_Nm_s_rad": {},
        "spring": {},
        "gains": {},
    }},
)",
        actuator::python_string(joint.name), number_or_none(is_driven, peak_Nm_[index]),
        number_or_none(robot_.states_rotor(index, joint), inertia_kg_m2),
        own.dry_friction + drives.coulomb_Nm,
        dynamics::friction_limit(own, 0.0) + drives.breakaway_Nm,
        own.damping + drives.viscous_Nm_s_rad,
        own.stiffness > 0 ? fmt::format("({}, {})", own.stiffness, own.rest_position) : "None",
        is_driven && inertia_kg_m2 > 0 ? fmt::format("({}, {})", gains.kp_Nm_rad, gains.kv_Nm_s_rad)
                                       : "None");
  }

  const Robot& robot_;
  const RegionModule& module_;
  const actuator::Exporter& exporter_;
  FrictionPlace friction_;
  std::vector<std::string> notes_;
  dynamics::Tree tree_;
  std::vector<Held> held_;
  std::set<std::string> names_;
  std::string groups_;
  std::vector<JointFriction> of_drives_;  ///< By body.
  std::vector<double> peak_Nm_;           ///< By body; 0: nothing drives it.
};

std::vector<const RegionModule*> every_region_module() {
  return {&region_modules::genesis, &region_modules::pybullet, &region_modules::isaac_gym};
}

}  // namespace

const RegionModule* find_region_module(std::string_view format) {
  for (const RegionModule* module : every_region_module()) {
    if (module->exporter->name == format) return module;
  }
  return nullptr;
}

std::vector<std::string_view> region_module_formats() {
  std::vector<std::string_view> names;
  for (const RegionModule* module : every_region_module()) names.push_back(module->exporter->name);
  return names;
}

Exported region_module_of(const Robot& robot, const RegionModule& module,
                          const std::vector<std::string>& origin, FrictionPlace friction) {
  if (robot.drivetrains.empty()) {
    throw io::SpecError({{robot.name, "/mechanisms", "the robot has no drives to write"}});
  }
  return ModuleText(robot, module, friction).run(origin);
}

}  // namespace torquewright::hopper
