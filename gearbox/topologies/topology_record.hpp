// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "gearbox/constraints/design_report.hpp"
#include "gearbox/problem.hpp"
#include "gearbox/train/assembly_phase.hpp"
#include "gearbox/train/power_flow.hpp"
#include "gearbox/train_parts.hpp"
#include "optimization/discrete/problem.hpp"

namespace torquewright::gearbox {

/// How drawings show a gear.
struct DrawnPart {
  std::string_view shape;   ///< Which it is drawn and coloured as: sun, planet_1, ...
  std::string_view symbol;  ///< As in the documentation: S, P1, ...
  std::string_view label;
};

using ToothCounts = std::span<const std::int64_t>;  ///< In the topology's order.
using Numbers = std::span<const double>;

/// A kind of gear train: its parts (train_parts.cpp) and all that is asked of it. Its file in
/// topologies/, its model beside it, and one line in topology.cpp. Teeth are positive.
struct Topology : TrainParts {
  /// All teeth from the free ones, by coaxiality without profile shift.
  std::function<std::vector<std::int64_t>(ToothCounts free_teeth)> complete = {};

  /// The synthesis problem for one planet count and module (docs/gearbox_constraints.md), for rings
  /// of at most `ring_limit` teeth: floor(D/m) where the rotor's bore is to be respected. Absent,
  /// as the next two: a train that is searched with synthesis only.
  optimization::Problem (*model)(const Problem& problem, std::int64_t planet_count,
                                 const Rational& module_mm, std::int64_t ring_limit) = nullptr;

  /// The free teeth at a point of the model, and the point of free teeth.
  std::vector<std::int64_t> (*free_teeth)(ToothCounts point) = nullptr;
  std::vector<std::int64_t> (*point_of)(ToothCounts free_teeth) = nullptr;

  /// Everything about one design, every constraint included. Any positive teeth are accepted.
  std::function<DesignReport(const Problem& problem, const Design& design)> evaluate = {};

  /// Sun speed over output speed, signed; infinite where the output stands still.
  std::function<double(Numbers teeth)> reduction = {};

  /// Tangential forces on one planet for 1 Nm at the sun, by mesh; without losses, all planets
  /// sharing alike, on the working circles of that centre distance.
  std::function<std::vector<double>(Numbers teeth, std::int64_t planet_count, double centre_m)>
      forces_N = {};

  /// Returns the efficiency of the whole train from those of its meshes.
  std::function<TrainEfficiency(Numbers teeth, Numbers mesh_efficiencies)> efficiency = {};

  /// How it stands when it is assembled.
  std::function<AssemblyPhase(ToothCounts teeth, std::int64_t planet_count)> assemble = {};

  /// The largest teeth of exactly the ratio of these, of which the held ring has at most so many;
  /// empty: there are none. Absent: a train whose teeth stay when its module changes.
  std::vector<std::int64_t> (*largest_of_same_ratio)(ToothCounts teeth,
                                                     std::int64_t most) = nullptr;

  std::vector<DrawnPart> drawn = {};         ///< By gear.
  std::vector<std::string_view> views = {};  ///< Titles, by layer.
};

}  // namespace torquewright::gearbox
