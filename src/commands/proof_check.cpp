// SPDX-License-Identifier: Apache-2.0
#include "src/commands/proof_check.hpp"

#include <fmt/format.h>

#include "gearbox/proof/certificate.hpp"

namespace torquewright::cli {

ProofCheck check_proof(const gearbox::Problem& problem, const nlohmann::json& result) {
  const gearbox::proof::Verdict verdict = gearbox::proof::check_certificate(problem, result);
  ProofCheck check{verdict.accepted, verdict.undecided, ""};
  for (const std::string& fault : verdict.faults) check.text += "  " + fault + "\n";
  if (check.is_accepted) {
    check.text = "Proof checked with exact arithmetic, without the search: accepted.\n";
  } else {
    check.text = "Proof rejected:\n" + check.text;
  }
  return check;
}

}  // namespace torquewright::cli
