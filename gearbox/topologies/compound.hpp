// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gearbox/topologies/topology_record.hpp"

namespace torquewright::gearbox::compound {

/// Sun on planet 1, planet 2 on the same axle in a held ring, the carrier is the output.
Topology topology();

}  // namespace torquewright::gearbox::compound
