// SPDX-License-Identifier: Apache-2.0
#include "hopper/trials/randomisation.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "actuator/region/operating_conditions.hpp"
#include "hopper/trials/named_things.hpp"

namespace torquewright::hopper {
namespace {

/// Holds a document against a robot; faults gather.
class RandomisationFit {
 public:
  RandomisationFit(const Randomisation& randomisation, const Robot& robot)
      : asked_{randomisation}, robot_{robot} {}

  std::vector<io::Fault> faults() {
    const NamedThings bodies = drawing_bodies(robot_);
    each_once(asked_.body_mass_factor, bodies);
    each_once(asked_.body_inertia_factor, bodies);
    shifts_once(bodies);
    const NamedThings drives = drawing_drives(robot_);
    each_once(asked_.controller_gain_factor, drives);
    each_once(asked_.motor_strength_factor, drives);
    each_once(asked_.further_friction_Nm, drives);
    const NamedThings joints = drawing_joints(robot_);
    each_once(asked_.initial_joint_position_rad, joints);
    each_once(asked_.initial_joint_velocity_rad_s, joints);
    for (const Drivetrain& drivetrain : robot_.drivetrains) {
      for (std::size_t i = 0; i < drivetrain.actuators.size(); ++i) {
        conditions(drivetrain.actuators[i], drivetrain.actuator_names[i]);
      }
    }
    return std::move(faults_);
  }

 private:
  void report(const std::string& path, std::string message) {
    faults_.push_back({asked_.file, path, std::move(message)});
  }

  void take(const NamedRange& range, const NamedThings& things, std::vector<bool>& taken) {
    for (const std::size_t index : meant_by(range, things, asked_.file, faults_)) {
      if (taken[index]) {
        report(range.path,
               fmt::format("{} \"{}\" has a range already", things.what, things.names[index]));
      }
      taken[index] = true;
    }
  }

  void each_once(const std::vector<NamedRange>& ranges, const NamedThings& things) {
    std::vector<bool> taken(things.names.size());
    for (const NamedRange& range : ranges) take(range, things, taken);
  }

  void shifts_once(const NamedThings& bodies) {
    std::array<std::vector<bool>, 3> taken;
    taken.fill(std::vector<bool>(bodies.names.size()));
    for (const ShiftRange& shift : asked_.center_of_mass_shift_m) {
      const std::size_t faults_before = faults_.size();
      for (std::size_t axis = 0; axis < 3; ++axis) {
        // A name that is wrong is so along every axis: said once.
        if (shift.along[axis] && faults_.size() == faults_before) {
          take(shift.of_bodies, bodies, taken[axis]);
        }
      }
    }
  }

  void conditions(const actuator::Actuator& drive, const std::string& name) {
    actuator::OperatingConditions charged;
    if (asked_.state_of_charge) {
      charged.state_of_charge = asked_.state_of_charge->least;
      objected("/state_of_charge", drive, name, charged);
    }
    if (!asked_.winding_temperature_K) return;
    const Range& range = *asked_.winding_temperature_K;
    for (const auto& [end, at_K] :
         {std::pair{"least", range.least}, {"greatest", range.greatest}}) {
      actuator::OperatingConditions warm;
      warm.winding_temperature_K = at_K;
      objected(fmt::format("/winding_temperature_K/{}", end), drive, name, warm);
    }
    if (drive.thermal && range.greatest > drive.thermal->winding_limit_K) {
      report("/winding_temperature_K/greatest",
             fmt::format("{} K is above what the winding of \"{}\" bears, {} K", range.greatest,
                         name, drive.thermal->winding_limit_K));
    }
  }

  void objected(const std::string& path, const actuator::Actuator& drive, const std::string& name,
                const actuator::OperatingConditions& conditions) {
    for (const std::string& sentence : actuator::objections(drive, conditions)) {
      report(path, fmt::format("drive \"{}\": {}", name, sentence));
    }
  }

  const Randomisation& asked_;
  const Robot& robot_;
  std::vector<io::Fault> faults_;
};

}  // namespace

void require_fits(const Randomisation& randomisation, const Robot& robot) {
  std::vector<io::Fault> faults = RandomisationFit(randomisation, robot).faults();
  if (!faults.empty()) throw io::SpecError(std::move(faults));
}

}  // namespace torquewright::hopper
