// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace torquewright::hopper {

/// Rows of a file, counted from the present one, whose mean a reading takes.
struct RowSpan {
  int first = 0;
  int last = 0;
};

/// Evidence on the row that a column belongs to.
struct RowEvidence {
  bool differs = false;     ///< The readings differ in some sample.
  double log_odds = 0.0;    ///< Natural logarithm of the odds of the row before over its own.
  double times_less = 1.0;  ///< How many times less the row before leaves than its own, rms.

  /// Whether the columns belong to their own row, by odds beyond 1000 to 1: a wrong reading costs
  /// alike both ways, and one in a thousand is put up with.
  bool is_own() const;
  bool is_before() const;
  /// Whether the evidence decides nothing, though the readings differ.
  bool is_open() const { return differs && !is_own() && !is_before(); }
};

/// Two readings of a column, that it belongs to its own row and to the row before, by what physics
/// leaves of each. Gaussian errors of unknown size by coordinate, as many as there are rows in
/// which the readings differ. docs/derivations/whole_body_check.md, eqs. (23)-(25).
class RowComparison {
 public:
  static constexpr int kFirst = -1;  ///< First row that a span may name.
  static constexpr int kLast = 2;    ///< Last row that a span may name.
  using Left = std::array<Eigen::VectorXd, kLast - kFirst + 1>;

  /// Takes the spans of either reading; the best of each counts.
  RowComparison(std::vector<RowSpan> own, std::vector<RowSpan> before)
      : own_(std::move(own)), before_(std::move(before)) {}

  /// Adds what one sample leaves, by coordinate, if the column is taken from `kFirst + index` rows
  /// on. Rows that no span names may be empty, but for 0 and 1.
  void add(const Left& left);

  RowEvidence evidence() const;

 private:
  static const Eigen::VectorXd& at(const Left& left, int row);
  void allocate(Eigen::Index size);

  std::vector<RowSpan> own_;
  std::vector<RowSpan> before_;
  /// Sums of squares by span, own ones first, and by coordinate.
  std::vector<Eigen::VectorXd> squares_;
  Eigen::VectorXd second_;  ///< Moments of the difference of the readings.
  Eigen::VectorXd fourth_;
};

}  // namespace torquewright::hopper
