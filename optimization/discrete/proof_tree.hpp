// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "optimization/expressions/box.hpp"

namespace torquewright::optimization {

/// Index that stands for the comparison with the best points found, among those of conditions.
inline constexpr std::size_t kQuantity = static_cast<std::size_t>(-1);

/// A cut: the part of a box beyond `value` violates a condition and is removed.
struct Cut {
  std::size_t condition;
  std::size_t variable;
  bool is_lower;  ///< `value` is the variable's new lower bound; else its upper one.
  std::int64_t value;
};

struct Multiplier {
  std::size_t condition;
  double value;
};

enum class Leaf {
  kOpen,        ///< Not decided: a limit was reached.
  kSplit,       ///< An inner node with two children, no leaf.
  kEmpty,       ///< One condition refutes it.
  kEnumerated,  ///< Every point was looked at.
  kRelaxation,  ///< A weighted sum of conditions refutes it.
};

/// A node of a proof: what was done with one box. docs/certificate.md says how it is checked.
struct ProofNode {
  std::vector<Cut> cuts;
  Leaf leaf = Leaf::kOpen;
  std::size_t condition = 0;  ///< Index of the condition that refutes the box (kEmpty).
  /// Variable that is split (kSplit): the first child has at most split_value.
  std::size_t split_variable = 0;
  std::int64_t split_value = 0;
  std::size_t children[2] = {0, 0};     ///< Indices of the children in the tree (kSplit).
  std::vector<double> point;            ///< Point at which the sum is linearised (kRelaxation).
  std::vector<Multiplier> multipliers;  ///< Multipliers of the sum (kRelaxation).
};

/// A proof as a list of nodes; node 0 is the root. Empty where the domain is.
using ProofTree = std::vector<ProofNode>;

}  // namespace torquewright::optimization
