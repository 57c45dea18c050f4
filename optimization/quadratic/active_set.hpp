// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <vector>

namespace torquewright::optimization {

/// The dual method of Goldfarb and Idnani (Mathematical Programming 27, 1983) for a strictly convex
/// cost: it walks from one minimum under some active bounds to the next, the cost always rising,
/// and begins with the bounds that were active last. Rows whose length is 0 are looked at, and can
/// but contradict. Memory is taken where sizes grow alone.
class ActiveSet {
 public:
  enum class End { kSolved, kInfeasible, kStalled };

  /// Room for so many unknowns and rows. Forgets what was active where the rows' number changes.
  void resize(Eigen::Index unknowns, Eigen::Index rows);
  void forget() { active_.clear(); }

  /// The program, which the caller fills: of the unknowns' corner (top left) and rows.
  struct Problem {
    Eigen::MatrixXd inverse_root;  ///< J (r x r): J J^T is the inverse of the cost.
    Eigen::VectorXd slope;         ///< (r x 1)
    Eigen::MatrixXd rows;          ///< (m x r)
    Eigen::VectorXd lower, upper;  ///< (m x 1)
    Eigen::VectorXd lengths;       ///< (m x 1): of the rows; 0 of those that feel no unknown.
    /// (m x 1): what rounding may leave of a row beside what `lengths` and x make of it.
    Eigen::VectorXd roundings;
  };
  Problem& problem() { return problem_; }

  End solve();

  auto x() const { return x_.head(unknowns_); }
  /// Bounds that are active: rows, and +1 at lower, -1 at upper ones; their multipliers, >= 0, of
  /// rows that are turned so that they are bounded below.
  std::size_t active_count() const { return active_.size(); }
  Eigen::Index active_row(std::size_t i) const { return active_[i].row; }
  double multiplier(std::size_t i) const {
    return -active_[i].side * std::max(0.0, multipliers_[static_cast<Eigen::Index>(i)]);
  }
  int steps() const { return steps_; }
  /// kInfeasible: adds rows and the factors with which their sum feels no unknown.
  void contradiction(std::vector<Eigen::Index>& rows, std::vector<double>& factors) const;

 private:
  struct Bound {
    Eigen::Index row;
    double side;
  };

  void begin();
  Bound most_violated() const;
  void turn(const Bound& bound);
  double bound_of(const Bound& bound) const;
  bool add(const Bound& bound);
  void drop(Eigen::Index place);
  void minimise();
  End enter(const Bound& bound);

  Problem problem_;
  Eigen::Index unknowns_ = 0, rows_ = 0;
  std::vector<Bound> active_, before_;
  Eigen::MatrixXd basis_;   ///< J, turned so that its first columns span the active rows.
  Eigen::MatrixXd factor_;  ///< R, upper triangular: J^T N = [R; 0].
  Eigen::VectorXd x_, multipliers_, turned_, answer_, normal_;
  Bound contradicted_{-1, 0.0};
  int steps_ = 0;
};

}  // namespace torquewright::optimization
