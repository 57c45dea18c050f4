// SPDX-License-Identifier: Apache-2.0
#include "gearbox/verification/verification_json.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "gearbox/proof/result/certificate.hpp"
#include "gearbox/verification/claim_sentence_json.hpp"
#include "gearbox/verification/difference_json.hpp"
#include "gearbox/verification/input_check_json.hpp"
#include "gearbox/verification/restatement_json.hpp"
#include "gearbox/verification/search_record_json.hpp"
#include "gearbox/verification/sized_verification_json.hpp"
#include "io/documents/provenance.hpp"

namespace torquewright::gearbox {
namespace {

using Json = nlohmann::json;

/// The parts that are checked elsewhere are expected to be as they are found.
void check_statements(const Problem& problem, const Json& result, const proof::Counts& counts,
                      proof::Faults& faults) {
  Json expected = restated(problem, result, counts);
  for (const char* key : {"certificate", "problem", "inputs", "options"}) {
    expected[key] = result.value(key, Json());
  }
  expected["search"]["relaxations"] = result["search"]["relaxations"];
  if (result["search"].contains("seconds")) {
    expected["search"]["seconds"] = result["search"]["seconds"];
  }
  expected["tool"]["version"] = result["tool"]["version"];
  if (const auto difference = first_difference(result, expected)) {
    faults.add(difference->pointer, difference->sentence);
  }
}

void compare_versions(const Json& result, Verification& verification) {
  const std::string version = result["tool"]["version"];
  if (version == io::tool_version()) return;
  verification.unchecked.push_back(
      fmt::format("the result is of version {}, this is {}: that it was written by {} is not known",
                  version, io::tool_version(), version));
}

}  // namespace

Verification verify(const Problem& problem, const Json& result,
                    const std::function<bool()>& should_stop) {
  if (problem.synthesis) return verify_synthesis(problem, result, should_stop);
  proof::Verdict verdict = proof::check_certificate(problem, result, should_stop);
  Verification verification;
  verification.is_undecided = verdict.undecided;
  verification.is_proved = verdict.accepted;
  verification.is_ended = verdict.ended;
  verification.counts = verdict.counts;
  verification.faults = std::move(verdict.faults);
  if (!verification.is_proved) return verification;

  proof::Faults faults;
  check_statements(problem, result, verification.counts, faults);
  if (faults.count() == 0) check_search_record(result, verification.counts, faults);
  const InputCheck input = check_input(result, result["problem"], faults);
  verification.faults = faults.take();
  compare_versions(result, verification);
  if (!input.is_compared && !input.sentence.empty()) {
    verification.unchecked.push_back(input.sentence);
  }
  if (!verification.faults.empty()) return verification;

  verification.is_accepted = true;
  verification.claim = claim_sentence(problem, result);
  verification.checked.push_back("numbers and sentences are those of a fresh evaluation");
  verification.checked.push_back("counts are those of the proof");
  if (input.is_compared) verification.checked.push_back(input.sentence);
  return verification;
}

}  // namespace torquewright::gearbox
