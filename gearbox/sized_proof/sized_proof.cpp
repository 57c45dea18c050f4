// SPDX-License-Identifier: Apache-2.0
#include "gearbox/sized_proof/sized_proof.hpp"

#include <algorithm>

#include "gearbox/sized_proof/enclosures/affine.hpp"
#include "gearbox/sized_proof/whole_choices.hpp"

namespace torquewright::gearbox::sized {
SizedClaim claim_of(const Problem& problem, double bound_kg) {
  const Floors& floors = problem.floors;
  SizedClaim claim{bound_kg,
                   as_number(floors.hollow_shaft_mm),
                   as_number(floors.forward_efficiency),
                   as_number(floors.backward_efficiency),
                   as_number(floors.axial_length_mm),
                   as_number(floors.reflected_inertia_kg_m2)};
  constexpr double kForgivenShare = 1e-9;
  if (floors.mass_kg) {
    claim.bound_kg =
        std::min(claim.bound_kg, io::nearest(*floors.mass_kg) * (1.0 + kForgivenShare));
  }
  return claim;
}

SizedProof prove_lightest(const Problem& problem, double bound_kg, ProofEffort& effort) {
  const SizedClaim claim = claim_of(problem, bound_kg);
  const TrainParts& parts = train_parts(problem.topology);
  SizedProof proof;
  for_each_choice(problem, [&](const WholeNumbers& whole) {
    ++proof.choices;
    if (effort.should_stop()) effort.is_ended = true;
    if (!effort.is_ended &&
        holds_of_choice(parts, whole, loaded_teeth(problem, whole), claim, effort)) {
      return true;
    }
    proof.open = whole;
    return false;
  });
  proof.holds = !proof.open.has_value();
  return proof;
}

}  // namespace torquewright::gearbox::sized
