// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gearbox/topologies/topology_record.hpp"

namespace torquewright::gearbox::three_k_b {

/// A 3K train whose sun stands in the layer of the output ring; the held ring is in the other.
Topology topology();

}  // namespace torquewright::gearbox::three_k_b
