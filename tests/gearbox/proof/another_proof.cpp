// SPDX-License-Identifier: Apache-2.0
#include "tests/gearbox/proof/another_proof.hpp"

#include <regex>

#include "tests/gearbox/proof/literal_check.hpp"
#include "tests/gearbox/proof/naive_result.hpp"

namespace torquewright::gearbox::proof_test {
namespace {

/// The claim that a pointer leads into, as the changed result words it.
PlainClaim claim_at(const Problem& problem, const Json& result, std::size_t index) {
  const Json& json = result["certificate"]["claims"][index];
  PlainClaim claim;
  if (result["status"] != "infeasible") {
    claim = plain_optimum(problem, result);
    if (result["status"] == "limit") claim.bound = result["bound"].get<double>();
  } else if (index == 0) {
    claim = {&problem, "infeasible", json["constraints"], "", {}, {}, "", 0};
  } else {
    claim = plain_relaxation(problem, result["would_be_feasible_with"][index - 1]);
  }
  if (!json.contains("reference") || json["reference"].is_null()) claim.reference.reset();
  if (json.contains("ring_limit") && !json["ring_limit"].is_null()) {
    claim.ring_limit = json["ring_limit"];
  }
  return claim;
}

}  // namespace

bool is_another_proof(const Problem& problem, const Json& result, const std::string& pointer) {
  static const std::regex tree(
      "/certificate/claims/([0-9]+)/(alternatives/([0-9]+)/nodes/.*|"
      "reference|ring_limit)");
  std::smatch parts;
  if (!std::regex_match(pointer, parts, tree)) return false;
  const std::size_t index = std::stoul(parts[1]);
  const PlainClaim claim = claim_at(problem, result, index);
  for (const Json& each : result["certificate"]["claims"][index]["alternatives"]) {
    const Choice choice{&problem, each["planet_count"], each["module_mm"]};
    if (!is_literally_proved(claim, choice, each["nodes"])) return false;
  }
  return true;
}

}  // namespace torquewright::gearbox::proof_test
