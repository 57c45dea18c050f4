// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "identification/answer/identify.hpp"

namespace torquewright::identification {

/// A document of kind `identification_report` (specs/schema/identification_report.json) without its
/// provenance ("options", "tool", "inputs"). What was not measured is null.
nlohmann::ordered_json identification_report_json(const Identification& found);

/// Returns a sentence that says how the noise floor is found.
std::string noise_floor_method();

/// Returns a sentence about what is left along a coordinate.
std::string sentence_of(const ResidualStructure& structure);

/// The coordinates along which something is left beyond chance, each once, the strongest first.
std::vector<ResidualStructure> significant_of(const std::vector<ResidualStructure>& structures);

/// Whether an equation that leaves more than noise has no verdict of its own: it was simulated with
/// what others found, and added nothing.
bool only_confirms(const EquationResult& equation);

/// Returns the rejected effects that did not come in in another form (another delay, another
/// harmonic).
std::vector<Rejection> rejections_of(const EquationResult& equation);

}  // namespace torquewright::identification
