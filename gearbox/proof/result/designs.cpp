// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>

#include "gearbox/proof/result/result_parts.hpp"

namespace torquewright::gearbox::proof {
namespace {

/// n / gcd(n, Q) with Q = (O P1 - F P2)/gcd(P1, P2); one type in a single stage.
std::int64_t planet_types(const Problem& problem, const Candidate& candidate) {
  if (!train_of(problem).is_stepped()) return 1;
  const Teeth teeth = teeth_at(candidate.point);
  const mpz_class first = static_cast<long>(teeth.planet_1);
  const mpz_class second = static_cast<long>(teeth.planet_2);
  const mpz_class offset =
      (static_cast<long>(ring(teeth, 2)) * first - static_cast<long>(ring(teeth, 1)) * second) /
      gcd(first, second);
  const mpz_class count = static_cast<long>(candidate.planet_count);
  return mpz_class(count / gcd(count, offset)).get_si();
}

void check_ratio(const Alternative& alternative, const Candidate& candidate, const Json* json,
                 const std::string& place, Faults& faults) {
  const Rational ratio = ratio_of(alternative, teeth_at(candidate.point));
  const Json none;
  const Json& written = json != nullptr ? *json : none;
  if (decimal(member(written, "numerator")) != Rational(ratio.get_num())) {
    faults.add(place + "/numerator", "is not " + ratio.get_num().get_str());
  }
  if (decimal(member(written, "denominator")) != Rational(ratio.get_den())) {
    faults.add(place + "/denominator", "is not " + ratio.get_den().get_str());
  }
  if (!is_written_as(member(written, "value"), {Interval(ratio), ratio})) {
    faults.add(place + "/value", "is not " + ratio.get_str());
  }
}

void check_design(const Problem& problem, const Candidate& candidate, const Json& json,
                  const std::string& place, Faults& faults) {
  check_feasibility(problem, constraints_of(problem), candidate, place, faults);
  const Alternative alternative(problem, candidate.planet_count, candidate.module_mm);
  check_ratio(alternative, candidate, member(json, "ratio"), place + "/ratio", faults);
  if (whole_number(member(json, "planet_types")) != planet_types(problem, candidate)) {
    faults.add(place + "/planet_types", fmt::format("is not {}", planet_types(problem, candidate)));
  }
  if (!is_written_as(member(json, "objective"), objective_of(problem, candidate))) {
    faults.add(place + "/objective", "is not the objective of these teeth");
  }
}

int compare_objectives(const Problem& problem, const Candidate& a, const Candidate& b) {
  return compare(objective_quantity(problem.objective), objective_of(problem, a),
                 objective_of(problem, b));
}

void check_order(const Problem& problem, const ListedDesigns& listed, Faults& faults) {
  for (std::size_t i = 1; i < listed.designs.size(); ++i) {
    if (compare_objectives(problem, listed.designs[i], listed.designs[i - 1]) > 0) {
      faults.add(fmt::format("/designs/{}", i), "is better than the design before it");
    }
  }
  for (std::size_t i = 0; i < listed.ties.size(); ++i) {
    if (listed.designs.empty() ||
        compare_objectives(problem, listed.ties[i], listed.designs.back()) != 0) {
      faults.add(fmt::format("/ties/{}", i), "is not exactly as good as the last design");
    }
  }
  std::set<Candidate> known;
  const std::vector<Candidate> all = listed.all();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!known.insert(all[i]).second) {
      faults.add(i < listed.designs.size() ? "/designs" : "/ties", "names a design twice");
    }
  }
}

}  // namespace

bool is_written_as(const Json* json, const Value& value) {
  const auto written = decimal(json);
  if (!written) return false;
  const Interval deviation = abs(Interval(*written) - value.enclosure);
  return sign(abs(value.enclosure) * Interval(Rational(1, 1'000'000'000'000)) - deviation) >= 0;
}

std::vector<Candidate> ListedDesigns::all() const {
  std::vector<Candidate> both = designs;
  both.insert(both.end(), ties.begin(), ties.end());
  return both;
}

Value objective_of(const Problem& problem, const Candidate& candidate) {
  const Alternative alternative(problem, candidate.planet_count, candidate.module_mm);
  return value_at(objective_quantity(problem.objective), alternative, candidate.point);
}

ListedDesigns check_designs(const Problem& problem, const Json& result, Account& account) {
  Faults& faults = account.faults;
  // As many as `gearbox optimize --top` takes.
  constexpr std::size_t kMostDesigns = 1'000'000;
  ListedDesigns listed;
  const Json* designs = member(result, "designs");
  if (designs == nullptr || !designs->is_array() || designs->size() > kMostDesigns) {
    faults.add("/designs", fmt::format("is no list of at most {} designs", kMostDesigns));
    return listed;
  }
  for (std::size_t i = 0; i < designs->size(); ++i) {
    ask_whether_to_stop(account);
    const std::string place = fmt::format("/designs/{}", i);
    const Json& json = (*designs)[i];
    if (const auto candidate = read_candidate(problem, &json, place, faults)) {
      check_design(problem, *candidate, json, place, faults);
      listed.designs.push_back(*candidate);
    }
  }
  const Json* ties = present(result, "ties");
  if (ties != nullptr && (!ties->is_array() || ties->size() > kMostDesigns)) {
    faults.add("/ties", fmt::format("is no list of at most {} designs", kMostDesigns));
    return listed;
  }
  for (std::size_t i = 0; i < elements(ties).size(); ++i) {
    ask_whether_to_stop(account);
    const std::string place = fmt::format("/ties/{}", i);
    if (const auto candidate = read_candidate(problem, &(*ties)[i], place, faults)) {
      check_feasibility(problem, constraints_of(problem), *candidate, place, faults);
      listed.ties.push_back(*candidate);
    }
  }
  check_order(problem, listed, faults);
  return listed;
}

}  // namespace torquewright::gearbox::proof
