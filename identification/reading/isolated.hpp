// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace torquewright::identification {

/// Largest share of a channel's samples that may be isolated faults (docs/logs.md); more are part
/// of the signal.
constexpr double kMostIsolated = 0.01;

/// A circle of this circumference on which values lie; 0: they lie on a line.
struct Circle {
  double circumference = 0.0;
  double difference(double from, double to) const;
};

/// Samples that leave the course of their channel and are back after one or two samples, further
/// than anything else in it. docs/logs.md has the rule with its numbers.
struct IsolatedSamples {
  struct Place {
    std::size_t begin;
    std::size_t length;  ///< Number of samples, 1 or 2.
  };
  std::vector<Place> places;
  /// Whether there are too many to be isolated: they are part of the signal, or noise.
  bool is_crowd = false;
};
IsolatedSamples find_isolated(const std::vector<double>& values, const Circle& circle);

/// Replaces isolated samples by straight lines.
void replace_isolated(const IsolatedSamples& isolated, const Circle& circle,
                      std::vector<double>& values);

}  // namespace torquewright::identification
