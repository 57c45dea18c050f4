// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/gearbox_enumeration.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tests/oracles/gearbox_objectives.hpp"
#include "tests/oracles/rule_families.hpp"

namespace torquewright::oracles {
namespace {

constexpr long double kEqual = 1e-12L;

// The loops for one planet count and module.
class Sweep {
 public:
  Sweep(const Setting& setting, std::size_t module_index, const Switches& off, Enumeration& result)
      : setting_(setting),
        module_index_(module_index),
        rules_(rules(setting, off)),
        range_(ratio_range(setting.problem)),
        bore_(floor_of(setting.problem.rotor_inner_diameter_mm / setting.module_mm)),
        result_(result) {}

  void all_of_3k() {
    for (std::int64_t sun = 1; sun <= bore_ - 2; ++sun) {
      for (std::int64_t first = 1; first <= (bore_ - sun) / 2; ++first) {
        for (std::int64_t second = 1; second <= bore_ / 2; ++second) {
          judge(complete_3k(sun, first, second));
        }
      }
    }
  }

  void all_of_planetary() {
    for (std::int64_t sun = 1; sun <= bore_ - 2; ++sun) {
      for (std::int64_t planet = 1; planet <= (bore_ - sun) / 2; ++planet) {
        judge(complete_planetary(sun, planet));
      }
    }
  }

  void inverse_of_3k() {
    if (range_.greatest.numerator <= 0) return;  // With P1 > P2 the output follows the input.
    for (std::int64_t sun = 1; sun <= bore_ - 2; ++sun) {
      for (std::int64_t first = 1; first <= (bore_ - sun) / 2; ++first) second_planets(sun, first);
    }
  }

  void inverse_of_planetary() {
    for (std::int64_t sun = 1; sun <= bore_ - 2; ++sun) {
      // i = 2 + 2 P/S, so P lies between (G_least/2 - 1) S and (G_greatest/2 - 1) S.
      const auto [l, lq] = range_.least;
      const auto [g, gq] = range_.greatest;
      const Wide least =
          std::max<Wide>(1, ceil_divide(Wide{sun} * (l - 2 * Wide{lq}), 2 * Wide{lq}));
      const Wide most = std::min<Wide>((bore_ - sun) / 2,
                                       floor_divide(Wide{sun} * (g - 2 * Wide{gq}), 2 * Wide{gq}));
      for (Wide planet = least; planet <= most; ++planet) {
        judge(complete_planetary(sun, static_cast<std::int64_t>(planet)));
      }
    }
  }

 private:
  // i <= G turns into d >= 2 P1 (S + 2 P1)/(G S + 2 P1), and the other way round: both sides of
  // i S d = 2 P1 (S + 2 P1 - d) are linear in d = P1 - P2.
  void second_planets(std::int64_t sun, std::int64_t first) {
    const Wide product = Wide{2 * first} * (sun + 2 * first);
    const auto divisor = [&](const Fraction& limit) {
      return Wide{limit.numerator} * sun + Wide{limit.denominator} * 2 * first;
    };
    const Wide least = std::max<Wide>(
        1, ceil_divide(product * range_.greatest.denominator, divisor(range_.greatest)));
    Wide most = first - 1;
    if (range_.least.numerator > 0) {
      most =
          std::min(most, floor_divide(product * range_.least.denominator, divisor(range_.least)));
    }
    for (Wide difference = least; difference <= most; ++difference) {
      judge(complete_3k(sun, first, first - static_cast<std::int64_t>(difference)));
    }
  }

  void judge(const Teeth& teeth) {
    Found found{teeth, setting_.planet_count, module_index_, 0};
    for (const Rule& rule : rules_) {
      const Judgement judgement = rule.judge(teeth);
      if (judgement.near_tie) result_.near_ties.push_back({found, rule.name, judgement.margin});
      if (!judgement.holds) return;
    }
    found.objective = objective_value(setting_, teeth);
    result_.feasible.push_back(found);
  }

  Setting setting_;
  std::size_t module_index_;
  std::vector<Rule> rules_;
  RatioRange range_;
  std::int64_t bore_;
  Enumeration& result_;
};

Setting setting_of(const gearbox::Problem& problem, const Found& found) {
  return {problem, found.planet_count, problem.module_mm.at(found.module_index)};
}

std::vector<Found> as_good_as_the_best(const gearbox::Problem& problem,
                                       const std::vector<Found>& feasible) {
  const long double sign = greater_is_better(problem.objective) ? -1 : 1;
  long double least = HUGE_VALL;
  for (const Found& found : feasible) least = std::min(least, sign * found.objective);
  std::vector<Found> best;
  for (const Found& found : feasible) {
    if (sign * found.objective - least <= kEqual * std::fabs(least)) best.push_back(found);
  }
  return best;
}

// Long doubles have found the few that may be equal; fractions say which of them are.
void keep_cheapest(const gearbox::Problem& problem, std::vector<Found>& best) {
  std::vector<Rational> costs;
  for (const Found& found : best) {
    costs.push_back(paper_cost(setting_of(problem, found), found.teeth));
  }
  const Rational least = *std::min_element(costs.begin(), costs.end());
  std::vector<Found> cheapest;
  for (std::size_t i = 0; i < best.size(); ++i) {
    if (costs[i] == least) cheapest.push_back(best[i]);
  }
  best = std::move(cheapest);
}

void sweep(Sweep loops, bool three_k, Loops kind) {
  if (three_k) {
    kind == Loops::kAll ? loops.all_of_3k() : loops.inverse_of_3k();
  } else {
    kind == Loops::kAll ? loops.all_of_planetary() : loops.inverse_of_planetary();
  }
}

}  // namespace

Enumeration enumerate(const gearbox::Problem& problem, Loops loops, const Switches& off) {
  if (off.contains("rotor_bore")) throw std::invalid_argument("the bore bounds the loops");
  if (loops == Loops::kInverse && (off.contains("ratio") || off.contains("tooth_difference"))) {
    throw std::invalid_argument("the inverse loops rest on ratio and tooth_difference");
  }
  Enumeration result;
  for (const std::int64_t planets : problem.planet_count) {
    for (std::size_t index = 0; index < problem.module_mm.size(); ++index) {
      const Setting setting{problem, planets, problem.module_mm[index]};
      sweep(Sweep(setting, index, off, result), is_3k(problem), loops);
    }
  }
  result.best = as_good_as_the_best(problem, result.feasible);
  if (problem.objective == gearbox::Objective::kPaperCost && !result.best.empty()) {
    keep_cheapest(problem, result.best);
  }
  return result;
}

std::vector<std::string> violations(const gearbox::Problem& problem, const gearbox::Design& design,
                                    const Switches& off) {
  const std::vector<std::int64_t>& z = design.teeth;
  const Teeth teeth = is_3k(problem) ? Teeth{z.at(0), z.at(1), z.at(2), z.at(3), z.at(4)}
                                     : Teeth{z.at(0), z.at(1), 0, z.at(2), 0};
  std::vector<std::string> violated;
  for (const Rule& rule : rules({problem, design.planet_count, design.module_mm}, off)) {
    if (!rule.judge(teeth).holds) violated.push_back(rule.name);
  }
  return violated;
}

gearbox::Design to_design(const gearbox::Problem& problem, const Found& found) {
  const Teeth& z = found.teeth;
  gearbox::Design design;
  design.teeth = is_3k(problem)
                     ? std::vector{z.sun, z.planet_1, z.planet_2, z.fixed_ring, z.output_ring}
                     : std::vector{z.sun, z.planet_1, z.fixed_ring};
  design.planet_count = found.planet_count;
  design.module_mm = problem.module_mm.at(found.module_index);
  return design;
}

}  // namespace torquewright::oracles
