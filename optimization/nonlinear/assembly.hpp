// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "optimization/nonlinear/program.hpp"

namespace torquewright::optimization {

/// Row and column of an element of a sparse matrix.
struct Place {
  int row = 0;
  int column = 0;

  friend bool operator==(const Place&, const Place&) = default;
};

/// Values of a program at one point.
struct Evaluation {
  std::vector<double> values;  ///< Values of the unknowns, within their bounds.
  double objective = 0.0;
  std::vector<double> rows;        ///< Values of the rows over their scales.
  double largest_violation = 0.0;  ///< Largest violation of the rows over their scales.
  bool is_finite = false;          ///< Whether objective and rows are finite.
};

/// A program as a solver sees it: one vector of unknowns over their scales, rows over theirs, the
/// objective over the largest scale of the costs; derivatives as elements of sparse matrices, each
/// element once. Blocks of rows scatter to places that are found once; evaluation allocates nothing
/// (docs/derivations/nonlinear_program.md eq. (2) to (4)). The program must outlive it. Vectors
/// have the sizes of the program; `scaled` is one of unknowns. Exceptions of the program's rows
/// pass through.
class Assembly {
 public:
  explicit Assembly(const Program& program);

  /// Largest scale of the costs; 1 without costs.
  double objective_scale() const { return objective_scale_; }
  /// Places of the entries of jacobian(): block by block, column by column.
  const std::vector<Place>& jacobian_places() const { return jacobian_places_; }
  /// Places of the entries of hessian(): lower triangle, by row and column.
  const std::vector<Place>& hessian_places() const { return hessian_places_; }

  /// Evaluates the program, once as long as the point stays the same. Unknowns beyond their bounds,
  /// such as by rounding of their scales, count as at their bounds.
  const Evaluation& at(std::span<const double> scaled);
  /// Writes every element of the gradient; false where one is not finite.
  bool gradient(std::span<const double> scaled, std::span<double> slopes);
  bool jacobian(std::span<const double> scaled, std::span<double> entries);
  /// Writes the second derivatives of objective_factor times the objective plus multipliers^T rows,
  /// all scaled.
  bool hessian(std::span<const double> scaled, double objective_factor,
               std::span<const double> multipliers, std::span<double> entries);

 private:
  struct Block {
    const Rows* rows;
    std::size_t first_row;             ///< First row in the program; 0 for costs.
    std::size_t first_entry;           ///< First entry in the Jacobian; 0 for costs.
    std::vector<std::size_t> hessian;  ///< Entries by local (row >= column), column by column.
    bool is_constant = false;          ///< Whether its entries of the Jacobian are constant.
  };

  void make_room(const Rows& rows);
  void place_jacobian(const Block& block);
  void place_hessian();
  void move_to(std::span<const double> scaled);
  void evaluate();
  void gather(const Rows& rows);
  void scatter_slopes(Block& block);
  void scatter_curvatures(const Block& block, std::span<double> entries);

  const Program& program_;
  double objective_scale_ = 1.0;
  std::vector<Block> rows_;
  std::vector<Block> costs_;
  std::vector<Place> jacobian_places_;
  std::vector<Place> hessian_places_;
  std::vector<double> scaled_;  ///< The point that `here_.values` belong to; empty at first.
  Evaluation here_;
  bool is_evaluated_ = false;
  std::vector<double> jacobian_;
  std::vector<double> local_values_;  ///< Memory for the largest block, as those below.
  std::vector<double> local_rows_;
  std::vector<double> local_multipliers_;
  std::vector<double> local_matrix_;
};

/// Returns the largest violation of rows over their scales, where `rows` holds them by row of the
/// program.
double largest_violation(const Program& program, std::span<const double> rows);

}  // namespace torquewright::optimization
