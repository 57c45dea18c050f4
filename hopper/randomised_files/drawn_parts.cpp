// SPDX-License-Identifier: Apache-2.0
#include "hopper/randomised_files/drawn_parts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "hopper/trials/named_things.hpp"
#include "robot/model/mechanism_reach.hpp"

namespace torquewright::hopper {
namespace {

constexpr double kNoShare = 1e-9;  // of a joint's speed: it does not turn the drive

std::vector<PartsRange> by_name(const std::vector<NamedRange>& ranges, const NamedThings& things,
                                const std::string& file) {
  std::vector<PartsRange> all;
  std::vector<io::Fault> none;
  for (const NamedRange& range : ranges) {
    PartsRange part{range.range, {}};
    for (const std::size_t i : meant_by(range, things, file, none)) {
      part.names.push_back(things.names[i]);
    }
    all.push_back(std::move(part));
  }
  return all;
}

std::vector<BodyShift> shifts_of(const Randomisation& stated, const Robot& robot) {
  std::vector<BodyShift> all;
  std::vector<io::Fault> none;
  const NamedThings bodies = drawing_bodies(robot);
  for (const ShiftRange& shift : stated.center_of_mass_shift_m) {
    for (const std::size_t i : meant_by(shift.of_bodies, bodies, stated.file, none)) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (shift.along[axis]) all.push_back({bodies.names[i], axis, shift.of_bodies.range});
      }
    }
  }
  return all;
}

/// The range of each drive, in the order of drive_names(); nothing where none is stated.
std::vector<std::optional<Range>> by_drive(const std::vector<NamedRange>& ranges,
                                           const Robot& robot, const std::string& file) {
  const NamedThings drives = drawing_drives(robot);
  std::vector<std::optional<Range>> all(drives.names.size());
  std::vector<io::Fault> none;
  for (const NamedRange& range : ranges) {
    for (const std::size_t i : meant_by(range, drives, file, none)) all[i] = range.range;
  }
  return all;
}

/// What a joint gets of the drives that it turns.
class JointRanges {
 public:
  explicit JointRanges(const Robot& robot) : robot_(robot) {}

  /// A factor that the joint's drives share as far as they go.
  void take_hull(const std::string& joint, const Range& range, double share) {
    if (share <= kNoShare) return;
    const auto [place, is_new] = by_joint_.try_emplace(joint, range);
    if (is_new) return;
    place->second.least = std::min(place->second.least, range.least);
    place->second.greatest = std::max(place->second.greatest, range.greatest);
  }

  /// A torque at the drive, by virtual work.
  void add(const std::string& joint, const Range& range, double share) {
    if (share <= kNoShare) return;
    Range& sum = by_joint_[joint];
    sum.least += share * range.least;
    sum.greatest += share * range.greatest;
  }

  /// In the order of the bodies; joints of one range stand together.
  std::vector<PartsRange> all() const {
    std::vector<PartsRange> ranges;
    for (const dynamics::Body& body : robot_.tree.bodies) {
      const auto found = by_joint_.find(body.joint.name);
      if (found == by_joint_.end()) continue;
      const Range& range = found->second;
      const auto same = std::find_if(ranges.begin(), ranges.end(), [&](const PartsRange& each) {
        return each.range.least == range.least && each.range.greatest == range.greatest;
      });
      if (same != ranges.end()) {
        same->names.push_back(found->first);
      } else {
        ranges.push_back({range, {found->first}});
      }
    }
    return ranges;
  }

 private:
  const Robot& robot_;
  std::map<std::string, Range> by_joint_;
};

struct DrivesToJoints {
  const Robot& robot;
  DrawnParts& parts;

  void run() {
    const Randomisation& stated = *parts.stated;
    const auto gains = by_drive(stated.controller_gain_factor, robot, stated.file);
    const auto strengths = by_drive(stated.motor_strength_factor, robot, stated.file);
    const auto frictions = by_drive(stated.further_friction_Nm, robot, stated.file);
    JointRanges gain(robot), strength(robot), friction(robot);
    std::size_t drive = 0;
    for (const Drivetrain& drivetrain : robot.drivetrains) {
      const SmallVector home = home_posture_rad(robot.tree, drivetrain.joints);
      const auto transfer = drivetrain.mechanism->transfer(home, SmallVector::Zero(home.size()));
      bool is_shared = false;
      for (std::size_t k = 0; k < drivetrain.actuators.size(); ++k, ++drive) {
        if (!gains[drive] && !strengths[drive] && !frictions[drive]) continue;
        is_shared = is_shared || drivetrain.joints.size() > 1;
        for (std::size_t j = 0; j < drivetrain.joints.size(); ++j) {
          const double share = transfer ? std::abs(transfer->jacobian(static_cast<Eigen::Index>(k),
                                                                      static_cast<Eigen::Index>(j)))
                                        : 0.0;
          const std::string& joint = robot.tree.bodies[drivetrain.joints[j]].joint.name;
          if (gains[drive]) gain.take_hull(joint, *gains[drive], share);
          if (strengths[drive]) strength.take_hull(joint, *strengths[drive], share);
          if (frictions[drive]) friction.add(joint, *frictions[drive], share);
        }
      }
      if (is_shared) note_shared(drivetrain);
    }
    parts.gain_factor = gain.all();
    parts.strength_factor = strength.all();
    parts.dry_friction_Nm = friction.all();
  }

  void note_shared(const Drivetrain& drivetrain) {
    parts.notes.push_back(fmt::format(
        "{} turn several joints: each joint draws for itself what they have at the posture nearest "
        "to zero (friction by virtual work, gains and strengths over all their ranges)",
        fmt::join(drivetrain.actuator_names, ", ")));
  }
};

std::string words(const Range& range) {
  return fmt::format("{:.6g} to {:.6g}", range.least, range.greatest);
}

void note_left_out(DrawnParts& parts) {
  const Randomisation& stated = *parts.stated;
  const auto leave = [&](const char* key, const std::string& why) {
    parts.left_out.push_back(fmt::format("{}: {}", key, why));
  };
  if (stated.state_of_charge) {
    leave("state_of_charge",
          words(*stated.state_of_charge) + ", of batteries that no file here has");
  }
  if (stated.winding_temperature_K) {
    leave("winding_temperature_K", words(*stated.winding_temperature_K) +
                                       " K: clip(..., temperature=...) of `actuator mor --format "
                                       "python` takes it");
  }
  if (stated.latency_s) {
    leave("latency_s", words(*stated.latency_s) + " s, the environment's own delay");
  }
  if (stated.ground_height_m) {
    leave("ground_height_m", words(*stated.ground_height_m) + " m, the terrain's");
  }
  const SensorNoiseLevels& noise = stated.noise;
  if (noise.gravity_direction > 0 || noise.base_rate_rad_s > 0 || noise.base_position_m > 0 ||
      noise.base_velocity_m_s > 0 || noise.joint_position_rad > 0 ||
      noise.joint_velocity_rad_s > 0) {
    leave("sensor_noise", "of observations, not of the robot");
  }
}

}  // namespace

DrawnParts drawn_parts(const Randomisation& randomisation, const Robot& robot) {
  DrawnParts parts;
  parts.stated = &randomisation;
  const NamedThings bodies = drawing_bodies(robot), joints = drawing_joints(robot);
  const std::string& file = randomisation.file;
  parts.mass_factor = by_name(randomisation.body_mass_factor, bodies, file);
  parts.inertia_factor = by_name(randomisation.body_inertia_factor, bodies, file);
  parts.center_of_mass_m = shifts_of(randomisation, robot);
  parts.start_position_rad = by_name(randomisation.initial_joint_position_rad, joints, file);
  parts.start_velocity_rad_s = by_name(randomisation.initial_joint_velocity_rad_s, joints, file);
  parts.drive_strength = by_name(randomisation.motor_strength_factor, drawing_drives(robot), file);
  DrivesToJoints{robot, parts}.run();
  note_left_out(parts);
  return parts;
}

}  // namespace torquewright::hopper
