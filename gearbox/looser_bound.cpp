// SPDX-License-Identifier: Apache-2.0
#include "gearbox/looser_bound.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gearbox/alternatives.hpp"

namespace torquewright::gearbox {
namespace {

using optimization::PreciseInterval;
using optimization::SearchResult;
using optimization::SearchStatus;

constexpr const char* kBoreKey = "/rotor_inner_diameter_mm";
// A rotor may grow to so many times its size before "a larger rotor" is no advice any more.
constexpr std::int64_t kMostGrowth = 8;

Alternatives loosened(const Problem& problem, const std::string& key,
                      const std::function<std::int64_t(const Rational&)>& ring_limit) {
  return Alternatives(
      problem, [&](const std::string&, const std::string& of) { return of != key; }, ring_limit,
      key);
}

SearchResult search(const Alternatives& alternatives, const SynthesisOptions& options) {
  optimization::SearchOptions search_options;
  search_options.relaxation = options.relaxation;
  search_options.should_stop = options.should_stop;
  return optimization::minimise(alternatives.judges(), search_options);
}

struct Found {
  Alternatives alternatives;
  SearchResult result;
};

// With the bore out of the way the rings have no bound: they are let grow until a design is found,
// and the proof is then made for rings that would be smaller than its own.
Found find(const Problem& problem, const std::string& key, const SynthesisOptions& options) {
  const auto within_bore = [&](const Rational& module_mm) {
    return ring_limit_of_bore(problem, module_mm);
  };
  if (key != kBoreKey) {
    Alternatives alternatives = loosened(problem, key, within_bore);
    SearchResult result = search(alternatives, options);
    return {std::move(alternatives), std::move(result)};
  }
  for (std::int64_t growth = 2;; growth *= 2) {
    Alternatives grown = loosened(problem, key, [&](const Rational& module_mm) {
      return growth * (within_bore(module_mm) + 1);
    });
    SearchResult result = search(grown, options);
    if (result.solutions.empty() && growth < kMostGrowth) continue;
    if (result.solutions.empty()) return {std::move(grown), std::move(result)};
    const Design best = grown.design(result.solutions.front());
    const Rational ring_mm = best.module_mm * Rational(*std::max_element(best.teeth.begin(),
                                                                         best.teeth.end()));
    Alternatives exact = loosened(problem, key, [&](const Rational& module_mm) {
      return floor_of(ring_mm / module_mm);
    });
    SearchResult proof = search(exact, options);
    return {std::move(exact), std::move(proof)};
  }
}

// The double next to the quantity whose shortest decimal is a bound that the quantity meets.
double safe_decimal(const PreciseInterval& quantity, bool is_minimum) {
  double value = quantity.nearest();
  const double inwards = is_minimum ? -HUGE_VAL : HUGE_VAL;
  const auto misses = [&] {
    const PreciseInterval spare =
        is_minimum ? quantity - PreciseInterval(io::exact(value))
                   : PreciseInterval(io::exact(value)) - quantity;
    return spare.is_negative();
  };
  while (misses()) value = std::nextafter(value, inwards);
  return value;
}

double bound_as_it_stands(const Problem& problem, const std::string& key) {
  const std::string gear_prefix = "/min_teeth/";
  if (key.starts_with(gear_prefix)) {
    return static_cast<double>(problem.min_teeth.at(key.substr(gear_prefix.size())));
  }
  if (key == "/min_carrier_clearance_rad") return io::nearest(problem.min_carrier_clearance_rad);
  if (key == kBoreKey) return io::nearest(problem.rotor_inner_diameter_mm);
  if (key == "/ratio_tolerance") return io::nearest(problem.ratio_tolerance);
  if (key == "/min_contact_ratio") return io::nearest(problem.min_contact_ratio);
  if (key == "/min_neighbour_clearance_mm") return io::nearest(problem.min_neighbour_clearance_mm);
  return io::nearest(problem.ring_outer_diameter_mm.value_or(0));
}

// Four digits, rounded to the side on which the bound is met.
double four_digits(double value, bool is_minimum) {
  if (value == 0.0) return 0.0;
  const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 3.0);
  return (is_minimum ? std::floor(value / unit * (1 + 1e-15))
                     : std::ceil(value / unit * (1 - 1e-15))) * unit;
}

std::string sentence(const LooserBound& bound, bool is_minimum) {
  const std::string unit = bound.unit.empty() ? "" : " " + bound.unit;
  return fmt::format("{} = {:g}{} is too {}: {:.4g}{} would do ({} with n = {}, module {:g} mm).",
                     bound.key.substr(1), bound.limit, unit, is_minimum ? "much" : "little",
                     four_digits(bound.needed, is_minimum), unit,
                     fmt::join(bound.design.teeth, "/"), bound.design.planet_count,
                     io::nearest(bound.design.module_mm));
}

}  // namespace

std::vector<std::string> keys_of(const Problem& problem,
                                 const std::vector<ConflictMember>& conflict) {
  const Alternatives alternatives(problem);
  std::vector<std::string> keys;
  for (const ConflictMember& member : conflict) {
    for (const auto& condition : alternatives.judges().front().problem().conditions) {
      const bool is_known = std::find(keys.begin(), keys.end(), condition.key) != keys.end();
      if (condition.constraint == member.constraint && !condition.key.empty() && !is_known) {
        keys.push_back(condition.key);
      }
    }
  }
  return keys;
}

std::optional<ProvedBound> least_change(const Problem& problem, const std::string& key,
                                        const SynthesisOptions& options) {
  Found found = find(problem, key, options);
  if (found.result.status != SearchStatus::kComplete || found.result.solutions.empty()) {
    return std::nullopt;
  }
  const optimization::Goal& goal = found.alternatives.goal();
  const optimization::Solution& best = found.result.solutions.front();
  const PreciseInterval quantity = goal.maximise ? -best.cost : best.cost;
  ProvedBound proved;
  proved.bound = {key, bound_as_it_stands(problem, key), safe_decimal(quantity, goal.maximise),
                  goal.unit, found.alternatives.design(best), ""};
  proved.bound.sentence = sentence(proved.bound, goal.maximise);
  proved.claim = {"least_relaxation", found.alternatives.constraints(), goal.name,
                  proved.bound.design, key, std::nullopt,
                  found.alternatives.proofs(std::move(found.result.proofs))};
  return proved;
}

}  // namespace torquewright::gearbox
