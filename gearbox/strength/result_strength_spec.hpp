// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "gearbox/strength/strength_spec.hpp"

namespace torquewright::gearbox {

/// Values that a strength needs and a gearbox_result does not hold. Absent ones are assumed, and
/// the answer says so.
struct ResultStrengthOptions {
  std::size_t design = 1;  ///< Number of the design in the result, from 1.
  /// Names of `steels()`: NAME for all gears, GEAR=NAME for one. Every gear must have one.
  std::vector<std::string> steel;
  std::vector<double> face_width_mm;  ///< Face widths by layer; empty: the problem's own.
  std::optional<double> cycles;
  std::vector<std::string> rim;        ///< Rims as GEAR=MM; absent: too thick to matter.
  std::optional<double> load_sharing;  ///< Load sharing factor K_gamma.
};

/// Returns the strength of a design of a result of `gearbox optimize` or `evaluate`. Throws
/// io::SpecError for a result without such a design, of an infeasible design, or where steel or
/// face widths are missing.
ReadStrength strength_of_result(io::Document result, const ResultStrengthOptions& options);

}  // namespace torquewright::gearbox
