// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "identification/balance.hpp"
#include "identification/gram.hpp"
#include "identification/naming.hpp"

namespace torquewright::identification {

/// One equation that a log's channels allow: a measured quantity less what the nominal model says
/// of it, and everything that may explain the difference.
struct Equation {
  std::string quantity;  ///< Whose error it is.
  std::string unit;
  double unit_per_target = 1.0;
  Target target;
  Dictionary dictionary;
  std::vector<Coefficient> always;      ///< Fitted in every model: uncertain values, zero points.
  std::vector<Correction> corrections;  ///< What the first of them stand for.
  bool target_is_motor_side = false;
  bool is_free_load = false;
  std::function<std::vector<Named>(const Fit&)> name;
};

/// Torque on the output, or what it takes of the motor.
Equation torque_equation(const Bench& bench, const Extent& extent, const Orders& orders);

/// The others, each where its channels are there: twist between motor and output, winding voltage
/// against current and speed, bus voltage against bus current.
std::vector<Equation> plain_equations(const Bench& bench, const std::vector<Signals>& signals);

}  // namespace torquewright::identification
