// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "gearbox/sized_proof/loaded_teeth.hpp"

namespace torquewright::gearbox::sized {

/// What is to be proved: that no design that meets all of this is lighter.
struct SizedClaim {
  double bound_kg = 0.0;                           ///< Infinite: that there is no design at all.
  std::optional<double> hollow_shaft_mm = {};      ///< At least.
  std::optional<double> forward_efficiency = {};   ///< At least.
  std::optional<double> backward_efficiency = {};  ///< At least.
  std::optional<double> axial_length_mm = {};      ///< At most, as the next.
  std::optional<double> reflected_inertia_kg_m2 = {};
};

/// What a proof may take, and has taken.
struct ProofEffort {
  std::int64_t most_boxes = 0;  ///< 0: as many as it takes.
  std::function<bool()> should_stop = [] { return false; };
  std::int64_t boxes = 0;
  bool is_ended = false;  ///< By a limit.
};

/// Whether the claim holds of a choice of whole numbers, whatever its centre distance and shifts.
/// Boxes are split until each is closed by affine arithmetic; false where one is left that is too
/// small to be split, or the effort is at its end.
bool holds_of_choice(const TrainParts& parts, const WholeNumbers& whole, const LoadedTeeth& teeth,
                     const SizedClaim& claim, ProofEffort& effort);

}  // namespace torquewright::gearbox::sized
