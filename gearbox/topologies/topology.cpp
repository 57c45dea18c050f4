// SPDX-License-Identifier: Apache-2.0
#include "gearbox/topologies/topology.hpp"

#include <algorithm>
#include <array>

#include "gearbox/topologies/planetary.hpp"
#include "gearbox/topologies/planetary_model.hpp"
#include "gearbox/topologies/three_k.hpp"
#include "gearbox/topologies/three_k_model.hpp"

namespace torquewright::gearbox {

std::span<const Topology> topologies() {
  static const std::array all{
      Topology{"3k",
               {"sun", "planet_1", "planet_2", "fixed_ring", "output_ring"},
               3,
               three_k::complete,
               three_k::model,
               three_k::free_teeth,
               three_k::point_of,
               three_k::evaluate},
      Topology{"planetary",
               {"sun", "planet", "ring"},
               2,
               planetary::complete,
               planetary::model,
               planetary::free_teeth,
               planetary::point_of,
               planetary::evaluate},
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
