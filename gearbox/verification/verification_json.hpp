// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "gearbox/problem.hpp"
#include "gearbox/proof/reading/verdict.hpp"

namespace torquewright::gearbox {

/// Outcome of `gearbox verify` for a result.
struct Verification {
  bool is_accepted = false;   ///< Proved, and all that is said beside the proof is so.
  bool is_undecided = false;  ///< Status "limit": a bound is proved, the optimum is not.
  bool is_proved = false;     ///< The certificate alone.
  bool is_ended = false;      ///< Told to stop: nothing of the above is known.
  std::string claim;          ///< What is proved, in words; empty unless accepted.
  proof::Counts counts;
  /// Of a synthesis: choices of teeth, planets and modules of which the claims were proved anew;
  /// its boxes are `counts.nodes`.
  std::optional<std::int64_t> choices = {};
  std::vector<std::string> checked;    ///< Sentences, beside the proof.
  std::vector<std::string> unchecked;  ///< What could not be compared, and why.
  std::vector<std::string> faults;     ///< `JSON pointer: sentence`
};

/// Checks the certificate, without the search; then compares everything else in the result with a
/// fresh evaluation of the proved designs, the counts with the proof, and the problem with the file
/// it was read from, if that is there. Requires a document of the shape of a `gearbox_result`, and
/// its problem. Of a synthesis see sized_verification_json.hpp. For `should_stop` see
/// proof::check_certificate.
[[nodiscard]] Verification verify(
    const Problem& problem, const nlohmann::json& result,
    const std::function<bool()>& should_stop = [] { return false; });

}  // namespace torquewright::gearbox
