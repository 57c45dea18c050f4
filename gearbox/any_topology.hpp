// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gearbox/problem.hpp"
#include "gearbox/train_parts.hpp"

namespace torquewright::gearbox {

/// Topology of a problem that leaves it to the synthesis.
inline constexpr std::string_view kAnyTopology = "any";

inline bool is_topology_open(const Problem& problem) { return problem.topology == kAnyTopology; }

/// The gears that have minima: those of a topology, or of all of them where it is open.
std::vector<std::string> gears_with_minima(std::string_view topology);

/// Their layers, likewise.
std::vector<std::string> layers_of(std::string_view topology);

/// The problem as one topology has it: minima of its own gears, and a second module for a second
/// layer only.
Problem as_topology(const Problem& problem, const TrainParts& parts);

}  // namespace torquewright::gearbox
