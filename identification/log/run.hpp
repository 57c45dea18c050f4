// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "identification/rig/quantity.hpp"

namespace torquewright::identification {

/// The channels of one joint in one run, by Quantity; one that was not logged is empty. What the
/// log states for all joints is repeated in each.
struct Channels {
  std::array<std::vector<double>, kQuantityCount> of;

  const std::vector<double>& operator[](Quantity quantity) const {
    return of[static_cast<std::size_t>(quantity)];
  }
  std::vector<double>& operator[](Quantity quantity) {
    return of[static_cast<std::size_t>(quantity)];
  }
  bool has(Quantity quantity) const { return !(*this)[quantity].empty(); }
};

/// A stretch of samples without a gap but for short ones (kLongestBridge_s), or a piece of one. All
/// vectors have one length.
struct Run {
  std::string name;
  std::vector<double> time_s;    ///< Times, strictly ascending; empty in a map without time.
  std::vector<Channels> joints;  ///< Channels in the order of Rig::joints.
  /// 1: repaired or saturated; the sample's residual does not count.
  std::vector<std::uint8_t> masked;
  /// Whether it follows the run before it without a gap: both are pieces of one stretch.
  bool continues = false;
};

}  // namespace torquewright::identification
