// SPDX-License-Identifier: Apache-2.0
// Floors and ceilings on what is reported. Oracle of all tests here: exhaustive enumeration, which
// has each quantity from its own definition (tests/oracles/floor_rules).
#include "gearbox/floors.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <map>
#include <string_view>

#include "gearbox/topologies/topology.hpp"
#include "tests/gearbox/search/search_comparison.hpp"
#include "tests/long_run.hpp"
#include "tests/oracles/dice.hpp"
#include "tests/oracles/gearbox_enumeration.hpp"
#include "tests/oracles/problem_document.hpp"
#include "tests/oracles/random_problems.hpp"

namespace torquewright::search_test {
namespace {

using gearbox::FloorQuantity;
using gearbox::FloorRecord;
using gearbox::Problem;
using io::Rational;
using optimization::RelaxationUse;

constexpr RelaxationUse kTurns[] = {RelaxationUse::kAuto, RelaxationUse::kAlways,
                                    RelaxationUse::kNever};

double reported(const FloorRecord& floor, const Problem& problem,
                const gearbox::DesignReport& report) {
  switch (floor.quantity) {
    case FloorQuantity::kForwardEfficiency:
      return report.forward_efficiency;
    case FloorQuantity::kBackwardEfficiency:
      return report.backward_efficiency;
    case FloorQuantity::kHollowShaft:
      return report.hollow_shaft_diameter_mm;
    case FloorQuantity::kMass:
      return report.mass_kg.value();
    case FloorQuantity::kReflectedInertia:
      return report.reflected_inertia_kg_m2.value();
    case FloorQuantity::kBacklash:
      return report.output_backlash_rad_per_mm;
    case FloorQuantity::kAxialLength:
      break;
  }
  double sum_mm = 0.0;
  for (const auto& [layer, width_mm] : problem.face_width_mm) sum_mm += io::nearest(width_mm);
  return sum_mm;
}

/// A decimal of five digits.
Rational short_decimal(double value) { return io::exact(std::stod(fmt::format("{:.5g}", value))); }

/// Limits just inside or just outside of what a feasible design has.
void ask_floors(oracles::Dice& dice, const oracles::Found& near, Problem& problem) {
  const auto report = gearbox::find_topology(problem.topology)
                          ->evaluate(problem, oracles::to_design(problem, near));
  const std::int64_t count = dice.between(1, 3);
  for (std::int64_t i = 0; i < count; ++i) {
    const auto which = static_cast<std::size_t>(dice.between(0, gearbox::kFloors.size() - 1));
    const FloorRecord& floor = gearbox::kFloors[which];
    const double change = 1.0 + 0.001 * static_cast<double>(dice.between(-8, 8));
    problem.floors.*floor.limit = short_decimal(reported(floor, problem, report) * change);
  }
}

TEST(Floors, AgreeWithEnumerationOnRandomProblems) {
  oracles::Dice dice(47);
  std::map<std::string_view, int> stated;
  int infeasible = 0, narrowed = 0;
  std::size_t index = 0;
  const bool is_long = test::is_long_run();
  for (Problem problem : oracles::random_problems(47, is_long ? 50 : 22)) {
    if (problem.face_width_mm.empty()) continue;
    const Truth free = enumerated(problem);
    if (free.ranked.empty() || free.ranked.size() > 300) continue;
    ask_floors(dice, dice.one_of(free.ranked), problem);
    const Truth truth = enumerated(problem);
    if (truth.is_doubtful) continue;
    const RelaxationUse use = kTurns[index++ % 3];
    const Comparison comparison = compare(problem, truth, use, 1 + index % 3);
    EXPECT_TRUE(comparison.disagreements.empty())
        << fmt::format("{}: {}\n{}", problem.name, fmt::join(comparison.disagreements, "; "),
                       oracles::problem_document(problem).dump());
    infeasible += truth.ranked.empty();
    narrowed += truth.ranked.size() < free.ranked.size();
    for (const FloorRecord& floor : gearbox::kFloors) {
      stated[floor.name] += (problem.floors.*floor.limit).has_value();
    }
  }
  EXPECT_GT(infeasible, 0);
  EXPECT_GT(narrowed, 3);
  if (!is_long) return;
  for (const FloorRecord& floor : gearbox::kFloors) EXPECT_GT(stated[floor.name], 2) << floor.name;
}

}  // namespace
}  // namespace torquewright::search_test
