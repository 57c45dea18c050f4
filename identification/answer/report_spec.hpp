// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "identification/answer/identify.hpp"

namespace torquewright::identification {

/// A document of kind `identification_report` (specs/schema/identification_report.json) without its
/// provenance ("options", "tool", "inputs"). What was not measured is null.
nlohmann::ordered_json identification_report_json(const Identification& found);

/// How the noise floor is found: a sentence.
std::string noise_floor_method();

/// What is left along a coordinate: a sentence.
std::string sentence_of(const ResidualStructure& structure);

/// The coordinates along which something is left beyond chance, each once, the strongest first.
std::vector<ResidualStructure> significant_of(const std::vector<ResidualStructure>& structures);

/// Whether an equation that leaves more than noise has no verdict of its own: it was simulated with
/// what others found, and added nothing.
bool only_confirms(const EquationResult& equation);

/// What was rejected and did not come in in another form (another delay, another harmonic).
std::vector<Rejection> rejections_of(const EquationResult& equation);

}  // namespace torquewright::identification
