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

/// The first step of a search that knows nothing of its start, as a share of the box.
inline constexpr double kFarStep = 0.3;

/// A light design within a box, sought from a start by random steps of a fixed seed that grow and
/// shrink with success, the first of them a share `step` of the box; first for a design at all. It
/// promises nothing: bounds do.
std::optional<InnerPoint> light_point(const InnerCase& inner, const InnerBox& box,
                                      const std::array<double, 3>& start, int trials,
                                      double step = kFarStep);

}  // namespace torquewright::gearbox
