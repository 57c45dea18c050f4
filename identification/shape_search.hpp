// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "identification/equation.hpp"
#include "identification/shape.hpp"
#include "optimization/fit/local_fit.hpp"

namespace torquewright::identification {

/// A member with curved parameters, and where they stand among all of them.
struct ShapedMember {
  std::size_t place;
  std::string effect;
  std::size_t first;
  std::size_t count;
};

/// The least squared error over the shapes of a model's curved members, everything linear solved
/// for at each. Keeps references to what it is given. docs/derivations/identification.md section 7.
class ShapeSearch {
 public:
  ShapeSearch(const Bench& bench, const Equation& equation, const Fit& model,
              const std::vector<Signals>& signals, const std::vector<std::size_t>& fold_of_run,
              const BandOptions& band);

  bool is_empty() const { return members_.empty(); }
  const std::vector<ShapeParameter>& parameters() const { return parameters_; }
  const std::vector<ShapedMember>& members() const { return members_; }
  const std::shared_ptr<Balance>& balance() const { return balance_; }

  optimization::LocalFit search();

  /// A member's part of a shape.
  static std::vector<double> values(const ShapedMember& member, std::span<const double> shape);

 private:
  double loss(std::span<const double> shape) const;
  std::vector<double> weights_of(std::size_t place) const;
  bool is_shaped(std::size_t place) const;
  std::vector<Column> fixed_columns() const;
  void combine(std::size_t coefficient, const Signals& signals, std::vector<double>& out) const;
  Eigen::MatrixXd rows_of(const std::vector<Column>& columns, const Target& target) const;

  std::shared_ptr<Balance> balance_;
  const Equation& equation_;
  const Fit& model_;
  const std::vector<Signals>& signals_;
  const std::vector<std::size_t>& fold_of_run_;
  BandOptions band_;
  std::vector<ShapedMember> members_;
  std::vector<ShapeParameter> parameters_;
  Eigen::MatrixXd fixed_;
};

}  // namespace torquewright::identification
