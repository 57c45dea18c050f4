// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// What of a robot may be another.
enum class Quantity {
  kVoltage,     ///< V, open circuit of the full battery, or of the bus where there is none.
  kCurrent,     ///< A, peak of a drive, in its document's convention.
  kResistance,  ///< ohm, of a winding, in its document's convention.
  kMass,        ///< kg, of the whole robot.
  kRatio,       ///< Of a gearbox, in size; its sign stays.
};

/// A quantity of one robot by its name (docs/sweeps.md, "Names").
struct Variable {
  std::string name;  ///< "knee_ratio", "voltage", "ankle_current_factor".
  Quantity quantity = Quantity::kVoltage;
  std::vector<std::size_t> drives;  ///< Of all drives in their order; of kMass none.
  bool is_factor = false;           ///< Values are factors on what the documents have.
  double present = 0.0;             ///< What the documents have; 1 of a factor.
  std::string unit;                 ///< Empty: none.
};

/// The quantity that the name stands for. Throws io::SpecError at `place` (an option's name): there
/// is none of that name, or the drives it stands for have different values.
Variable variable_named(const Robot& robot, const std::string& name, const std::string& place);

/// Every name that there is for this robot, factors left out.
std::vector<std::string> variable_names(const Robot& robot);

/// The robot with that value and nothing else changed but what follows from it (docs/sweeps.md,
/// "What changes"). Robot::battery, the document's text, stays. Throws io::SpecError: the value is
/// not one that documents may hold, or what follows from it is not known.
Robot varied(const Robot& robot, const Variable& variable, double value);

}  // namespace torquewright::hopper
