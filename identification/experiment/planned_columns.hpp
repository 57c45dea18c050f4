// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "identification/forward/hypothesis.hpp"
#include "identification/signals/bench.hpp"
#include "identification/signals/rows.hpp"

namespace torquewright::identification {

/// A parameter of an effect: what it changes in the torque balance between two hypotheses. An
/// effect that is not linear stands at a typical value of its nonlinear parameters.
struct PlannedColumn {
  std::string effect;
  std::string parameter;  ///< As in documents where it is the same, with its unit.
  std::string at;         ///< The typical values, in words; empty: linear.
  Hypothesis low, high;   ///< They differ in the parameter ...
  double change = 1.0;    ///< ... by this, in its unit.
};

/// The columns of an effect, typical for what the ranges cover; empty: the torque balance of such a
/// bench does not show it.
std::vector<PlannedColumn> planned_columns(const Bench& bench, const actuator::Ranges& ranges,
                                           const std::string& effect);

/// Of the actuator, the rig and the log.
const std::vector<std::string>& effects_with_a_name();

/// (rows x columns) What one unit of each parameter takes from the residual of the torque balance.
Eigen::MatrixXd planned_rows(const Bench& bench, const Rows& rows,
                             const std::vector<PlannedColumn>& columns);

}  // namespace torquewright::identification
