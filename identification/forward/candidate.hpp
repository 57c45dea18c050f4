// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "identification/findings/result.hpp"
#include "identification/forward/hypothesis.hpp"

namespace torquewright::identification {

/// What a fit may move. Its coordinate is the value, or the logarithm of a value that is a scale.
struct FitParameter {
  std::string name;
  double lowest = 0.0;  ///< Bounds of the coordinate.
  double highest = 0.0;
  double size = 1.0;  ///< A change of the coordinate that matters: differences are taken by it.
  bool is_scale = false;
  /// Index of the parameter of the same effect above which the coordinate counts; none: no such.
  std::size_t above = kNone;
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  /// Whether a fit ended where only the bounds held it: no value that anybody would believe. Where
  /// the effect vanishes, or at an exponent of one, it may end.
  bool is_at_edge(double coordinate) const;
  double coordinate(double value) const;
  double value(double coordinate) const;
};

/// One way in which an effect may be present in a hypothesis.
struct EffectCandidate {
  std::string effect;
  EffectFamily family = EffectFamily::kActuator;
  std::string key;  ///< Of one effect there may be several: its channel, its order.
  std::vector<FitParameter> parameters;
  std::vector<std::vector<double>> starts;  ///< Coordinates.
  std::vector<std::string> contains;        ///< Effects that are special cases of it.
  std::vector<std::string> tends_to;        ///< Simpler ones that it is like in some logs.
  double order = 0.0;                       ///< Of a wave.
  std::function<void(std::span<const double>, Hypothesis&)> apply;
  /// The contract's parameters at coordinates.
  std::function<nlohmann::ordered_json(std::span<const double>)> report;
};

}  // namespace torquewright::identification
