// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearbox/search/search_result.hpp"
#include "gearbox/synthesis/synthesis.hpp"

namespace torquewright::gearbox {

/// What a problem asks that can be left out: "load", "face_width" (its limits), then the names of
/// its floors and ceilings.
std::vector<std::string> demands_of(const Problem& problem);
/// The problem without one of them.
Problem without_demand(const Problem& problem, const std::string& name);

/// A design that was found without a demand, as a conflict lists it.
ConflictMember conflict_member(const Problem& problem, const std::string& demand,
                               const SizedDesign& without_it);

/// Which floors, ceilings, limits of face widths ("face_width") and load ("load") of a problem that
/// was proved to have no design stand in its way: none of them to spare, each with the design that
/// a synthesis without it found. Empty: there is none without any of them either. Nothing: the
/// search was ended before that was proved.
std::optional<std::vector<ConflictMember>> floor_conflict(const Problem& problem,
                                                          const SynthesisOptions& options);

/// The same for a result without design, with the demands that have no part in it.
void explain_conflict(const Problem& problem, const SynthesisOptions& options,
                      SynthesisResult& result);

}  // namespace torquewright::gearbox
