// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace torquewright::optimization {

/// Bounds of a number. Both ends belong; equal ends make an equation, infinite ones are no bound.
struct Bounds {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
};

/// Unknowns of one kind: where a search begins, their bounds, and how large they typically are
/// (dimension of the unknown; the solver works on value over scale, so that a scale ten times off
/// costs iterations and a thousand times costs the solution).
struct VariableSet {
  std::string name;
  std::vector<double> values;
  std::vector<Bounds> bounds;
  std::vector<double> scales;
};

/// Rows that depend on a few unknowns. Local vectors and matrices go by the order of variables(). A
/// row is continuous with its first and second derivatives wherever variables are in bounds.
class Rows {
 public:
  using VectorIn = Eigen::Ref<const Eigen::VectorXd>;
  using VectorOut = Eigen::Ref<Eigen::VectorXd>;
  using MatrixOut = Eigen::Ref<Eigen::MatrixXd>;

  /// `bounds` and `scales` are by row; `variables` are numbers in the program, none twice.
  Rows(std::string name, std::vector<int> variables, std::vector<Bounds> bounds,
       std::vector<double> scales);
  virtual ~Rows() = default;
  Rows(const Rows&) = delete;
  Rows& operator=(const Rows&) = delete;

  /// Name of what they state, for people: "knee: region".
  const std::string& name() const { return name_; }
  const std::vector<int>& variables() const { return variables_; }
  const std::vector<Bounds>& bounds() const { return bounds_; }
  const std::vector<double>& scales() const { return scales_; }
  Eigen::Index size() const { return static_cast<Eigen::Index>(bounds_.size()); }
  Eigen::Index width() const { return static_cast<Eigen::Index>(variables_.size()); }

  /// Computes the rows (size x 1) from the variables (width x 1).
  virtual void values(const VectorIn& x, VectorOut rows) const = 0;
  /// Writes every element of the Jacobian (size x width).
  virtual void slopes(const VectorIn& x, MatrixOut jacobian) const = 0;
  /// Writes every element of the second derivatives of multipliers^T rows (width x width),
  /// symmetric.
  virtual void curvatures(const VectorIn& x, const VectorIn& multipliers,
                          MatrixOut hessian) const = 0;
  /// Whether the rows are affine: then they have no curvatures, and the solver keeps no room for
  /// them.
  virtual bool is_affine() const { return false; }

 private:
  std::string name_;
  std::vector<int> variables_;
  std::vector<Bounds> bounds_;
  std::vector<double> scales_;
};

/// A nonlinear program: minimise the sum of the costs, so that variables and rows lie in their
/// bounds. Sparse: what rows do not share is not coupled. A cost is one row whose bounds are
/// ignored; the solver works on the sum of the costs over the largest of their scales.
class Program {
 public:
  /// Adds variables and returns the number of the first of them. std::invalid_argument, naming the
  /// set and the element, where sizes differ, a number is not finite, bounds are crossed or a scale
  /// is not positive.
  int add(VariableSet variables);
  void add_rows(std::unique_ptr<const Rows> rows);
  void add_cost(std::unique_ptr<const Rows> cost);

  int variable_count() const { return static_cast<int>(starts_.size()); }
  int row_count() const { return row_count_; }
  int equation_count() const;       ///< Number of rows whose bounds are equal.
  int free_variable_count() const;  ///< Number of variables whose bounds are not equal.
  /// Starts of all variables, by their number.
  const std::vector<double>& starts() const { return starts_; }
  const std::vector<Bounds>& bounds() const { return bounds_; }
  const std::vector<double>& scales() const { return scales_; }
  /// Sets of variables, in the order in which they were added.
  const std::vector<VariableSet>& sets() const { return sets_; }
  const std::vector<std::unique_ptr<const Rows>>& rows() const { return rows_; }
  const std::vector<std::unique_ptr<const Rows>>& costs() const { return costs_; }

 private:
  std::vector<VariableSet> sets_;
  std::vector<double> starts_;
  std::vector<Bounds> bounds_;
  std::vector<double> scales_;
  std::vector<std::unique_ptr<const Rows>> rows_;
  std::vector<std::unique_ptr<const Rows>> costs_;
  int row_count_ = 0;
};

/// Gathers a row's variables out of all of the program's.
Eigen::VectorXd gathered(const Rows& rows, const std::vector<double>& all);

}  // namespace torquewright::optimization
