// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "identification/findings/result.hpp"
#include "tests/oracles/bench_log/scenario.hpp"

namespace torquewright::rates {

/// How an effect that is there was named, the surest first.
enum class Naming {
  kAlone,       ///< By its name, or as a value that the rig calls uncertain.
  kAsIdentity,  ///< By a name that no excitation of such a rig tells from it.
  kInGroup,     ///< In a group that this log cannot tell apart.
  kNot,
};

/// How one log with a known truth was judged.
struct Outcome {
  bool first_is_right = false;  ///< The first name is the truth's, or one of its exact group.
  bool all_found = false;
  bool any_wrong = false;   ///< A name that stands alone, is confident, and is not there.
  bool is_grouped = false;  ///< A group that log cannot tell apart was reported.
  bool coordinate_is_right = false;
  identification::Verdict verdict = identification::Verdict::kCannotTell;
  std::vector<std::string> names;  ///< Of all equations.
  std::string truth;
  std::vector<Naming> naming;                 ///< Of each effect of the truth.
  std::vector<std::string> wrong_names;       ///< That are not there, or certain where none can be.
  int parameters = 0, parameters_within = 0;  ///< Of right names; within three standard errors.
  std::string parameter_note;
  /// Of the equation that the first name changes, held-out rms after it over the noise: as the tool
  /// estimates it, and as it was put in (closed form of an ideal low-pass of 8 Hz; 0 where there is
  /// none).
  double after_over_estimate = 0.0, after_over_truth = 0.0;
};

/// Writes the scenario's documents and logs into a folder, identifies what they show as the command
/// does, and compares it with the truth.
Outcome try_out(const oracles::Scenario& scenario, const std::filesystem::path& folder);

}  // namespace torquewright::rates
