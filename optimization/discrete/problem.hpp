// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "optimization/expressions/box.hpp"
#include "optimization/expressions/expression.hpp"

namespace torquewright::optimization {

/// How a body changes with a variable on the whole domain. Stated by the writer of the model, with
/// the proof in docs/derivations; linear bodies need no statement.
enum class Direction { kUnknown, kGrows, kFalls };

/// An inequality: body >= 0, or body > 0 where strict.
struct Condition {
  std::string name;        ///< Name of this inequality, as in certificates: "ratio_max".
  std::string constraint;  ///< Name of the constraint that the user knows: "ratio".
  std::string key;         ///< JSON pointer of the bound that sets the limit; empty: none.
  Expression body;
  bool strict = false;
  /// Whether it is judged on boxes (propagation, relaxation); else at points only.
  bool on_boxes = true;
  std::vector<Direction> directions = {};  ///< Directions by variable; empty: all unknown.
};

/// A property of whole points that no interval can judge, such as divisibility.
struct Predicate {
  std::string constraint;
  std::string key;
  std::function<bool(std::span<const std::int64_t>)> holds;
};

/// The quantity that points are compared by. A point at which the value does not exist is no
/// solution.
struct Goal {
  std::string name;
  std::string unit;
  Expression value;
  bool maximise = false;
  /// Whether it is made of fractions only, so that values are compared exactly. Else two that
  /// differ by less than 1e-12 relatively count as equal.
  bool exact = false;
  /// Encloses the value on every point that satisfies all conditions; used for bounds, where it is
  /// tighter than the value's own enclosure.
  std::optional<Expression> enclosure = std::nullopt;
};

/// A question about a bound: how far would it have to move? The goal is optimised with all
/// conditions of that key left out.
struct Loosening {
  std::string key;
  Goal quantity;
};

/// An optimisation problem: integer variables in a box, conditions, predicates, and a goal.
struct Problem {
  std::vector<std::string> variables;
  Box domain;
  std::vector<Condition> conditions;
  std::vector<Predicate> predicates;
  Goal goal;
  std::vector<Loosening> loosenings = {};
};

}  // namespace torquewright::optimization
