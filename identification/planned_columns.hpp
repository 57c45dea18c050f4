// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "identification/gram.hpp"

namespace torquewright::identification {

/// A parameter of an effect, as a combination of the dictionary's columns. An effect that is not
/// linear stands at a typical value of its nonlinear parameters.
struct PlannedColumn {
  std::string effect;
  std::string parameter;  ///< As in documents where it is the same, with its unit.
  std::string at;         ///< The typical values, in words; empty: linear.
  std::vector<Coefficient::Term> terms;
};

/// The columns of an effect in this dictionary; empty: the equation does not show it.
std::vector<PlannedColumn> planned_columns(const Dictionary& dictionary, const Extent& extent,
                                           const std::string& effect);

/// Every name of the contract.
const std::vector<std::string>& effects_of_the_contract();

/// Sums of the terms along the signals, in the band; samples in rows.
Eigen::MatrixXd planned_rows(const Signals& signals, const Dictionary& dictionary,
                             const std::vector<PlannedColumn>& columns, const Target& target,
                             const BandOptions& options, Eigen::VectorXd* residual = nullptr);

}  // namespace torquewright::identification
