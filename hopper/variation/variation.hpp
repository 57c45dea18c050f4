// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// A property of a robot that may vary.
enum class Quantity {
  kVoltage,  ///< Open-circuit voltage of the full battery, or of the bus where there is none, in V.
  kCurrent,  ///< Peak current of a drive, in A in its document's convention.
  kResistance,  ///< Resistance of a winding, in ohm in its document's convention.
  kMass,        ///< Mass of the whole robot, in kg.
  kRatio,       ///< Size of a gearbox's ratio; its sign stays.
};

/// A quantity of one robot by its name (docs/sweeps.md, "Names").
struct Variable {
  std::string name;  ///< Name such as "knee_ratio", "voltage", "ankle_current_factor".
  Quantity quantity = Quantity::kVoltage;
  std::vector<std::size_t> drives;  ///< Indices among all drives, in their order; empty for kMass.
  bool is_factor = false;           ///< Values are factors on what the documents state.
  double present = 0.0;             ///< Value of the documents; 1 for a factor.
  std::string unit;                 ///< Unit; empty: none.
};

/// Finds the quantity of a name. Throws io::SpecError at `place` (an option's name) where there is
/// none, or where the drives it stands for have different values.
Variable variable_named(const Robot& robot, const std::string& name, const std::string& place);

/// Returns every name that exists for this robot, factors left out.
std::vector<std::string> variable_names(const Robot& robot);

/// Returns the robot with that value and only what follows from it changed (docs/sweeps.md, "What
/// changes"). Robot::battery, the document's text, stays. Throws io::SpecError where the value is
/// not one that documents may hold, or what follows from it is not known.
Robot varied(const Robot& robot, const Variable& variable, double value);

}  // namespace torquewright::hopper
