// SPDX-License-Identifier: Apache-2.0
#include "gearbox/proof/gears/train.hpp"

#include <array>
#include <stdexcept>

namespace torquewright::gearbox::proof {

std::vector<std::string> Train::gears() const {
  std::vector<std::string> all = free_gears;
  all.insert(all.end(), rings.begin(), rings.end());
  return all;
}

const Train& train_of(const Problem& problem) {
  static const std::array all{
      Train{.topology = "3k",
            .variables = {"sun", "planet_1", "difference"},
            .free_gears = {"sun", "planet_1", "planet_2"},
            .rings = {"fixed_ring", "output_ring"},
            .meshes = {"sun_planet_1", "planet_1_fixed_ring", "planet_2_output_ring"}},
      Train{.topology = "planetary",
            .variables = {"sun", "planet"},
            .free_gears = {"sun", "planet"},
            .rings = {"ring"},
            .meshes = {"sun_planet", "planet_ring"}},
  };
  for (const Train& train : all) {
    if (train.topology == problem.topology) return train;
  }
  throw std::invalid_argument("the checker knows no topology \"" + problem.topology + "\"");
}

}  // namespace torquewright::gearbox::proof
