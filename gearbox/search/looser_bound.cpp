// SPDX-License-Identifier: Apache-2.0
#include "gearbox/search/looser_bound.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "gearbox/floors.hpp"
#include "gearbox/problem_spec.hpp"
#include "gearbox/search/alternatives.hpp"
#include "gearbox/walls.hpp"

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

SearchResult search(const Alternatives& alternatives, const DesignSearchOptions& options) {
  optimization::SearchOptions search_options;
  search_options.relaxation = options.relaxation;
  search_options.should_stop = options.should_stop;
  return optimization::minimise(alternatives.judges(), search_options);
}

struct Found {
  Alternatives alternatives;
  SearchResult result;

  Design best() const { return alternatives.design(result.solutions.front()); }
};

// The bore that a design needs: its held ring's pitch circle, or the blank where that has to fit.
Rational needed_bore_mm(const Problem& problem, const Design& design) {
  const Rational ring{*std::max_element(design.teeth.begin(), design.teeth.end())};
  const bool holds_blank =
      problem.constraints == ConstraintSet::kBuildable && ring_space_key(problem) == kBoreKey;
  return holds_blank ? ring_blank_mm(problem, design.module_mm, ring) : design.module_mm * ring;
}

// The domain limits sun and planets, not their ring: a design whose ring is the smallest in it may
// be beaten by one with larger planets. Searching up to the bore just found either confirms it or
// finds a smaller one, and its domain is the one the proof has to be made for.
Found with_smallest_ring(const Problem& problem, Found found, const DesignSearchOptions& options) {
  for (;;) {
    const Rational known_mm = needed_bore_mm(problem, found.best());
    Alternatives alternatives = loosened(problem, kBoreKey, [&](const Rational& module_mm) {
      return floor_of(known_mm / module_mm);
    });
    SearchResult result = search(alternatives, options);
    found = {std::move(alternatives), std::move(result)};
    if (found.result.solutions.empty() || needed_bore_mm(problem, found.best()) == known_mm) {
      return found;
    }
  }
}

// With the bore out of the way the rings have no bound: they are let grow until a design is found,
// and the proof is then made for rings that would be smaller than its own.
Found find(const Problem& problem, const std::string& key, const DesignSearchOptions& options) {
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
    return with_smallest_ring(problem, {std::move(grown), std::move(result)}, options);
  }
}

// Neighbours have to be further apart than the limit: a limit of what there is would not do.
bool must_be_exceeded(const std::string& key) { return key == "/min_neighbour_clearance_mm"; }

// The double next to the quantity whose shortest decimal is a bound that the quantity meets. Around
// zero doubles lie so close that stepping from one to the next would not end, so the second guess
// is the quantity's own end; its neighbour is further in than any decimal that rounds to the end.
double safe_decimal(const PreciseInterval& quantity, bool is_minimum, bool is_strict) {
  const auto misses = [&](double value) {
    const PreciseInterval spare = is_minimum ? quantity - PreciseInterval(io::exact(value))
                                             : PreciseInterval(io::exact(value)) - quantity;
    return is_strict ? !spare.is_positive() : spare.is_negative();
  };
  const optimization::Interval around = quantity.outward();
  const double end = is_minimum ? around.lower : around.upper;
  if (!misses(quantity.nearest())) return quantity.nearest();
  return misses(end) ? std::nextafter(end, is_minimum ? -HUGE_VAL : HUGE_VAL) : end;
}

double bound_as_it_stands(const Problem& problem, const std::string& key) {
  for (const FloorRecord& floor : kFloors) {
    if (floor.key == key) return io::nearest((problem.floors.*floor.limit).value());
  }
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

// Four digits, rounded to the side on which the bound is met. A value of four digits stays as it
// is, unless the bound has to be exceeded: then it lies just inside of them.
double four_digits(double value, bool is_minimum, bool is_strict) {
  if (value == 0.0) return 0.0;
  const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 3.0);
  const double slack = is_strict ? -1e-15 : 1e-15;
  return (is_minimum ? std::floor(value / unit * (1 + slack))
                     : std::ceil(value / unit * (1 - slack))) *
         unit;
}

std::string sentence(const LooserBound& bound, bool is_minimum) {
  const std::string unit = bound.unit.empty() ? "" : " " + bound.unit;
  return fmt::format(
      "{} = {:g}{} is too {}: {:.4g}{} would do ({} with {} planets, module {:g} mm).",
      bound.key.substr(1), bound.limit, unit, is_minimum ? "much" : "little",
      four_digits(bound.needed, is_minimum, must_be_exceeded(bound.key)), unit,
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

LooserBound looser_bound(const Problem& problem, const std::string& key, double needed,
                         const Design& design) {
  const optimization::Problem model = find_topology(problem.topology)
                                          ->model(problem, design.planet_count, design.module_mm,
                                                  ring_limit_of_bore(problem, design.module_mm));
  const auto loosening = std::find_if(model.loosenings.begin(), model.loosenings.end(),
                                      [&](const auto& each) { return each.key == key; });
  if (loosening == model.loosenings.end()) throw std::logic_error("not a bound: " + key);
  const optimization::Goal& goal = loosening->quantity;
  LooserBound bound{key, bound_as_it_stands(problem, key), needed, goal.unit, design, ""};
  bound.sentence = sentence(bound, goal.maximise);
  return bound;
}

std::optional<ProvedBound> least_change(const Problem& problem, const std::string& key,
                                        const DesignSearchOptions& options) {
  Found found = find(problem, key, options);
  if (found.result.status != SearchStatus::kComplete || found.result.solutions.empty()) {
    return std::nullopt;
  }
  const optimization::Goal& goal = found.alternatives.goal();
  const optimization::Solution& best = found.result.solutions.front();
  const PreciseInterval quantity = goal.maximise ? -best.cost : best.cost;
  ProvedBound proved;
  const double needed = safe_decimal(quantity, goal.maximise, must_be_exceeded(key));
  if (!may_be_stated(key, needed)) return std::nullopt;  // the reader would refuse such a remedy
  proved.bound = looser_bound(problem, key, needed, found.alternatives.design(best));
  proved.claim = {"least_relaxation",
                  found.alternatives.constraints(),
                  goal.name,
                  proved.bound.design,
                  key,
                  std::nullopt,
                  found.alternatives.proofs(std::move(found.result.proofs))};
  proved.search = std::move(found.result);
  return proved;
}

}  // namespace torquewright::gearbox
