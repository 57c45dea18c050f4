// SPDX-License-Identifier: Apache-2.0
#include "hopper/trials/trial.hpp"

#include <algorithm>
#include <stdexcept>

#include "hopper/trials/counted_random.hpp"
#include "hopper/trials/named_things.hpp"

namespace torquewright::hopper {
namespace {

double drawn_from(const Range& range, std::uint64_t key) {
  return std::min(range.least + (range.greatest - range.least) * uniform_of(key), range.greatest);
}

/// Draws the numbers of one trial, each by its key.
class TrialDraw {
 public:
  TrialDraw(std::uint64_t seed, std::size_t number)
      : key_{mixed_in(seed, static_cast<std::uint64_t>(number))} {}

  std::optional<double> one(const std::optional<Range>& range, std::string_view quantity) const {
    if (!range) return std::nullopt;
    return drawn_from(*range, mixed_in(key_, quantity));
  }

  /// `otherwise` for those that no range is for.
  Eigen::VectorXd each(const std::vector<NamedRange>& ranges, const NamedThings& things,
                       std::string_view quantity, double otherwise) const {
    const std::uint64_t key = mixed_in(key_, quantity);
    Eigen::VectorXd numbers =
        Eigen::VectorXd::Constant(static_cast<Eigen::Index>(things.names.size()), otherwise);
    for (const NamedRange& range : ranges) {
      for (const std::size_t index : known(range, things)) {
        numbers[static_cast<Eigen::Index>(index)] =
            drawn_from(range.range, mixed_in(key, things.names[index]));
      }
    }
    return numbers;
  }

  Eigen::Matrix3Xd shifts(const std::vector<ShiftRange>& ranges, const NamedThings& bodies) const {
    const std::uint64_t key = mixed_in(key_, "center_of_mass_shift_m");
    Eigen::Matrix3Xd numbers =
        Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(bodies.names.size()));
    for (const ShiftRange& shift : ranges) {
      for (const std::size_t index : known(shift.of_bodies, bodies)) {
        const std::uint64_t of_body = mixed_in(key, bodies.names[index]);
        for (std::size_t axis = 0; axis < 3; ++axis) {
          if (!shift.along[axis]) continue;
          numbers(static_cast<Eigen::Index>(axis), static_cast<Eigen::Index>(index)) =
              drawn_from(shift.of_bodies.range, mixed_in(of_body, std::uint64_t{axis}));
        }
      }
    }
    return numbers;
  }

 private:
  static std::vector<std::size_t> known(const NamedRange& range, const NamedThings& things) {
    std::vector<io::Fault> faults;
    std::vector<std::size_t> indices = meant_by(range, things, "", faults);
    if (!faults.empty()) throw std::invalid_argument("draw_trial: " + faults.front().message);
    return indices;
  }

  std::uint64_t key_;
};

void scale_voltages(Robot& robot, double factor) {
  for (Drivetrain& drivetrain : robot.drivetrains) {
    for (actuator::Actuator& drive : drivetrain.actuators) {
      drive.drive.bus_voltage_V *= factor;
      if (!drive.battery) continue;
      for (actuator::ChargePoint& point : drive.battery->cell_open_circuit) {
        point.voltage_V *= factor;
      }
    }
  }
}

}  // namespace

Trial draw_trial(const Randomisation& randomisation, const Robot& robot, std::uint64_t seed,
                 std::size_t number) {
  const TrialDraw draw(seed, number);
  const NamedThings bodies = drawing_bodies(robot);
  const NamedThings drives = drawing_drives(robot);
  const NamedThings joints = drawing_joints(robot);
  const Randomisation& from = randomisation;
  Trial trial;
  trial.seed = seed;
  trial.number = number;
  trial.mass_factor = draw.one(from.total_mass_factor, "total_mass_factor").value_or(1.0) *
                      draw.each(from.body_mass_factor, bodies, "body_mass_factor", 1.0);
  trial.inertia_factor = draw.each(from.body_inertia_factor, bodies, "body_inertia_factor", 1.0);
  trial.center_of_mass_shift_m = draw.shifts(from.center_of_mass_shift_m, bodies);
  trial.controller_gain_factor =
      draw.each(from.controller_gain_factor, drives, "controller_gain_factor", 1.0);
  trial.motor_strength_factor =
      draw.each(from.motor_strength_factor, drives, "motor_strength_factor", 1.0);
  trial.further_friction_Nm =
      draw.each(from.further_friction_Nm, drives, "further_friction_Nm", 0.0);
  trial.friction_coefficient = draw.one(from.friction_coefficient, "friction_coefficient");
  trial.restitution = draw.one(from.restitution, "restitution");
  trial.ground_height_m = draw.one(from.ground_height_m, "ground_height_m").value_or(0.0);
  trial.latency_s = draw.one(from.latency_s, "latency_s").value_or(0.0);
  trial.state_of_charge = draw.one(from.state_of_charge, "state_of_charge");
  trial.bus_voltage_factor = draw.one(from.bus_voltage_factor, "bus_voltage_factor").value_or(1.0);
  trial.winding_temperature_K = draw.one(from.winding_temperature_K, "winding_temperature_K");
  trial.initial_joint_position_rad =
      draw.each(from.initial_joint_position_rad, joints, "initial_joint_position_rad", 0.0);
  trial.initial_joint_velocity_rad_s =
      draw.each(from.initial_joint_velocity_rad_s, joints, "initial_joint_velocity_rad_s", 0.0);
  return trial;
}

Robot perturbed(const Robot& robot, const Trial& trial) {
  const auto bodies = static_cast<Eigen::Index>(robot.tree.bodies.size());
  if (trial.mass_factor.size() != bodies || trial.inertia_factor.size() != bodies ||
      trial.center_of_mass_shift_m.cols() != bodies) {
    throw std::invalid_argument("perturbed: the trial is of another robot");
  }
  Robot changed = robot;
  for (Eigen::Index i = 0; i < bodies; ++i) {
    dynamics::RigidInertia& inertia = changed.tree.bodies[static_cast<std::size_t>(i)].inertia;
    inertia.mass_kg *= trial.mass_factor[i];
    inertia.inertia_kg_m2 *= trial.inertia_factor[i];
    inertia.center_of_mass_m += trial.center_of_mass_shift_m.col(i);
  }
  for (ContactPoint& contact : changed.contacts) {
    contact.friction_coefficient =
        trial.friction_coefficient.value_or(contact.friction_coefficient);
    contact.restitution = trial.restitution.value_or(contact.restitution);
  }
  scale_voltages(changed, trial.bus_voltage_factor);
  return changed;
}

actuator::OperatingConditions conditions_of(const Trial& trial,
                                            actuator::OperatingConditions conditions) {
  if (conditions.bus_voltage_V) *conditions.bus_voltage_V *= trial.bus_voltage_factor;
  if (trial.state_of_charge) {
    conditions.bus_voltage_V.reset();
    conditions.state_of_charge = trial.state_of_charge;
  }
  if (trial.winding_temperature_K) conditions.winding_temperature_K = trial.winding_temperature_K;
  return conditions;
}

}  // namespace torquewright::hopper
