// SPDX-License-Identifier: Apache-2.0
#include "gearbox/topologies/compound.hpp"

#include "gearbox/topologies/stepped_train.hpp"

namespace torquewright::gearbox::compound {

Topology topology() {
  Topology record = stepped_train("compound");
  record.drawn = {{"sun", "S", "sun"},
                  {"planet_1", "P1", "planet 1"},
                  {"planet_2", "P2", "planet 2"},
                  {"fixed_ring", "R", "ring"}};
  record.views = {"Layer 1: sun, planets 1", "Layer 2: planets 2, ring (sun dashed)"};
  return record;
}

}  // namespace torquewright::gearbox::compound
