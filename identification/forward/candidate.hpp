// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "identification/findings/result.hpp"
#include "identification/forward/hypothesis.hpp"

namespace torquewright::identification {

/// A parameter that a fit may move. Its coordinate is the value itself, or the logarithm of a value
/// that is a scale.
struct FitParameter {
  std::string name;
  double lowest = 0.0;  ///< Bounds of the coordinate.
  double highest = 0.0;
  double size = 1.0;  ///< A change of the coordinate that matters; differences are taken by it.
  bool is_scale = false;
  /// Index of the parameter of the same effect that the coordinate is added to; kNone: none.
  std::size_t above = kNone;
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  /// Whether a fit ended at a bound, which is no credible value. Where the effect vanishes, or at
  /// an exponent of one, it may end.
  bool is_at_edge(double coordinate) const;
  double coordinate(double value) const;
  double value(double coordinate) const;
};

/// One form in which an effect may be present in a hypothesis.
struct EffectCandidate {
  std::string effect;
  EffectFamily family = EffectFamily::kActuator;
  std::string key;  ///< Tells the forms of one effect apart: its channel, its order.
  std::vector<FitParameter> parameters;
  std::vector<std::vector<double>> starts;  ///< Coordinates at which fits start.
  std::vector<std::string> contains;        ///< Names of effects that are special cases of it.
  std::vector<std::string> tends_to;  ///< Names of simpler effects that it resembles in some logs.
  double order = 0.0;                 ///< Order of a wave; 0 if it is none.
  std::function<void(std::span<const double>, Hypothesis&)> apply;
  /// Converts coordinates to the effect's parameters as documents name them, without errors.
  std::function<FoundParameters(std::span<const double>)> report;
};

}  // namespace torquewright::identification
