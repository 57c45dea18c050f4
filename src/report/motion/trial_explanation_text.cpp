// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "src/report/motion/replay_words.hpp"

namespace torquewright::report {
namespace {

using namespace hopper;

double in_degrees(double angle_rad) { return angle_rad * 180.0 / std::numbers::pi; }
constexpr std::size_t kWidestBar = 40;

/// A bar of one sign for each trial, or for several where there are too many.
std::string bar(const RotationBin& bin, std::size_t most) {
  const std::size_t each = (most + kWidestBar - 1) / kWidestBar;
  const auto signs = [each](std::size_t count) { return (count + each - 1) / each; };
  return std::string(signs(bin.succeeded), '#') + std::string(signs(bin.failed), '.');
}

std::string landed_lines(const TrialOutcomes& outcomes) {
  const std::vector<RotationBin> bins = rotation_bins(outcomes);
  if (bins.empty()) return "";
  std::size_t most = 1;
  for (const RotationBin& bin : bins) most = std::max(most, bin.succeeded + bin.failed);
  std::string text =
      "\n  degrees short at touch-down (below 0: over)   # did it and stands   . does not\n";
  for (const RotationBin& bin : bins) {
    text += fmt::format("  {:>6g} to {:<6g} {:>4} of {:<4} {}\n", bin.from_deg, bin.until_deg,
                        bin.succeeded, bin.succeeded + bin.failed, bar(bin, most));
  }
  return text;
}

std::string cause_line(const CauseEffect& effect) {
  std::string text = fmt::format("  {:<32}{:>5} of {:<5}", effect.cause, effect.counts.succeeded,
                                 effect.counts.done());
  if (!effect.rotation) return text + fmt::format("{:>18}{:>15}\n", "-", "-");
  text += fmt::format("{:>8.2f} +- {:<6.2f}", in_degrees(effect.rotation->mean_rad),
                      in_degrees(effect.rotation->deviation_rad));
  if (!effect.variance_share) return text + fmt::format("{:>15}\n", "-");
  return text + fmt::format("{:>13.0f} %\n", 100.0 * *effect.variance_share);
}

std::string cause_lines(std::vector<CauseEffect> causes) {
  if (causes.empty()) return "";
  std::stable_sort(causes.begin(), causes.end(), [](const CauseEffect& a, const CauseEffect& b) {
    return a.counts.succeeded < b.counts.succeeded;
  });
  std::string text =
      "\n  varied alone                       do it and stand  degrees short  of the variance\n";
  for (const CauseEffect& effect : causes) text += cause_line(effect);
  return text;
}

}  // namespace

std::string explanation_lines(const ReplayTrials& trials) {
  if (trials.causes.empty()) return "";
  return landed_lines(trials.outcomes) + cause_lines(trials.causes);
}

}  // namespace torquewright::report
