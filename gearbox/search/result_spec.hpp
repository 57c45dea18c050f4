// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "gearbox/search/ranking.hpp"
#include "gearbox/search/search_result.hpp"
#include "gearbox/topologies/topology.hpp"

namespace torquewright::gearbox {

/// One member of a result's "designs": the contract's keys and everything else that is known.
nlohmann::ordered_json report_json(const Topology& topology, const DesignReport& report);

/// A document of kind `gearbox_result` without its provenance ("problem", "tool", "inputs").
nlohmann::ordered_json result_json(const Problem& problem, const DesignSearchResult& result);

/// The same of one design that was evaluated, with where it stands instead of a certificate.
nlohmann::ordered_json evaluation_json(const Problem& problem, const DesignReport& report,
                                       const Standing& standing);

}  // namespace torquewright::gearbox
