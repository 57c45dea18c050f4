// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace torquewright::hopper {

/// A share of 1, from least to greatest.
struct ShareInterval {
  double least = 0.0;
  double greatest = 1.0;
};

/// Returns the interval in which the chance of success lies with 95 %, by Wilson's score
/// (docs/randomisation.md, eq. (1)); 0 to 1 where nothing was tried. Requires succeeded <= tried.
ShareInterval wilson_interval(std::size_t succeeded, std::size_t tried);

/// Counts of how trials ended. One that was not finished (stopped, a limit reached, never begun) is
/// neither success nor failure.
struct TrialCounts {
  std::size_t succeeded = 0;
  std::size_t failed = 0;
  std::size_t unfinished = 0;

  std::size_t done() const { return succeeded + failed; }
  std::size_t all() const { return done() + unfinished; }
};

/// The interval of the share of trials that succeed, by those that are done.
ShareInterval success_interval(const TrialCounts& counts);

enum class RateVerdict {
  kReached,
  kMissed,
  kOpen,  ///< The unfinished ones could turn it.
};

/// Whether the share of successes among all trials is at least as required, however those that are
/// unfinished would have ended. No trial at all is open. Requires a share of 0 to 1.
RateVerdict judged_rate(const TrialCounts& counts, double required_share);

}  // namespace torquewright::hopper
