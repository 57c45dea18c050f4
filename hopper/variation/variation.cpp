// SPDX-License-Identifier: Apache-2.0
#include "hopper/variation/variation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "actuator/motor/gear_transmission.hpp"
#include "actuator/region/operating_conditions.hpp"
#include "actuator/region/torque_at.hpp"
#include "hopper/variation/drive_groups.hpp"
#include "io/faults/refusal.hpp"

namespace torquewright::hopper {
namespace {

using actuator::Actuator;

struct NamedQuantity {
  std::string_view name;
  Quantity quantity;
  std::string_view unit;
  bool is_of_drives;  ///< May be that of some of them; else of the whole robot.
  /// What the documents may hold of it; of a mass, of many bodies.
  double least, most;
};
constexpr NamedQuantity kQuantities[]{{"voltage", Quantity::kVoltage, "V", false, 0.5, 5000.0},
                                      {"current", Quantity::kCurrent, "A", true, 0.01, 5000.0},
                                      {"resistance", Quantity::kResistance, "ohm", true, 1e-5, 1e3},
                                      {"mass", Quantity::kMass, "kg", false, 1e-6, 1e6},
                                      {"ratio", Quantity::kRatio, "", true, 1e-4, 1e4}};
constexpr std::string_view kFactor = "_factor";
constexpr double kSame = 1e-9;  // relative: documents round

double mass_kg(const Robot& robot) {
  double sum_kg = 0.0;
  for (const dynamics::Body& body : robot.tree.bodies) sum_kg += body.inertia.mass_kg;
  return sum_kg;
}

double value_of(const Actuator& drive, Quantity quantity) {
  switch (quantity) {
    case Quantity::kVoltage:
      return actuator::open_circuit_voltage_V(drive, {});
    case Quantity::kCurrent:
      return drive.drive.peak_current_A;
    case Quantity::kResistance:
      return drive.motor.resistance_ohm;
    default:
      return std::abs(drive.transmission.ratio);
  }
}

void scale_voltage(Actuator& drive, double factor) {
  drive.drive.bus_voltage_V *= factor;
  if (!drive.battery) return;
  drive.battery->maximum_voltage_V *= factor;
  for (actuator::ChargePoint& point : drive.battery->cell_open_circuit) point.voltage_V *= factor;
}

/// What the motor may give for long is the same: at the joint it grows with the ratio.
void set_ratio(Actuator& drive, double ratio) {
  const actuator::Transmission before = drive.transmission;
  drive.transmission.ratio = std::copysign(ratio, drive.transmission.ratio);
  actuator::carry_joint_rating(before, drive);
}

void set(Actuator& drive, Quantity quantity, double value) {
  switch (quantity) {
    case Quantity::kVoltage:
      return scale_voltage(drive, value / value_of(drive, quantity));
    case Quantity::kCurrent:
      drive.drive.peak_current_A = value;
      return;
    case Quantity::kResistance:
      drive.motor.resistance_ohm = value;
      return;
    default:
      return set_ratio(drive, value);
  }
}

void scale_mass(Robot& robot, double factor) {
  for (dynamics::Body& body : robot.tree.bodies) {
    body.inertia.mass_kg *= factor;
    body.inertia.inertia_kg_m2 *= factor;
  }
}

/// Throws io::SpecError: no document may hold that value.
void require_legal(const Variable& variable, double value) {
  for (const NamedQuantity& named : kQuantities) {
    if (named.quantity != variable.quantity) continue;
    if (value >= named.least && value <= named.most) return;
    io::refuse(variable.name,
               fmt::format("{:g}{}{} is out of range, must be {:g} to {:g}", value,
                           named.unit.empty() ? "" : " ", named.unit, named.least, named.most));
  }
}

/// Whether the robot itself holds inertias of these rotors.
bool holds_rotors(const Robot& robot, const Drivetrain& drivetrain) {
  const auto weighs = [](double inertia) { return inertia != 0.0; };
  const auto is_loaded = [&](std::size_t body) {
    return weighs(robot.tree.bodies[body].joint.reflected_inertia);
  };
  const std::vector<double>& stated = drivetrain.stated_rotors_kg_m2;
  if (std::any_of(stated.begin(), stated.end(), weighs)) return true;
  return drivetrain.rotors_in_tree &&
         std::any_of(drivetrain.joints.begin(), drivetrain.joints.end(), is_loaded);
}

/// By how much the inertia of each drive at its output has grown.
std::vector<double> inertia_factors(const Robot& robot, const Drivetrain& before,
                                    const Drivetrain& after, const Variable& variable) {
  std::vector<double> factors;
  for (std::size_t i = 0; i < before.actuators.size(); ++i) {
    const double before_kg_m2 = actuator::reflected_inertia_kg_m2(before.actuators[i]);
    const double after_kg_m2 = actuator::reflected_inertia_kg_m2(after.actuators[i]);
    const bool is_same =
        after.actuators[i].transmission.ratio == before.actuators[i].transmission.ratio;
    if (!is_same && after_kg_m2 == before_kg_m2 && holds_rotors(robot, before)) {
      io::refuse(variable.name,
                 fmt::format("the robot states what the rotor of {} weighs, its actuator states "
                             "no rotor inertia: what another ratio makes of it is not known",
                             before.actuator_names[i]));
    }
    factors.push_back(after_kg_m2 == before_kg_m2 ? 1.0 : after_kg_m2 / before_kg_m2);
  }
  return factors;
}

/// Joints that hold the rotors of several drives hold their sum, which says nothing of each.
void require_all_alike(const Drivetrain& drivetrain, const std::vector<double>& factors,
                       const Variable& variable) {
  const bool are_alike = std::all_of(factors.begin(), factors.end(), [&](double factor) {
    return std::abs(factor / factors.front() - 1.0) <= kSame;
  });
  if (are_alike) return;
  io::refuse(variable.name,
             fmt::format("the joints behind {} state what all rotors weigh together: name all of "
                         "its drives at once",
                         drivetrain.actuator_names.front()));
}

/// Limits of joints that are their drives' behind another ratio; of several drives the stricter.
void follow_with_limits(const Drivetrain& old, const Drivetrain& changed, dynamics::Tree& tree) {
  double most = 0.0, least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < old.actuators.size(); ++i) {
    const double factor =
        changed.actuators[i].transmission.ratio / old.actuators[i].transmission.ratio;
    most = std::max(most, factor);
    least = std::min(least, factor);
  }
  for (const std::size_t joint : old.joints) {
    dynamics::JointLimits& limits = tree.bodies[joint].joint.limits;
    if (!limits.owns_speed) limits.speed_max /= most;
    if (!limits.owns_effort) limits.effort_max *= least;
  }
}

/// The rotors of a drivetrain behind another ratio, where the robot itself holds them.
void follow_ratio(const Robot& before, Robot& after, std::size_t index, const Variable& variable) {
  const Drivetrain& old = before.drivetrains[index];
  Drivetrain& changed = after.drivetrains[index];
  const std::vector<double> factors = inertia_factors(before, old, changed, variable);
  for (std::size_t i = 0; i < changed.stated_rotors_kg_m2.size(); ++i) {
    changed.stated_rotors_kg_m2[i] *= factors[i];
  }
  for (std::size_t i = 0; i < old.joints.size(); ++i) {
    dynamics::Joint& joint = after.tree.bodies[old.joints[i]].joint;
    const bool spins = !joint.rotor_spin_kg_m2.isZero(0);
    if (!old.rotors_in_tree && !spins) continue;
    require_all_alike(old, factors, variable);
    if (old.rotors_in_tree) joint.reflected_inertia *= factors.front();
    joint.rotor_spin_kg_m2 *=
        changed.actuators.front().transmission.ratio / old.actuators.front().transmission.ratio;
  }
}

Variable robot_variable(const Robot& robot, const NamedQuantity& named) {
  Variable variable;
  variable.quantity = named.quantity;
  variable.unit = named.unit;
  if (named.quantity != Quantity::kMass) variable.drives = every_drive(robot);
  return variable;
}

/// The first value where all are alike.
std::optional<double> common_value(const Robot& robot, const Variable& variable) {
  if (variable.quantity == Quantity::kMass) return mass_kg(robot);
  std::optional<double> common;
  for (const std::size_t drive : variable.drives) {
    const double value = value_of(drive_at(robot, drive), variable.quantity);
    if (common && std::abs(value / *common - 1.0) > kSame) return std::nullopt;
    common = value;
  }
  return common;
}

std::string values_of(const Robot& robot, const Variable& variable) {
  const std::vector<std::string> names = every_drive_name(robot);
  std::string text;
  for (const std::size_t drive : variable.drives) {
    text += fmt::format("{}{}: {:.6g}{}{}", text.empty() ? "" : ", ", names[drive],
                        value_of(drive_at(robot, drive), variable.quantity),
                        variable.unit.empty() ? "" : " ", variable.unit);
  }
  return text;
}

/// A curve has no current and no winding, and another voltage only where it says at which it holds.
void require_stated(const Robot& robot, const Variable& variable, const std::string& place) {
  const std::vector<std::string> names = every_drive_name(robot);
  for (const std::size_t drive : variable.drives) {
    const std::optional<actuator::Envelope>& envelope = drive_at(robot, drive).envelope;
    const bool is_free =
        variable.quantity == Quantity::kRatio ||
        (variable.quantity == Quantity::kVoltage && envelope && envelope->voltage_V);
    if (!envelope || is_free) continue;
    io::refuse(place, fmt::format("\"{}\" is nothing that {} states: it is known by its curve "
                                  "(/envelope), not by a winding (/motor)",
                                  variable.name, names[drive]));
  }
}

}  // namespace

Variable variable_named(const Robot& robot, const std::string& name, const std::string& place) {
  std::string rest = name;
  const bool is_factor = rest.ends_with(kFactor);
  if (is_factor) rest.resize(rest.size() - kFactor.size());
  std::optional<Variable> found;
  for (const NamedQuantity& named : kQuantities) {
    if (rest == named.name) found = robot_variable(robot, named);
    const std::string ending = fmt::format("_{}", named.name);
    if (!named.is_of_drives || !rest.ends_with(ending)) continue;
    const auto drives = drives_named(robot, rest.substr(0, rest.size() - ending.size()));
    if (!drives) continue;
    found = robot_variable(robot, named);
    found->drives = *drives;
  }
  const bool is_of_none = found && found->quantity != Quantity::kMass && found->drives.empty();
  if (!found || is_of_none) {
    refuse_name(place, name, variable_names(robot), kFactor);
  }
  found->name = name;
  found->is_factor = is_factor;
  if (found->quantity != Quantity::kMass) require_stated(robot, *found, place);
  const std::optional<double> common = common_value(robot, *found);
  if (is_factor) {
    found->present = 1.0;
    found->unit.clear();
  } else if (common) {
    found->present = *common;
  } else {
    io::refuse(place, fmt::format("\"{}\" stands for several drives with different values ({}); "
                                  "name one, or {}{} for all",
                                  name, values_of(robot, *found), name, kFactor));
  }
  return *found;
}

std::vector<std::string> variable_names(const Robot& robot) {
  std::vector<std::string> names;
  for (const NamedQuantity& named : kQuantities) {
    if (named.quantity != Quantity::kMass && robot.drivetrains.empty()) continue;
    names.emplace_back(named.name);
    if (!named.is_of_drives) continue;
    for (const DriveGroup& group : drive_groups(robot)) {
      names.push_back(fmt::format("{}_{}", group.name, named.name));
    }
  }
  return names;
}

Robot varied(const Robot& robot, const Variable& variable, double value) {
  if (!(value > 0.0) || !std::isfinite(value)) {
    io::refuse(variable.name, fmt::format("{:g} is not above 0", value));
  }
  Robot changed = robot;
  if (variable.quantity == Quantity::kMass) {
    const double changed_kg = variable.is_factor ? value * mass_kg(robot) : value;
    if (!std::isfinite(changed_kg)) {
      io::refuse(variable.name, fmt::format("{:g} times the robot's mass is beyond all numbers "
                                            "that are computed with",
                                            value));
    }
    require_legal(variable, changed_kg);
    scale_mass(changed, value / variable.present);
    return changed;
  }
  for (const std::size_t index : variable.drives) {
    Actuator& drive = drive_at(changed, index);
    const double present = value_of(drive, variable.quantity);
    const double wanted = variable.is_factor ? value * present : value;
    require_legal(variable, wanted);
    set(drive, variable.quantity, wanted);
  }
  if (variable.quantity != Quantity::kRatio) return changed;
  for (std::size_t i = 0; i < robot.drivetrains.size(); ++i) {
    follow_ratio(robot, changed, i, variable);
    follow_with_limits(robot.drivetrains[i], changed.drivetrains[i], changed.tree);
  }
  return changed;
}

}  // namespace torquewright::hopper
