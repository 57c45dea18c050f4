// SPDX-License-Identifier: Apache-2.0
#include "bench/verdict.hpp"

namespace torquewright::bench {
namespace {

bool is_of(const oracles::Found& found, const std::vector<std::int64_t>& teeth) {
  const oracles::Teeth& z = found.teeth;
  return teeth.size() >= 3 && z.sun == teeth[0] && z.planet_1 == teeth[1] && z.planet_2 == teeth[2];
}

bool is_among(const std::vector<oracles::Found>& designs, const std::vector<std::int64_t>& teeth) {
  for (const oracles::Found& found : designs) {
    if (is_of(found, teeth)) return true;
  }
  return false;
}

}  // namespace

Answer read_answer(const nlohmann::json& json) {
  return {json.value("status", "none"), json.value("teeth", std::vector<std::int64_t>{})};
}

std::string verdict(const Answer& answer, const oracles::Enumeration& truth) {
  if (!truth.near_ties.empty()) return "not decided by the enumeration";
  if (answer.status == "infeasible") {
    return truth.best.empty() ? "right" : "wrong: not infeasible";
  }
  if (answer.status != "optimal") return "no answer (" + answer.status + ")";
  if (is_among(truth.best, answer.teeth)) return "right";
  return is_among(truth.feasible, answer.teeth) ? "wrong: not the best" : "wrong: not feasible";
}

std::string verdict(const gearbox::Problem& problem, const Answer& answer) {
  return verdict(answer, oracles::enumerate(problem));
}

}  // namespace torquewright::bench
