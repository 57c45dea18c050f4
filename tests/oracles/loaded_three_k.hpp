// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <optional>

namespace torquewright::oracles {

/// Whole numbers of a train, and the layers' modules. Rings by layer, that of the sun first; what a
/// train does not have is 0.
struct LoadedTeeth {
  std::int64_t sun = 0, planet_1 = 0, planet_2 = 0, ring_1 = 0, ring_2 = 0, planets = 0;
  double module_1_mm = 0.0, module_2_mm = 0.0;
};

/// A train whose teeth bear the problem's load with the widths that they need.
struct LoadedTrain {
  LoadedTeeth teeth;
  double centre_mm = 0.0;
  double shift_1 = 0.0, shift_2 = 0.0;  ///< Of the planets, in modules.
  std::array<double, 2> width_mm{};
  double mass_kg = std::numeric_limits<double>::infinity();
};

/// What was found of a problem with `synthesis`, complete with all that it may leave out.
struct LoadedTrains {
  std::int64_t choices = 0;  ///< Whole numbers that meet ratio and assembly.
  std::optional<LoadedTrain> lightest;
};

/// How many choices of whole numbers meet ratio and assembly, by their definitions alone.
std::int64_t count_loaded_choices(const nlohmann::json& problem);

/// Every choice of whole numbers, each with a grid of centre distances and shifts that is walked
/// down from its best places, and from those that miss a condition least. Formulas are those of
/// docs/gearbox_constraints.md and docs/derivations, written again from there; places of a ring's
/// root and the loss are found by sampling. `steps`: of the grid, in each direction. Cutters may
/// not be stated, the load's steel must be "case_hardened".
LoadedTrains enumerate_loaded_trains(const nlohmann::json& problem, int steps);

}  // namespace torquewright::oracles
