// SPDX-License-Identifier: Apache-2.0
#include "identification/answer/self_check.hpp"

#include <fmt/format.h>

#include "identification/findings/doubts.hpp"

namespace torquewright::identification {
namespace {

std::string broken_in(const EquationResult& promised, const EquationResult& kept) {
  const bool is_broken =
      breaks_promise(promised.with_certain, kept.before, promised.noise_floor_rms);
  if (!is_broken) return "";
  return fmt::format(
      "{}{}: with the refined document the error is {:.4g} {} on fitted and {:.4g} {} on held-out "
      "runs; {:.4g} and {:.4g} were promised: it is not written",
      promised.joint.empty() ? "" : promised.joint + ": ", promised.quantity, kept.before.train_rms,
      promised.unit, kept.before.holdout_rms, promised.unit, promised.with_certain.train_rms,
      promised.with_certain.holdout_rms);
}

/// What named nothing may not get worse by what others named; but of what is simulated in windows
/// small errors add up, and values of the rig that were fitted there are as stated again.
bool is_checked(const EquationResult& promised) {
  return !promised.added.empty() || (!promised.runs.empty() && promised.corrected.empty());
}

}  // namespace

std::string broken_promise(const std::vector<std::filesystem::path>& logs, const Rig& rig,
                           const std::vector<JointActuator>& refined, const Identification& found) {
  IdentifyOptions options;
  options.select = false;
  for (const EquationResult& each : found.equations) {
    if (each.band_Hz > 0.0) options.analysis.band_Hz[{each.joint, each.quantity}] = each.band_Hz;
  }
  Rig as_written = rig;  // Nothing of the document is open any more.
  as_written.uncertain.clear();
  const Identification again = identify(logs, as_written, refined, options);
  for (const EquationResult& promised : found.equations) {
    const bool has_promise = promised.with_certain.train_rms > 0.0 && is_checked(promised);
    for (const EquationResult& kept : again.equations) {
      if (!has_promise || kept.joint != promised.joint || kept.quantity != promised.quantity)
        continue;
      const std::string broken = broken_in(promised, kept);
      if (!broken.empty()) return broken;
    }
  }
  return "";
}

}  // namespace torquewright::identification
