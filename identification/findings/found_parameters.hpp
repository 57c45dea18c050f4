// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace torquewright::identification {

/// A number of an effect under the name, with unit, that documents give it.
struct FoundNumber {
  std::string name;
  double value = 0.0;
  /// Standard error of the value; not a number where the log does not determine it.
  double standard_error = std::numeric_limits<double>::quiet_NaN();
};

/// A wave of an effect: amplitude times the sine of order times the angle plus phase.
struct FoundWave {
  double order = 1.0;
  FoundNumber amplitude;
  FoundNumber phase_rad{.name = "phase_rad"};
};

/// The parameters of an effect that was found in a log.
struct FoundParameters {
  std::string channel;  ///< Channel of the log that it is an error of; empty for other effects.
  std::vector<FoundNumber> numbers;
  std::vector<FoundWave> waves;
  /// Whether the waves grow with the load; nothing for effects that know no such waves.
  std::optional<bool> proportional;

  /// Returns the number of that name among `numbers`; null if there is none.
  const FoundNumber* find(std::string_view name) const;
  /// Returns the value of that name, or `otherwise` if there is none.
  double value(std::string_view name, double otherwise) const;
  /// Returns the standard error of that name; not a number if there is none.
  double standard_error(std::string_view name) const;
  /// Returns every number that a log determines: `numbers`, then amplitude and phase of each wave.
  /// The pointers hold as long as the parameters do.
  std::vector<FoundNumber*> every_number();
  std::vector<const FoundNumber*> every_number() const;
};

}  // namespace torquewright::identification
