// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <nlohmann/json.hpp>

#include "gearbox/proof/result/result_parts.hpp"

namespace torquewright::gearbox::proof {
namespace {

/// Shares of one: a millionth of a millionth more or less is rounding.
bool is_close(const Rational& a, const Rational& b) {
  return abs(Rational(a - b)) <= Rational(1, 1'000'000'000'000);
}

void check_null(const Json& result, const char* key, const char* reason, Faults& faults) {
  if (present(result, key) != nullptr) faults.add(std::string("/") + key, reason);
}

/// |objective - bound| over the greater of the two; 0 where they are equal.
Rational gap_between(const Rational& objective, const Rational& bound) {
  if (objective == bound) return 0;
  return abs(Rational(objective - bound)) / std::max(abs(objective), abs(bound));
}

void check_limit(const Problem& problem, const Json& result, const ListedDesigns& listed,
                 const std::optional<Rational>& bound, Faults& faults) {
  if (listed.designs.empty()) {
    check_null(result, "objective", "has to be null: no design is shown", faults);
  }
  if (listed.designs.empty() || !bound) {
    check_null(result, "gap", "has to be null: objective or bound is", faults);
    return;
  }
  const Quantity quantity = objective_quantity(problem.objective);
  const Value best = objective_of(problem, listed.designs.front());
  const Value written{Interval(*bound), std::nullopt};
  if (compare(quantity, {best.enclosure, std::nullopt}, written) > 0) {
    faults.add("/bound", "is beaten by the first design");
  }
  const auto objective = decimal(member(result, "objective"));
  const auto gap = decimal(member(result, "gap"));
  if (objective && (!gap || !is_close(*gap, gap_between(*objective, *bound)))) {
    faults.add("/gap", "is not |objective - bound| over the greater of the two");
  }
}

}  // namespace

void check_bounds(const Problem& problem, const Json& result, const ListedDesigns& listed,
                  bool is_optimal, Faults& faults) {
  const auto objective = decimal(member(result, "objective"));
  const auto bound = decimal(member(result, "bound"));
  if (!listed.designs.empty()) {
    const Json& first = result["designs"].front();
    if (!objective || objective != decimal(member(first, "objective"))) {
      faults.add("/objective", "is not the objective of the first design");
    }
  }
  const bool says_nothing = !is_optimal && present(result, "bound") == nullptr;
  if (!bound && !says_nothing) {
    faults.add("/bound", "is no number");
  } else if (!is_optimal) {
    check_limit(problem, result, listed, bound, faults);
  } else {
    if (bound != objective) faults.add("/bound", "is not the objective of an optimal result");
    if (decimal(member(result, "gap")) != Rational(0)) {
      faults.add("/gap", "is not 0 in an optimal result");
    }
  }
}

}  // namespace torquewright::gearbox::proof
