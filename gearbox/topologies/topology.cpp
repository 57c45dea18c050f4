// SPDX-License-Identifier: Apache-2.0
#include "gearbox/topologies/topology.hpp"

#include <algorithm>
#include <array>

#include "gearbox/topologies/compound.hpp"
#include "gearbox/topologies/planetary.hpp"
#include "gearbox/topologies/three_k.hpp"
#include "gearbox/topologies/three_k_b.hpp"

namespace torquewright::gearbox {

std::span<const Topology> topologies() {
  static const std::array all{
      three_k::topology(),
      planetary::topology(),
      three_k_b::topology(),
      compound::topology(),
  };
  return all;
}

const Topology* find_topology(std::string_view name) {
  const auto all = topologies();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const Topology& topology) { return topology.name == name; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace torquewright::gearbox
