// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "gearbox/proof/claims/quantity.hpp"

namespace torquewright::gearbox::proof {

/// A bound of the problem document that a least relaxation moves.
struct RelaxedBound {
  std::string key;            ///< JSON pointer into the problem.
  std::string quantity_name;  ///< As in claims.
  Quantity quantity;          ///< What the bound limits.
  Rational value;             ///< As the problem has it.
};

/// Empty if the problem has no such bound, or none that is a number a constraint compares with.
std::optional<RelaxedBound> find_relaxed_bound(const Problem& problem, std::string_view key);

/// The problem with the bound at `value`; empty for a fraction of a tooth.
std::optional<Problem> with_bound(const Problem& problem, const RelaxedBound& bound,
                                  const Rational& value);

}  // namespace torquewright::gearbox::proof
