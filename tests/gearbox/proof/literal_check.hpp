// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/gearbox/proof/naive_proof.hpp"

namespace torquewright::gearbox::proof_test {

/// The second oracle: whether the nodes of one alternative are a proof of the claim, taken at their
/// word and point by point. Every point that a cut takes or a leaf closes is judged by itself, in
/// doubles; no monotonicity, no interval, no relaxation. Slow, and obviously right.
bool is_literally_proved(const PlainClaim& claim, const Choice& choice, const Json& nodes);

}  // namespace torquewright::gearbox::proof_test
