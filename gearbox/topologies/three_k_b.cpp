// SPDX-License-Identifier: Apache-2.0
#include "gearbox/topologies/three_k_b.hpp"

#include "gearbox/topologies/stepped_train.hpp"

namespace torquewright::gearbox::three_k_b {

Topology topology() {
  Topology record = stepped_train("3k_b");
  record.drawn = {{"sun", "S", "sun"},
                  {"planet_1", "P1", "planet 1"},
                  {"planet_2", "P2", "planet 2"},
                  {"output_ring", "O", "output ring"},
                  {"fixed_ring", "F", "fixed ring"}};
  record.views = {"Layer 1: sun, planets 1, output ring",
                  "Layer 2: planets 2, fixed ring (sun dashed)"};
  return record;
}

}  // namespace torquewright::gearbox::three_k_b
