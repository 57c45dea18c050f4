// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "optimization/expressions/box.hpp"

namespace torquewright::optimization {

/// Index that stands for the comparison with the best points found, among those of conditions.
inline constexpr std::size_t kQuantity = static_cast<std::size_t>(-1);

/// The part of a box beyond `value` violates a condition: it goes.
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
  kSplit,       ///< No leaf: two children.
  kEmpty,       ///< One condition refutes it.
  kEnumerated,  ///< Every point was looked at.
  kRelaxation,  ///< A sum of conditions refutes it.
};

/// What was done with one box. docs/certificate.md says how it is checked.
struct ProofNode {
  std::vector<Cut> cuts;
  Leaf leaf = Leaf::kOpen;
  std::size_t condition = 0;       ///< kEmpty: by which.
  std::size_t split_variable = 0;  ///< kSplit: the first child has at most split_value.
  std::int64_t split_value = 0;
  std::size_t children[2] = {0, 0};     ///< kSplit: their places in the tree.
  std::vector<double> point;            ///< kRelaxation: where the sum is linearised.
  std::vector<Multiplier> multipliers;  ///< kRelaxation.
};

/// Node 0 is the root; empty where the domain is.
using ProofTree = std::vector<ProofNode>;

}  // namespace torquewright::optimization
