// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace torquewright::gearbox {

/// Two gears that mesh, by their places in the train: sun and planet, or a planet and its ring.
struct MeshedGears {
  std::string_view name;
  std::size_t gear_1 = 0;
  std::size_t gear_2 = 0;
};

/// What the trains of a topology consist of, for whoever counts, names, cuts or reads their parts.
/// What is computed of them stands in topologies/, which adds it to this.
struct TrainParts {
  std::string_view name;                 ///< As in documents.
  std::vector<std::string_view> gears;   ///< In the order of Design::teeth.
  std::size_t free_gears = 0;            ///< The first so many are free; the rings follow.
  std::vector<std::size_t> gear_layers;  ///< Of each gear: 0 where the sun stands.
  std::size_t held_ring = 0;             ///< Which gear it is.
  /// Which gear it is; absent: the carrier is the output.
  std::optional<std::size_t> output_ring = {};
  std::vector<MeshedGears> meshes;  ///< The sun's first, then those of the rings.
  bool is_the_papers = false;       ///< Equations (1)...(9) of seed 001 describe it.
  bool needs_synthesis = false;     ///< No search of teeth alone knows it.

  bool is_ring(std::size_t gear) const { return gear >= free_gears; }
  bool is_planet(std::size_t gear) const { return gear > 0 && !is_ring(gear); }
  static std::size_t planet_of_layer(std::size_t layer) { return 1 + layer; }
  /// Nothing where the layer's planet meets none.
  std::optional<std::size_t> ring_of_layer(std::size_t layer) const;
  /// The planet that a central gear, sun or ring, rolls on.
  std::size_t planet_beside(std::size_t central) const {
    return planet_of_layer(gear_layers[central]);
  }
  std::size_t layer_count() const;
  /// layer_1, ...: keys of face widths in documents.
  std::vector<std::string> layer_names() const;
};

/// Returns the parts of all topologies, in the order of the documentation.
std::span<const TrainParts> all_train_parts();

/// Returns the parts of the topology of that name; nullptr if there is none.
const TrainParts* find_train_parts(std::string_view name);

/// Returns the parts of the topology of that name, where a document's schema, or whoever made the
/// train, has seen to it that there is one.
const TrainParts& train_parts(std::string_view name);

}  // namespace torquewright::gearbox
