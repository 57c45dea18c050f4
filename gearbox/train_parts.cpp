// SPDX-License-Identifier: Apache-2.0
#include "gearbox/train_parts.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace torquewright::gearbox {

std::size_t TrainParts::layer_count() const {
  return 1 + *std::max_element(gear_layers.begin(), gear_layers.end());
}

std::optional<std::size_t> TrainParts::ring_of_layer(std::size_t layer) const {
  for (std::size_t gear = free_gears; gear < gears.size(); ++gear) {
    if (gear_layers[gear] == layer) return gear;
  }
  return std::nullopt;
}

std::vector<std::string> TrainParts::layer_names() const {
  std::vector<std::string> names;
  for (std::size_t layer = 1; layer <= layer_count(); ++layer) {
    names.push_back("layer_" + std::to_string(layer));
  }
  return names;
}

std::span<const TrainParts> all_train_parts() {
  static const std::array all{
      TrainParts{
          .name = "3k",
          .gears = {"sun", "planet_1", "planet_2", "fixed_ring", "output_ring"},
          .free_gears = 3,
          .gear_layers = {0, 0, 1, 0, 1},
          .held_ring = 3,
          .output_ring = 4,
          .meshes = {{"sun_planet_1", 0, 1},
                     {"planet_1_fixed_ring", 1, 3},
                     {"planet_2_output_ring", 2, 4}},
          .is_the_papers = true,
      },
      TrainParts{
          .name = "planetary",
          .gears = {"sun", "planet", "ring"},
          .free_gears = 2,
          .gear_layers = {0, 0, 0},
          .held_ring = 2,
          .meshes = {{"sun_planet", 0, 1}, {"planet_ring", 1, 2}},
      },
      TrainParts{
          .name = "3k_b",
          .gears = {"sun", "planet_1", "planet_2", "output_ring", "fixed_ring"},
          .free_gears = 3,
          .gear_layers = {0, 0, 1, 0, 1},
          .held_ring = 4,
          .output_ring = 3,
          .meshes = {{"sun_planet_1", 0, 1},
                     {"planet_1_output_ring", 1, 3},
                     {"planet_2_fixed_ring", 2, 4}},
          .needs_synthesis = true,
      },
      TrainParts{
          .name = "compound",
          .gears = {"sun", "planet_1", "planet_2", "ring"},
          .free_gears = 3,
          .gear_layers = {0, 0, 1, 1},
          .held_ring = 3,
          .meshes = {{"sun_planet_1", 0, 1}, {"planet_2_ring", 2, 3}},
          .needs_synthesis = true,
      },
  };
  return all;
}

const TrainParts* find_train_parts(std::string_view name) {
  const auto all = all_train_parts();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const auto& parts) { return parts.name == name; });
  return found == all.end() ? nullptr : &*found;
}

const TrainParts& train_parts(std::string_view name) {
  const TrainParts* parts = find_train_parts(name);
  if (parts == nullptr) throw std::invalid_argument("unknown topology: " + std::string(name));
  return *parts;
}

}  // namespace torquewright::gearbox
