// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

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

}  // namespace torquewright::gearbox
