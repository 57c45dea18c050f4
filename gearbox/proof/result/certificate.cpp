// SPDX-License-Identifier: Apache-2.0
#include "gearbox/proof/result/certificate.hpp"

#include <fmt/format.h>

#include <exception>
#include <nlohmann/json.hpp>

#include "gearbox/proof/result/result_parts.hpp"

namespace torquewright::gearbox::proof {
namespace {

void check_is_empty(const Json& result, const char* key, const char* reason, Faults& faults) {
  const Json* json = present(result, key);
  if (json != nullptr && !(json->is_array() && json->empty())) {
    faults.add(fmt::format("/{}", key), reason);
  }
}

/// One claim for each that is demanded, in the same order, and no other.
void check_claims(const Problem& problem, const std::vector<DemandedClaim>& demanded,
                  const Json& result, Account& account) {
  const Json* certificate = member(result, "certificate");
  if (certificate == nullptr || !certificate->is_object()) {
    account.faults.add("/certificate", "is missing");
    return;
  }
  check_keys(*certificate, {"version", "claims"}, "/certificate", account.faults);
  if (whole_number(member(*certificate, "version")) != 1) {
    account.faults.add("/certificate/version", "is not 1");
  }
  const Json& claims = elements(member(*certificate, "claims"));
  if (claims.size() != demanded.size()) {
    account.faults.add("/certificate/claims", fmt::format("is no list of {} claims, which this "
                                                          "result calls for",
                                                          demanded.size()));
    return;
  }
  for (std::size_t i = 0; i < claims.size(); ++i) {
    check_claim(problem, demanded[i], claims[i], fmt::format("/certificate/claims/{}", i), account);
  }
}

void check_optimum(const Problem& problem, const Json& result, bool is_optimal, Account& account) {
  Faults& faults = account.faults;
  const ListedDesigns listed = check_designs(problem, result, account);
  if (faults.count() != 0) return;
  if (is_optimal && listed.designs.empty()) {
    faults.add("/designs", "is empty, though the result is optimal");
    return;
  }
  check_bounds(problem, result, listed, is_optimal, faults);
  const char* reason = "has to be empty: nothing is shown to be infeasible";
  check_is_empty(result, "conflict", reason, faults);
  check_is_empty(result, "would_be_feasible_with", reason, faults);

  DemandedClaim claim;
  claim.kind = ClaimKind::kOptimum;
  claim.hypotheses = constraints_of(problem);
  claim.quantity_name = objective_name(problem.objective);
  claim.quantity = objective_quantity(problem.objective);
  if (!listed.designs.empty()) claim.reference = listed.designs.back();
  // Ties are designs for which there was no room: then the last design is the K-th.
  claim.reference_is_open = listed.ties.empty();
  claim.listed = listed.all();
  claim.may_be_open = !is_optimal;
  if (!is_optimal) claim.open_bound = decimal(member(result, "bound"));
  check_claims(problem, {claim}, result, account);
  if (!is_optimal && faults.count() == 0 && account.counts.open_leaves == 0) {
    faults.add("/status", "is limit, but no leaf is open");
  }
}

void check_infeasible(const Problem& problem, const Json& result, Account& account) {
  Faults& faults = account.faults;
  for (const char* key : {"designs", "ties"}) {
    check_is_empty(result, key, "has to be empty: the problem is infeasible", faults);
  }
  for (const char* key : {"objective", "bound", "gap"}) {
    if (present(result, key) != nullptr) {
      faults.add(fmt::format("/{}", key), "has to be null: the problem is infeasible");
    }
  }
  DemandedClaim conflict;
  conflict.kind = ClaimKind::kInfeasible;
  conflict.hypotheses = check_conflict(problem, result, faults);
  std::vector<DemandedClaim> claims = check_relaxations(problem, result, faults);
  if (faults.count() != 0) return;
  claims.insert(claims.begin(), conflict);
  check_claims(problem, claims, result, account);
}

/// Problems from documents satisfy this; the arithmetic below relies on it.
bool is_within_range(const Problem& problem) {
  bool sound = problem.target_ratio != 0 && problem.rotor_inner_diameter_mm > 0 &&
               !problem.module_mm.empty() && !problem.planet_count.empty();
  for (const Rational& module_mm : problem.module_mm) sound = sound && module_mm > 0;
  for (const std::int64_t count : problem.planet_count) {
    sound = sound && count >= 1 && count <= kMostTeeth;
  }
  return sound;
}

void check_result(const Problem& problem, const Json& result, Account& account, Verdict& verdict) {
  if (!is_within_range(problem)) {
    account.faults.add("/problem", "is no problem with a ratio, modules and planets");
    return;
  }
  const auto status = text(member(result, "status"));
  verdict.undecided = status == "limit";
  if (status == "optimal" || status == "limit") {
    check_optimum(problem, result, status == "optimal", account);
  } else if (status == "infeasible") {
    check_infeasible(problem, result, account);
  } else {
    account.faults.add("/status", "is not one of optimal, infeasible, limit");
  }
}

}  // namespace

Verdict check_certificate(const Problem& problem, const nlohmann::json& result,
                          const std::function<bool()>& should_stop) {
  Account account;
  account.should_stop = should_stop;
  Verdict verdict;
  try {
    check_result(problem, result, account, verdict);
  } catch (const Stopped&) {
    verdict.ended = true;
    verdict.counts = account.counts;
    return verdict;
  } catch (const std::exception& error) {
    // Nothing above should throw; if it does, the result is not proved.
    account.faults.add("", fmt::format("could not be checked: {}", error.what()));
  }
  verdict.accepted = account.faults.count() == 0;
  verdict.faults = account.faults.take();
  verdict.counts = account.counts;
  return verdict;
}

}  // namespace torquewright::gearbox::proof
