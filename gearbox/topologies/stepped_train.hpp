// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "gearbox/topologies/topology_record.hpp"

namespace torquewright::gearbox {

/// All that is asked of a train of stepped planets, from its parts (train_parts.cpp) alone; how it
/// is drawn is its own matter, and no search of teeth without shifts knows it.
Topology stepped_train(std::string_view name);

}  // namespace torquewright::gearbox
