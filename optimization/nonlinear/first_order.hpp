// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "optimization/nonlinear/solve.hpp"

namespace torquewright::optimization {

/// Returns by how much the least objective grows from a program to one that is changed a little, to
/// first order, without solving that one: the change of cost, rows and active bounds at the
/// solution, each by its multiplier (docs/derivations/nonlinear_program.md eq. (5)). `changed` has
/// the same unknowns and rows as `program`, with other numbers in them. Empty where it has not,
/// where the solution has no multipliers, or where a number is not finite.
[[nodiscard]] std::optional<double> first_order_change(const Program& program,
                                                       const NonlinearSolution& solution,
                                                       const Program& changed);

}  // namespace torquewright::optimization
