// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearbox/problem.hpp"
#include "gearbox/strength/tooth_load.hpp"

namespace torquewright::gearbox {

// What a gearbox_problem says of its gears' strength, and what an answer that does not ask for it
// says of itself.

/// Loads and safeties that are assumed where nobody states them: those of the examples in
/// specs/gearbox.
inline constexpr double kAssumedCycles = 10000.0;
inline constexpr double kAssumedRootSafety = 1.4;
inline constexpr double kAssumedFlankSafety = 1.0;

/// Of a screen that shows what teeth bear though the problem states neither steel nor face widths.
inline constexpr const char* kAssumedSteel = "case_hardened";
inline constexpr int kAssumedFaceModules = 10;

/// Load factors likewise; K_gamma by the number of planets (docs/derivations/strength.md "A result
/// instead of a document").
LoadFactors assumed_factors(std::int64_t planet_count);

/// The strength of a design with the problem's steel, face widths and cutters. Nothing where it
/// states no steel or no face widths, or where the gears do not mesh.
std::optional<StrengthCase> strength_of_design(const Problem& problem, const Design& design);

/// What no search without `synthesis` chooses: a sentence.
std::string held_fixed(const Problem& problem);

/// How much of the load a design's teeth bear, and what is assumed for it: a sentence.
std::string strength_statement(const Problem& problem, const Design& design);

/// What was not asked of the best of these designs: sentences. Where steel, face widths and load
/// are stated, how much of the load its teeth bear.
std::vector<std::string> not_asked(const Problem& problem, const std::vector<Design>& designs);

}  // namespace torquewright::gearbox
