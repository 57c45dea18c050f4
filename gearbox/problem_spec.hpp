// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "gearbox/problem.hpp"
#include "gearbox/train_parts.hpp"

namespace torquewright::io {
struct Document;
}

namespace torquewright::gearbox {

/// Reads a checked document of kind `gearbox_problem`. Throws io::SpecError for what a schema
/// cannot say: `paper` or `paper_cost` with another train than the paper's, minima of gears
/// the topology does not have, an objective without the values it needs (friction, face widths,
/// density).
Problem read_problem(const io::Document& document);

/// The same for whoever lets the synthesis choose: the topology may be open (any_topology.hpp).
Problem read_open_problem(const io::Document& document);

/// The keys of a problem whose topology is open as those of one topology.
nlohmann::json as_topology(const nlohmann::json& problem, const TrainParts& parts);

/// Whether the schema of problems admits that number at that place, such as "/min_teeth/sun".
/// Requires a key that holds a number.
bool may_be_stated(const std::string& pointer, double value);

}  // namespace torquewright::gearbox
