// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "gearbox/search/ranking.hpp"
#include "gearbox/search/search_result.hpp"
#include "gearbox/topologies/topology.hpp"

namespace torquewright::gearbox {

/// Writes one member of a result's "designs", with everything that is known of it.
nlohmann::ordered_json report_json(const Topology& topology, const DesignReport& report);

/// Writes a document of kind `gearbox_result` without its provenance ("problem", "tool", "inputs").
nlohmann::ordered_json result_json(const Problem& problem, const DesignSearchResult& result);

/// Writes the same for one design that was evaluated, with its place among all designs instead of a
/// certificate.
nlohmann::ordered_json evaluation_json(const Problem& problem, const DesignReport& report,
                                       const Standing& standing);

}  // namespace torquewright::gearbox
