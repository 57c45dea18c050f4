// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "gearbox/synthesis/inner_case.hpp"

namespace torquewright::gearbox {

/// A point of the inner problem and its mass.
struct InnerPoint {
  std::array<double, 3> point{};
  double mass_kg = 0.0;
};

/// What a choice weighs with ordinary shifts, be they allowed or not; infinite where they do not
/// mesh.
double ordinary_mass_kg(const InnerCase& inner);

/// A light design within a box, sought from a start by random steps of a fixed seed that grow and
/// shrink with success; first for a design at all. It promises nothing: bounds do.
std::optional<InnerPoint> light_point(const InnerCase& inner, const InnerBox& box,
                                      const std::array<double, 3>& start, int trials);

}  // namespace torquewright::gearbox
