// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "gearbox/synthesis/synthesis.hpp"

namespace torquewright::gearbox {

/// What a synthesis did not choose: a sentence.
std::string held_fixed_by_synthesis(const Problem& problem);
/// What was found of one topology of a problem that leaves it open: a sentence.
std::string topology_sentence(const TopologyAnswer& answer);
/// What its verdict does not say of the design: sentences.
std::vector<std::string> not_asked_by_synthesis();

/// Writes a document of kind `gearbox_result` without its provenance ("problem", "tool", "inputs").
/// Its certificate holds `sized_claims` (docs/certificate.md).
nlohmann::ordered_json synthesis_json(const Problem& problem, const SynthesisResult& result);

}  // namespace torquewright::gearbox
