// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "gearbox/proof/claims/claim.hpp"

namespace torquewright::gearbox::proof {

/// A real point of a box, as the certificate writes it.
using RealPoint = std::array<Rational, 3>;

/// Value and gradient of a concave function at a point.
struct Linearization {
  Interval value;
  std::array<Interval, 3> gradient;

  Linearization& operator+=(const Linearization& other);
  void scale(const Interval& factor);
};

/// Whether the linearisation is below zero everywhere in the box.
bool is_negative_on(const Linearization& function, const RealPoint& point, const Box& box);

}  // namespace torquewright::gearbox::proof
