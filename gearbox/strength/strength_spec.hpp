// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "gearbox/strength/tooth_load.hpp"
#include "io/documents/document.hpp"

namespace torquewright::gearbox {

/// A document of kind gear_strength and the documents read for it: its own first.
struct ReadStrength {
  std::string name;
  StrengthCase strength;
  std::optional<double> ring_space_mm;  ///< `rotor_inner_diameter_mm` of the problem.
  std::optional<double> load_Nm;        ///< Load at the output, where a result's problem states it.
  std::vector<std::string> assumed;
  std::vector<std::string> statements;  ///< Sentences on which values were taken from where.
  std::vector<io::Document> documents;
};

/// Reads it, and the gearbox (kind gearbox or gearbox_result, its first design) that it may name
/// relative to itself. Throws io::SpecError for what the schema cannot say: gears of another
/// topology, a second layer without face width, a yield stress that is missing, gears that do not
/// mesh.
ReadStrength read_strength(const std::filesystem::path& file);
/// Reads the strength document that was read from a file already.
ReadStrength strength_of(io::Document document);

}  // namespace torquewright::gearbox
