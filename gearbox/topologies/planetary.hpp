// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "gearbox/constraints/design_report.hpp"
#include "gearbox/topologies/topology_record.hpp"

namespace torquewright::gearbox::planetary {

Topology topology();

/// {S, P, R} from {S, P}: R = S + 2 P.
std::vector<std::int64_t> complete(std::span<const std::int64_t> free_teeth);

/// Everything about one design with two or three tooth counts, all positive. Whatever does not
/// exist for it (a mesh) is 0 in the report, and a constraint or remark says so.
DesignReport evaluate(const Problem& problem, const Design& design);

}  // namespace torquewright::gearbox::planetary
