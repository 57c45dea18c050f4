// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "gearbox/topologies/topology_record.hpp"

namespace torquewright::gearbox {

/// All topologies, in the order of the documentation.
std::span<const Topology> topologies();

/// The topology of that name; nullptr if there is none.
const Topology* find_topology(std::string_view name);

}  // namespace torquewright::gearbox
