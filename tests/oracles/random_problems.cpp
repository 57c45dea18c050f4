// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/random_problems.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "tests/oracles/dice.hpp"
#include "tests/oracles/gearbox_rules.hpp"
#include "tests/oracles/involute_meshes.hpp"
#include "tests/oracles/named_problems.hpp"
#include "tests/oracles/reals.hpp"

namespace torquewright::oracles {
namespace {

using gearbox::ConstraintSet;
using gearbox::Objective;
using gearbox::Problem;

Rational tenths(std::int64_t count) { return Rational(count) / 10; }
Rational hundredths(std::int64_t count) { return Rational(count) / 100; }
Rational thousandths(std::int64_t count) { return Rational(count) / 1000; }

// A design that the problem is built around; it need not satisfy everything.
struct Model {
  Teeth teeth;
  std::int64_t planets = 0;
  Rational ratio;
};

Rational as_rational(const WideFraction& value) {
  return Rational(static_cast<std::int64_t>(value.numerator)) /
         static_cast<std::int64_t>(value.denominator);
}

bool is_short_decimal(const Rational& value) {
  const Rational scaled = value * 1000;
  return scaled.get_den() == 1 && scaled < 1000000;
}

// How large the gears are that a problem is about.
struct Size {
  std::int64_t least_teeth;
  std::int64_t bore;  // D/m
};

Model draw_model(Dice& dice, const Problem& problem, const Size& size) {
  const bool three_k = problem.topology == "3k";
  const std::int64_t bore = size.bore;
  const std::int64_t least = size.least_teeth;
  const std::int64_t n = dice.one_of(problem.planet_count);
  const std::int64_t sun = dice.between(least, std::max(least, bore / 2));
  const std::int64_t first = dice.between(least + n, std::max(least + n, (bore - sun) / 2));
  const std::int64_t second = dice.between(least, first - n);
  Model model{three_k ? complete_3k(sun, first, second) : complete_planetary(sun, first), n, 0};
  model.ratio = as_rational(three_k ? ratio_3k(model.teeth) : ratio_planetary(model.teeth));
  return model;
}

// What must hold for the model to be worth building a problem around.
bool is_promising(const Model& model, const Problem& problem, std::int64_t bore) {
  const Teeth& z = model.teeth;
  const bool distinct = z.planet_2 == 0 || problem.constraints == ConstraintSet::kPaper ||
                        (z.output_ring * z.planet_1 - z.fixed_ring * z.planet_2) %
                                (model.planets * std::gcd(z.planet_1, z.planet_2)) ==
                            0;
  const double sine = std::sin(std::numbers::pi / static_cast<double>(model.planets));
  return z.fixed_ring <= bore && z.planet_2 >= 0 && (z.sun + z.fixed_ring) % model.planets == 0 &&
         distinct &&
         static_cast<double>(z.sun + z.planet_1) * sine > static_cast<double>(z.planet_1 + 2);
}

Model draw_good_model(Dice& dice, const Problem& problem, const Size& size, bool exact) {
  Model model;
  for (int attempt = 0; attempt < 2000; ++attempt) {
    model = draw_model(dice, problem, size);
    if (is_promising(model, problem, size.bore) && (!exact || is_short_decimal(model.ratio))) break;
  }
  return model;
}

void draw_ratio(Dice& dice, Problem& problem, const Model& model, bool exact) {
  problem.target_ratio = exact && is_short_decimal(model.ratio)
                             ? model.ratio
                             : tenths(static_cast<std::int64_t>(model.ratio.get_d() * 10 + 0.5));
  if (dice.chance(8)) problem.target_ratio = dice.between(20, 240) * Rational(1, 4);
  problem.ratio_tolerance = 0;
  if (!exact)
    problem.ratio_tolerance = thousandths(dice.one_of<std::int64_t>({1, 2, 5, 10, 20, 30}));
}

// Mostly a little below the model's count, now and then a little above it.
std::int64_t draw_minimum(Dice& dice, std::int64_t least, std::int64_t teeth) {
  return std::max(std::min<std::int64_t>(12, least),
                  teeth - dice.between(dice.chance(12) ? -8 : 0, 25));
}

void draw_limits(Dice& dice, Problem& problem, const Size& size, const Model& model) {
  const Teeth& z = model.teeth;
  problem.min_teeth["sun"] = draw_minimum(dice, size.least_teeth, z.sun);
  if (problem.topology == "3k") {
    problem.min_teeth["planet_1"] = draw_minimum(dice, size.least_teeth, z.planet_1);
    problem.min_teeth["planet_2"] = draw_minimum(dice, size.least_teeth, z.planet_2);
  } else {
    problem.min_teeth["planet"] = draw_minimum(dice, size.least_teeth, z.planet_1);
  }
  const double angle_rad =
      std::numbers::pi / static_cast<double>(model.planets) -
      std::asin(static_cast<double>(z.planet_1) / static_cast<double>(z.sun + z.planet_1));
  const auto available = static_cast<std::int64_t>(std::floor(angle_rad * 100));
  problem.min_carrier_clearance_rad = 0;
  if (dice.chance(60)) {
    problem.min_carrier_clearance_rad =
        hundredths(std::max<std::int64_t>(0, available - dice.between(-2, 12)));
  }
}

void draw_building(Dice& dice, Problem& problem) {
  problem.min_contact_ratio = tenths(dice.one_of<std::int64_t>({10, 11, 12, 12, 12, 13, 15, 16}));
  problem.min_neighbour_clearance_mm = tenths(dice.one_of<std::int64_t>({0, 0, 0, 1, 3, 5, 10}));
  problem.sun_under_second_layer = dice.chance(75);
  if (dice.chance(25)) problem.ring_wall_mm = tenths(dice.between(5, 40));
  if (dice.chance(30)) {
    problem.ring_outer_diameter_mm =
        problem.rotor_inner_diameter_mm + tenths(dice.between(-20, 120));
  }
}

void draw_materials(Dice& dice, Problem& problem) {
  problem.friction_coefficient =
      hundredths(dice.chance(92) ? dice.between(2, 25) : dice.between(26, 90));
  problem.density_kg_m3 = dice.one_of<std::int64_t>({1140, 2700, 7850});
  problem.face_width_mm["layer_1"] = tenths(dice.between(40, 150));
  if (problem.topology == "3k") problem.face_width_mm["layer_2"] = tenths(dice.between(40, 150));
  const std::int64_t wall = dice.between(0, 70);  // In tenths of a mm; some problems state none.
  if (wall % 5 != 0) problem.hollow_shaft_wall_mm = tenths(wall);
  problem.rotor_inertia_kg_m2 = Rational(dice.between(0, 2000)) / 1000000;
}

void draw_kind(Dice& dice, Problem& problem) {
  const bool three_k = dice.chance(80);
  problem.topology = three_k ? "3k" : "planetary";
  problem.constraints =
      three_k && dice.chance(50) ? ConstraintSet::kPaper : ConstraintSet::kBuildable;
  std::vector<Objective> objectives{Objective::kMass, Objective::kHollowShaft,
                                    Objective::kForwardEfficiency, Objective::kBackwardEfficiency,
                                    Objective::kReflectedInertia};
  if (three_k) objectives.insert(objectives.end(), {Objective::kPaperCost, Objective::kPaperCost});
  problem.objective = dice.one_of(objectives);
}

// Only on paper are there gears of very few teeth: rings whose tip circle lies inside the base
// circle, meshes that lose contact.
Size draw_size(Dice& dice, const Problem& problem) {
  const bool on_paper = problem.constraints == ConstraintSet::kPaper;
  if (on_paper && dice.chance(25)) return {1, dice.between(9, 60)};
  const std::int64_t bore = dice.chance(92) ? dice.between(60, 180) : dice.between(181, 260);
  return {on_paper ? 12 : 18, bore};
}

// About what the model would bear, so that many just do and many just do not.
std::optional<Rational> draw_tip_radius(Dice& dice, long double bearable, std::int64_t most) {
  if (!(bearable >= 0)) return std::nullopt;
  const auto whole = static_cast<std::int64_t>(std::floor(bearable * 100));
  return hundredths(std::clamp<std::int64_t>(whole - dice.between(-6, 4), 0, most));
}

// The largest rounding of the hob that leaves what the ring's tip asks for.
long double bearable_hob(long double addendum, std::int64_t ring) {
  return (addendum - depth_at_ring_tip(ring)) / (addendum - straight_depth(addendum, 1));
}

// Of their own dice: a seed's problems are else as they always were.
void draw_addenda(Dice& dice, Problem& problem, const Model& model) {
  if (problem.constraints != ConstraintSet::kBuildable) return;
  if (dice.chance(40)) problem.cutters.hob_addendum = hundredths(dice.between(112, 140));
  if (dice.chance(40)) problem.cutters.shaper_addendum = hundredths(dice.between(105, 140));
  if (!dice.chance(25)) return;
  // Large enough for the ring that it just can be fed in, or just not.
  const Teeth& z = model.teeth;
  const std::int64_t ring =
      z.output_ring > 0 ? std::min(z.fixed_ring, z.output_ring) : z.fixed_ring;
  problem.cutters.shaper_teeth = std::max<std::int64_t>(14, ring - dice.between(13, 22));
}

void draw_cutters(Dice& dice, Problem& problem, const Model& model) {
  if (problem.constraints != ConstraintSet::kBuildable || dice.chance(40)) return;
  const Teeth& z = model.teeth;
  const bool three_k = z.output_ring > 0;
  gearbox::StatedCutters& cutters = problem.cutters;
  if (dice.chance(70)) {
    const std::int64_t ring = three_k ? std::min(z.fixed_ring, z.output_ring) : z.fixed_ring;
    cutters.hob_tip_radius =
        draw_tip_radius(dice, bearable_hob(to_long_double(cutters.hob_depth()), ring), 38);
  }
  if (dice.chance(60)) {
    const std::int64_t teeth = dice.between(14, 40);
    if (!cutters.shaper_teeth) cutters.shaper_teeth = teeth;
    std::int64_t radius = 30;
    while (radius > 0 &&
           reach_of_shaper(*cutters.shaper_teeth, to_long_double(cutters.shaper_depth()),
                           0.01L * real(radius)) < reach_of_planet(z.planet_1)) {
      --radius;
    }
    if (dice.chance(80)) {
      cutters.shaper_tip_radius =
          draw_tip_radius(dice, 0.01L * real(radius), *cutters.shaper_teeth < 18 ? 25 : 30);
    }
  }
}

Problem draw_problem(Dice& dice, Dice& cutter_dice, Dice* addendum_dice) {
  Problem problem;
  draw_kind(dice, problem);
  problem.module_mm = dice.one_or_more_of<Rational>(
      {tenths(4), tenths(5), tenths(6), tenths(7), tenths(8), tenths(10)});
  problem.planet_count = dice.one_or_more_of<std::int64_t>({3, 4, 5, 6});
  const Size size = draw_size(dice, problem);
  const Rational& module = dice.one_of(problem.module_mm);
  problem.rotor_inner_diameter_mm = size.bore * module + tenths(dice.between(0, 3));
  const bool exact = dice.chance(50);
  const Model model = draw_good_model(dice, problem, size, exact);
  draw_ratio(dice, problem, model, exact);
  draw_limits(dice, problem, size, model);
  draw_building(dice, problem);
  draw_materials(dice, problem);
  if (addendum_dice != nullptr) draw_addenda(*addendum_dice, problem, model);
  draw_cutters(cutter_dice, problem, model);
  return problem;
}

}  // namespace

std::vector<Problem> random_problems(std::uint64_t seed, std::size_t count, Addenda addenda) {
  std::vector<Problem> problems{d151_problem()};
  for (const HardProblem& hard : hard_problems()) problems.push_back(hard.problem);
  problems.resize(std::min(problems.size(), count));
  Dice dice(seed);
  Dice cutter_dice(~seed);  // Of their own: the rest of a seed's problems is as it always was.
  Dice addendum_dice(seed ^ 0xaddUL);
  Dice* const stating = addenda == Addenda::kSomeStated ? &addendum_dice : nullptr;
  while (problems.size() < count) {
    problems.push_back(draw_problem(dice, cutter_dice, stating));
    problems.back().name = "random " + std::to_string(problems.size());
  }
  return problems;
}

}  // namespace torquewright::oracles
