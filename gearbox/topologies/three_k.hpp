// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "gearbox/constraints/design_report.hpp"
#include "gearbox/topologies/topology_record.hpp"

namespace torquewright::gearbox::three_k {

Topology topology();

/// {S, P1, P2, F, O} from {S, P1, P2}: F = S + 2 P1, O = S + P1 + P2.
std::vector<std::int64_t> complete(std::span<const std::int64_t> free_teeth);

/// Everything about one design with three or five tooth counts, all positive. Whatever does not
/// exist for it (a ratio, a mesh) is 0 in the report, and a constraint or remark says so.
DesignReport evaluate(const Problem& problem, const Design& design);

}  // namespace torquewright::gearbox::three_k
