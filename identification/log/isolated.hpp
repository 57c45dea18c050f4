// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace torquewright::identification {

/// More than this share of a channel's samples are not isolated.
constexpr double kMostIsolated = 0.01;

/// A value on a circle of this circumference; 0: on a line.
struct Circle {
  double circumference = 0.0;
  double difference(double from, double to) const;
};

/// Samples that leave the course of their channel and are back after one or two samples, further
/// than anything else in it. docs/logs.md has the rule with its numbers.
struct IsolatedSamples {
  struct Place {
    std::size_t begin;
    std::size_t length;  ///< 1 or 2.
  };
  std::vector<Place> places;
  /// They are too many to be isolated: part of the signal, or noise.
  bool is_crowd = false;
};
IsolatedSamples find_isolated(const std::vector<double>& values, const Circle& circle);

/// Puts straight lines in their places.
void replace_isolated(const IsolatedSamples& isolated, const Circle& circle,
                      std::vector<double>& values);

}  // namespace torquewright::identification
