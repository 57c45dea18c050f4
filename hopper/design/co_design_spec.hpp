// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "hopper/design/co_design.hpp"

namespace torquewright::hopper {

/// The word for how the search at a ratio ended: proved, none, limit, skipped.
std::string name_of(GearSearch search);

/// Ratios of FROM:TO[:STEP], or one alone, as the decimals that were written. Throws io::SpecError.
std::vector<io::Rational> read_ratios(const std::string& text);

/// A document of kind drive_design, without its provenance.
nlohmann::ordered_json co_design_json(const Robot& robot, const CoDesignQuestion& question,
                                      const CoDesign& design);

/// A pair's motor behind its gears as a document of kind actuator: what the motor's document says
/// of its own gears, of all of the drive and of its data sheet is left out.
nlohmann::ordered_json designed_actuator_json(const CoDesignQuestion& question,
                                              const CoDesign& design, const DesignedPair& pair);

}  // namespace torquewright::hopper
