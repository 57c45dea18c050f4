// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace torquewright::gearbox::sized {

/// Centre distance and both shifts.
inline constexpr std::size_t kPlaces = 3;

/// What a term bounds.
enum class TermKind { kFirstLayer, kSecondLayer, kCondition };

/// constant + slope . e, where e runs from -1 to 1 in each of the three. Of a layer: no value of it
/// is below. A condition: no design where it is above 0.
struct LinearTerm {
  TermKind kind = TermKind::kCondition;
  double constant = 0.0;
  std::array<double, kPlaces> slope{};
};

/// What weights prove.
struct WeightedProof {
  /// No design of the box has a smaller sum of both layers. Infinite: there is no design.
  double least = 0.0;
};

/// Any weights that are not negative, at most 1 in all for the terms of a layer, make a sum that is
/// below both layers' together: the ones that make it greatest are sought by the simplex method,
/// and what they prove is computed afresh with rounding counted. Layers are not negative. Ends as
/// soon as `enough` is reached.
WeightedProof weigh(const std::vector<LinearTerm>& terms, double enough);

}  // namespace torquewright::gearbox::sized
