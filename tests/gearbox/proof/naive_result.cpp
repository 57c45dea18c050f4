// SPDX-License-Identifier: Apache-2.0
#include "tests/gearbox/proof/naive_result.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace torquewright::gearbox::proof_test {
namespace {

constexpr long kRingLimit = 200;

/// The bound that the rings' blanks have to fit into.
std::string space_key(const Problem& problem) {
  return problem.ring_outer_diameter_mm ? "/ring_outer_diameter_mm" : "/rotor_inner_diameter_mm";
}

/// Which of the problem's constraints a bound sets.
std::vector<std::string> set_by(const Problem& problem, const std::string& key) {
  const std::vector<std::pair<std::string, std::string>> table = {
      {"/ratio_tolerance", "ratio"},
      {"/min_teeth/sun", "min_teeth.sun"},
      {"/min_teeth/planet_1", "min_teeth.planet_1"},
      {"/min_teeth/planet_2", "min_teeth.planet_2"},
      {"/min_carrier_clearance_rad", "carrier_clearance"},
      {"/rotor_inner_diameter_mm", "rotor_bore"},
      {space_key(problem), "ring_wall."},
      {"/min_contact_ratio", "contact_ratio."},
      {"/min_neighbour_clearance_mm", "neighbour_clearance."}};
  std::vector<std::string> names;
  for (const auto& [bound, prefix] : table) {
    if (bound != key) continue;
    for (const std::string& name : constraint_names(problem)) {
      if (name.rfind(prefix, 0) == 0) names.push_back(name);
    }
  }
  return names;
}

std::vector<std::string> without(const std::vector<std::string>& names,
                                 const std::vector<std::string>& gone) {
  std::vector<std::string> rest;
  for (const std::string& name : names) {
    if (std::find(gone.begin(), gone.end(), name) == gone.end()) rest.push_back(name);
  }
  return rest;
}

bool is_among(const std::string& name, const std::vector<std::string>& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string relaxed_quantity(const Problem& problem, const std::string& key) {
  if (key.rfind("/min_teeth/", 0) == 0) return "teeth." + key.substr(11);
  if (key == "/min_carrier_clearance_rad") return "carrier_clearance";
  const bool is_walled = problem.constraints == ConstraintSet::kBuildable;
  if (is_walled && key == space_key(problem)) return "ring_blank_diameter_mm";
  if (key == "/ratio_tolerance") return "ratio_error";
  if (key == "/min_contact_ratio") return "contact_ratio";
  if (key == "/min_neighbour_clearance_mm") return "neighbour_clearance_mm";
  return "ring_pitch_diameter_mm";
}

Json limit_of(const Problem& problem, const std::string& key) {
  if (key.rfind("/min_teeth/", 0) == 0) return problem.min_teeth.at(key.substr(11));
  if (key == "/min_carrier_clearance_rad") return number(problem.min_carrier_clearance_rad);
  if (key == "/rotor_inner_diameter_mm") return number(problem.rotor_inner_diameter_mm);
  if (key == "/ratio_tolerance") return number(problem.ratio_tolerance);
  if (key == "/min_contact_ratio") return number(problem.min_contact_ratio);
  if (key == "/min_neighbour_clearance_mm") return number(problem.min_neighbour_clearance_mm);
  return number(*problem.ring_outer_diameter_mm);
}

/// Best first by a quantity.
void sort_by(const std::string& name, const Problem& problem, std::vector<PlainDesign>& designs) {
  const double sign = greater_is_better(name) ? -1 : 1;
  std::stable_sort(designs.begin(), designs.end(), [&](const auto& a, const auto& b) {
    return sign * quantity(name, choice_of(a, problem), a.gears) <
           sign * quantity(name, choice_of(b, problem), b.gears);
  });
}

Json whole_or_real(const std::string& key, double value) {
  if (key.rfind("/min_teeth/", 0) == 0) return static_cast<long>(value);
  return value;
}

/// On the side on which the design passes, by more than the rounding of 1 - i/G.
double safe(const std::string& name, double value) {
  const double away = greater_is_better(name) ? -1 : 1;
  return value + away * 5e-13 * std::abs(value);
}

Json shown_design(const PlainDesign& design, const Problem& problem) {
  Json json = design_json(design, problem);
  const auto& [sun, first, second] = design.gears;
  const bool planetary = is_planetary(problem);
  long numerator = planetary ? 2 * (sun + first) : 2 * first * (sun + first + second);
  long denominator = planetary ? sun : sun * (first - second);
  const long divisor = std::gcd(numerator, denominator);
  json["ratio"] = {{"numerator", numerator / divisor},
                   {"denominator", denominator / divisor},
                   {"value", static_cast<double>(numerator) / static_cast<double>(denominator)}};
  const long offset = planetary ? 0
                                : ((sun + first + second) * first - (sun + 2 * first) * second) /
                                      std::gcd(first, second);
  json["planet_types"] =
      planetary ? 1 : design.planet_count / std::gcd(design.planet_count, offset);
  json["objective"] = quantity(objective_name(problem), choice_of(design, problem), design.gears);
  return json;
}

std::vector<std::string> smallest_conflict(const Problem& problem) {
  std::vector<std::string> conflict = constraint_names(problem);
  for (const std::string& name : constraint_names(problem)) {
    const auto fewer = without(conflict, {name});
    if (find_all(problem, fewer, is_among("rotor_bore", fewer) ? 0 : kRingLimit).empty()) {
      conflict = fewer;
    }
  }
  return conflict;
}

}  // namespace

std::vector<PlainDesign> find_all(const Problem& problem, const std::vector<std::string>& names,
                                  long largest_ring) {
  PlainClaim claim{&problem, "", names, "", {}, {}, "", largest_ring};
  std::vector<PlainDesign> designs;
  for (const std::int64_t count : problem.planet_count) {
    for (const Rational& module_mm : problem.module_mm) {
      const Choice choice{&problem, count, number(module_mm)};
      const PlainBox box = root_box(claim, choice);
      for (long s = box.lower[0]; s <= box.upper[0]; ++s) {
        for (long p = box.lower[1]; p <= box.upper[1]; ++p) {
          for (long d = box.lower[2]; d <= box.upper[2]; ++d) {
            if (!allowed(claim, choice, {s, p, d})) {
              designs.push_back({gears_at({s, p, d}), count, choice.module_mm});
            }
          }
        }
      }
    }
  }
  return designs;
}

PlainDesign plain_design(const Json& json) {
  const Json& teeth = json["teeth"];
  const long first = teeth.contains("planet") ? teeth["planet"] : teeth["planet_1"];
  const long second = teeth.contains("planet") ? first : teeth["planet_2"].get<long>();
  return {{teeth["sun"], first, second}, json["planet_count"], json["module_mm"]};
}

PlainClaim plain_optimum(const Problem& problem, const Json& result) {
  PlainClaim claim{&problem, "optimum", constraint_names(problem), objective_name(problem), {}, {},
                   "",       0};
  for (const Json& design : result["designs"]) claim.listed.push_back(plain_design(design));
  for (const Json& design : result["ties"]) claim.listed.push_back(plain_design(design));
  if (!result["designs"].empty()) claim.reference = plain_design(result["designs"].back());
  return claim;
}

PlainClaim plain_relaxation(const Problem& problem, const Json& entry) {
  const std::string key = entry["key"];
  return {&problem,
          "least_relaxation",
          without(constraint_names(problem), set_by(problem, key)),
          relaxed_quantity(problem, key),
          plain_design(entry["design"]),
          {},
          key,
          0};
}

Json naive_optimum(const Problem& problem, std::size_t shown, const ProofStyle& style) {
  const std::string name = objective_name(problem);
  std::vector<PlainDesign> all = find_all(problem, constraint_names(problem), 0);
  sort_by(name, problem, all);
  Json result{{"kind", "gearbox_result"},  {"version", 1},
              {"status", "optimal"},       {"gap", 0},
              {"designs", Json::array()},  {"ties", Json::array()},
              {"conflict", Json::array()}, {"would_be_feasible_with", Json::array()}};
  for (std::size_t i = 0; i < all.size() && i < shown; ++i) {
    result["designs"].push_back(shown_design(all[i], problem));
  }
  PlainClaim claim = plain_optimum(problem, result);
  for (std::size_t i = shown; i < all.size(); ++i) {
    if (against_reference(claim, choice_of(all[i], problem), all[i].gears) == 0) {
      result["ties"].push_back(design_json(all[i], problem));
    }
  }
  claim = plain_optimum(problem, result);
  result["objective"] = result["bound"] = result["designs"][0]["objective"];
  if (all.size() < shown) claim.reference.reset();
  result["certificate"] = {{"version", 1}, {"claims", {naive_claim(claim, style)}}};
  return result;
}

Json naive_limit(const Problem& problem, double share, const ProofStyle& style) {
  Json result = naive_optimum(problem, 1, style);
  const double objective = result["objective"];
  const double bound = objective * share;
  result["status"] = "limit";
  result["bound"] = bound;
  result["gap"] = std::abs(objective - bound) / std::max(std::abs(objective), std::abs(bound));
  for (Json& alternative : result["certificate"]["claims"][0]["alternatives"]) {
    for (Json& node : alternative["nodes"]) {
      if (node.value("closed", "") != "enumerated") continue;
      node["closed"] = "open";
      return result;
    }
  }
  return result;
}

Json naive_infeasible(const Problem& problem, const std::vector<std::string>& keys,
                      const ProofStyle& style) {
  Json result{{"kind", "gearbox_result"},
              {"version", 1},
              {"status", "infeasible"},
              {"objective", nullptr},
              {"bound", nullptr},
              {"gap", nullptr},
              {"designs", Json::array()},
              {"conflict", Json::array()},
              {"would_be_feasible_with", Json::array()}};
  const std::vector<std::string> conflict = smallest_conflict(problem);
  const bool bored = is_among("rotor_bore", conflict);
  Json claims = Json::array({naive_claim(
      {&problem, "infeasible", conflict, "", {}, {}, "", bored ? 0 : kRingLimit}, style)});
  for (const std::string& name : conflict) {
    const auto fewer = without(conflict, {name});
    const auto found = find_all(problem, fewer, is_among("rotor_bore", fewer) ? 0 : kRingLimit);
    result["conflict"].push_back({{"constraint", name},
                                  {"without_it", design_json(found.front(), problem)},
                                  {"sentence", "..."}});
  }
  for (const std::string& key : keys) {
    const auto names = without(constraint_names(problem), set_by(problem, key));
    auto found = find_all(problem, names, is_among("rotor_bore", names) ? 0 : kRingLimit);
    sort_by(relaxed_quantity(problem, key), problem, found);
    const PlainDesign& design = found.at(0);
    const double value =
        quantity(relaxed_quantity(problem, key), choice_of(design, problem), design.gears);
    Json entry{{"key", key},
               {"limit", limit_of(problem, key)},
               {"needed", whole_or_real(key, safe(relaxed_quantity(problem, key), value))},
               {"unit", "..."},
               {"design", design_json(design, problem)},
               {"sentence", "..."}};
    if (key.rfind("/min_teeth/", 0) == 0) entry["needed"] = static_cast<long>(value);
    result["would_be_feasible_with"].push_back(entry);
    claims.push_back(naive_claim(plain_relaxation(problem, entry), style));
  }
  result["certificate"] = {{"version", 1}, {"claims", claims}};
  return result;
}

}  // namespace torquewright::gearbox::proof_test
