// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gearbox/problem.hpp"
#include "gearbox/synthesis.hpp"

namespace torquewright::gearbox {

/// Fills `result` of a problem that was proved to have no design: an irreducible set of constraints
/// that no design satisfies together, with its proof and with a design for every set that lacks one
/// of them; and for every single bound in it the least change that makes the problem feasible, with
/// its proof. `proofs` are those of all constraints together: what stands where `options` end the
/// work before a smaller set is found.
void explain_infeasibility(const Problem& problem, const SynthesisOptions& options,
                           std::vector<AlternativeProof> proofs, SynthesisResult& result);

}  // namespace torquewright::gearbox
