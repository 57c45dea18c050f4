// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "gearbox/search/search_result.hpp"
#include "gearbox/topologies/topology.hpp"

namespace torquewright::gearbox {

/// Writes a design: {"teeth": {...}, "planet_count", "module_mm"}
nlohmann::ordered_json design_json(const Topology& topology, const Design& design);

/// Writes a result's "certificate", in the form of docs/certificate.md.
nlohmann::ordered_json certificate_json(const Topology& topology, const std::vector<Claim>& claims);

}  // namespace torquewright::gearbox
