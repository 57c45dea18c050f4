// SPDX-License-Identifier: Apache-2.0
#include "identification/answer/self_check.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace torquewright::identification {
namespace {

constexpr double kAsPromised = 1.05;   ///< The rig's own uncertain values are as stated.
constexpr double kOfNoiseFloor = 0.2;  ///< What that may change besides.

std::string broken_in(const EquationResult& promised, const EquationResult& kept) {
  const auto breaks = [&](double promise, double came_out) {
    return came_out > kAsPromised * promise + kOfNoiseFloor * promised.noise_floor_rms;
  };
  const bool is_broken = breaks(promised.with_certain.train_rms, kept.before.train_rms) ||
                         breaks(promised.with_certain.holdout_rms, kept.before.holdout_rms);
  if (!is_broken) return "";
  return fmt::format(
      "{}{}: with the refined document the error is {:.4g} {} on fitted and {:.4g} {} on held-out "
      "runs; {:.4g} and {:.4g} were promised: it is not written",
      promised.joint.empty() ? "" : promised.joint + ": ", promised.quantity, kept.before.train_rms,
      promised.unit, kept.before.holdout_rms, promised.unit, promised.with_certain.train_rms,
      promised.with_certain.holdout_rms);
}

}  // namespace

std::string broken_promise(const std::vector<std::filesystem::path>& logs, const Rig& rig,
                           const std::vector<JointActuator>& refined, const Identification& found) {
  IdentifyOptions options;
  options.select = false;
  for (const EquationResult& each : found.equations) {
    if (each.band_Hz > 0.0) options.analysis.band_Hz[each.quantity] = each.band_Hz;
  }
  Rig as_written = rig;  // Nothing of the document is open any more.
  as_written.uncertain.clear();
  const Identification again = identify(logs, as_written, refined, options);
  for (const EquationResult& promised : found.equations) {
    const bool has_promise = promised.with_certain.train_rms > 0.0 && !promised.added.empty();
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
