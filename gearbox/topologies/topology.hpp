// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "gearbox/constraints/design_report.hpp"
#include "gearbox/problem.hpp"
#include "optimization/discrete/problem.hpp"

namespace torquewright::gearbox {

/// A kind of gear train. Its file in topologies/, its model beside it, and one line in
/// topology.cpp.
struct Topology {
  std::string_view name;                ///< As in documents.
  std::vector<std::string_view> gears;  ///< In the order of Design::teeth.
  std::size_t free_gears;               ///< The first so many are free; the rings follow.

  /// All teeth from the free ones, by coaxiality without profile shift.
  std::vector<std::int64_t> (*complete)(std::span<const std::int64_t> free_teeth);

  /// The synthesis problem for one planet count and module (docs/gearbox_constraints.md), for rings
  /// of at most `ring_limit` teeth: floor(D/m) where the rotor's bore is to be respected.
  optimization::Problem (*model)(const Problem& problem, std::int64_t planet_count,
                                 const Rational& module_mm, std::int64_t ring_limit);

  /// The free teeth at a point of the model, and the point of free teeth.
  std::vector<std::int64_t> (*free_teeth)(std::span<const std::int64_t> point);
  std::vector<std::int64_t> (*point_of)(std::span<const std::int64_t> free_teeth);

  /// Everything about one design, every constraint included. Any positive teeth are accepted.
  DesignReport (*evaluate)(const Problem& problem, const Design& design);
};

/// All topologies, in the order of the documentation.
std::span<const Topology> topologies();

/// The topology of that name; nullptr if there is none.
const Topology* find_topology(std::string_view name);

}  // namespace torquewright::gearbox
