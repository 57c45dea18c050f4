// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "gearbox/sized_proof/choice_proof.hpp"

namespace torquewright::gearbox::sized {

/// What became of a proof over all choices of whole numbers.
struct SizedProof {
  bool holds = false;
  std::int64_t choices = 0;          ///< That were gone through.
  std::optional<WholeNumbers> open;  ///< The first of which it could not be proved.
};

/// The floors and ceilings of a problem with a mass that nothing shall be below.
SizedClaim claim_of(const Problem& problem, double bound_kg);

/// Proves that no train that a problem of one topology with `synthesis` admits is lighter than the
/// bound (infinite: that there is none): every choice of whole numbers, each for all centre
/// distances and shifts. Shares the problem and the definitions of steels, factors of load, walls
/// and train kinematics with the search, and nothing else: other enclosures (affine arithmetic in
/// place of slopes), other boxes, other formulas. The problem's own ceiling on the mass counts.
SizedProof prove_lightest(const Problem& problem, double bound_kg, ProofEffort& effort);

}  // namespace torquewright::gearbox::sized
