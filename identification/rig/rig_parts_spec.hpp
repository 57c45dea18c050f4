// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace torquewright::io {
struct Document;
}

namespace torquewright::identification {

/// Returns the keys of a rig's "columns" in the order of its file; the document itself keeps them
/// in alphabetical order. Nothing where the file cannot be read again (a document made in memory).
std::optional<std::vector<std::string>> columns_as_written(const io::Document& document);

/// Returns why an entry of "uncertain" leads to nothing that a fit could correct; empty if it leads
/// to a number that a load (/load/...) or an actuator (/motor/..., /gearbox/...) may state. Whether
/// this load or actuator states it is checked later, when all documents are read.
std::string objection_to_pointer(const std::string& pointer, const nlohmann::json& rig);

/// Returns the indices of the joints that a list of names, or of patterns of them ("*_calf_joint"),
/// stands for, ascending. `report` is told the place in the list of one that fits none.
std::vector<std::size_t> joints_of_patterns(
    const nlohmann::json& patterns, const std::vector<std::string>& joints,
    const std::function<void(std::size_t place, std::string fault)>& report);

}  // namespace torquewright::identification
