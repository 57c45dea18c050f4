// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "gearbox/search/ranking.hpp"
#include "gearbox/search/search.hpp"
#include "gearbox/topologies/topology.hpp"

namespace torquewright::report {

/// What `gearbox optimize` prints, on one screen: status and designs; or the conflict and what
/// would help. With `has_all` tables, constraints and proof too.
std::string optimization_text(const gearbox::Problem& problem,
                              const gearbox::DesignSearchResult& result, bool has_all);

/// The same in a line: status, and what the best design's teeth bear.
std::string optimization_answer(const gearbox::Problem& problem,
                                const gearbox::DesignSearchResult& result);

/// What `gearbox evaluate` prints: everything about one design and where it stands.
std::string evaluation_text(const gearbox::Problem& problem, const gearbox::DesignReport& report,
                            const gearbox::Standing& standing);

}  // namespace torquewright::report
