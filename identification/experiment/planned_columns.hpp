// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "identification/forward/hypothesis.hpp"
#include "identification/signals/bench.hpp"
#include "identification/signals/rows.hpp"

namespace torquewright::identification {

/// A parameter of an effect, as what it changes in the torque balance between two hypotheses. An
/// effect that is not linear stands at a typical value of its nonlinear parameters.
struct PlannedColumn {
  std::string effect;
  std::string parameter;  ///< Named as in documents where it is the same, with its unit.
  std::string at;  ///< The typical values at which it stands, in words; empty for a linear effect.
  Hypothesis low, high;  ///< Two hypotheses that differ in the parameter alone.
  double change = 1.0;   ///< The difference of the parameter between them, in its unit.
};

/// Returns the columns of an effect, at values typical for the ranges; empty where the torque
/// balance of such a bench does not show the effect.
std::vector<PlannedColumn> planned_columns(const Bench& bench, const actuator::Ranges& ranges,
                                           const std::string& effect);

/// Names of all effects of the actuator, the rig and the log.
const std::vector<std::string>& effects_with_a_name();

/// (rows x columns) Returns what one unit of each parameter takes from the residual of the torque
/// balance.
Eigen::MatrixXd planned_rows(const Bench& bench, const Rows& rows,
                             const std::vector<PlannedColumn>& columns);

}  // namespace torquewright::identification
