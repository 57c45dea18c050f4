// SPDX-License-Identifier: Apache-2.0
#include "identification/answer/self_check.hpp"

#include <fmt/format.h>

#include "identification/findings/doubts.hpp"
#include "identification/findings/written.hpp"
#include "identification/preparation/uncertain.hpp"

namespace torquewright::identification {
namespace {

/// What is to be left; where a name was doubted since, no more than as stated.
Errors promised_by(const EquationResult& promised) {
  std::vector<std::string> effects;
  for (const NamedEffect* each : written_of(promised)) effects.push_back(each->effect);
  return effects == promised.promise.effects ? promised.promise.errors : promised.before;
}

std::string broken_in(const EquationResult& promised, const EquationResult& kept) {
  const Errors errors = promised_by(promised);
  if (!breaks_promise(errors, kept.before, promised.noise_floor_rms)) return "";
  return fmt::format(
      "{}{}: with the refined document the error is {:.4g} {} on fitted and {:.4g} {} on held-out "
      "runs; {:.4g} and {:.4g} were promised: it is not written",
      promised.joint.empty() ? "" : promised.joint + ": ", promised.quantity, kept.before.train_rms,
      promised.unit, kept.before.holdout_rms, promised.unit, errors.train_rms, errors.holdout_rms);
}

/// What named nothing may not get worse by what others named; but of what is simulated in windows
/// small errors add up, and values of the rig that were fitted there are as stated again.
bool is_checked(const EquationResult& promised) {
  return !promised.added.empty() || (!promised.runs.empty() && promised.corrected.empty());
}

}  // namespace

Identification as_written(const std::vector<std::filesystem::path>& logs, Rig rig,
                          const std::vector<JointActuator>& refined, const Identification& found) {
  IdentifyOptions options;
  options.select = false;
  for (const EquationResult& each : found.equations) {
    if (each.band_Hz > 0.0) options.analysis.band_Hz[{each.joint, each.quantity}] = each.band_Hz;
  }
  std::erase_if(rig.uncertain, [](const std::string& pointer) { return !is_of_load(pointer); });
  return identify(logs, rig, refined, options);
}

std::string broken_promise(const Identification& found, const Identification& judged) {
  for (const EquationResult& promised : found.equations) {
    const bool has_promise = promised.promise.errors.train_rms > 0.0 && is_checked(promised);
    for (const EquationResult& kept : judged.equations) {
      if (!has_promise || kept.joint != promised.joint || kept.quantity != promised.quantity)
        continue;
      const std::string broken = broken_in(promised, kept);
      if (!broken.empty()) return broken;
    }
  }
  return "";
}

}  // namespace torquewright::identification
