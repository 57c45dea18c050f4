// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "io/documents/document.hpp"

namespace torquewright::gearbox {

/// Adds to a gearbox_problem with `synthesis` what it leaves out, each value listed under
/// `assumed`: modules of the rows of DIN 780, steel and its density, the friction of lubricated
/// steel, no further minima. Other problems stay as they are.
void assume_for_synthesis(nlohmann::json& problem);

/// The few lines that a problem with `synthesis` needs.
nlohmann::ordered_json synthesis_in_few_lines();

/// Those, and all that is assumed beside them.
nlohmann::ordered_json synthesis_to_start_from();

/// Reads a gearbox_problem, completed so. Throws io::SpecError.
io::Document read_problem_document(const std::string& file);

}  // namespace torquewright::gearbox
