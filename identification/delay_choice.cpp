// SPDX-License-Identifier: Apache-2.0
#include "identification/delay_choice.hpp"

#include <fmt/format.h>

namespace torquewright::identification {
namespace {

constexpr const char* kName = "channel_delay";
constexpr double kClearlyLess = 0.95;  ///< Times the error.

/// Share of what noise does not explain that must be gone with it and all that is named beside it,
/// as of all names (acceptance_tests/insufficient_share.cpp): what is not a delay may look a little
/// like one.
constexpr double kLeastExplained = 0.6;

double square(double value) { return value * value; }

bool explains(const EquationResult& aligned, const EquationResult& plain) {
  const double before = square(plain.before.train_rms), floor = square(aligned.noise_floor_rms);
  return before - square(aligned.after.train_rms) > kLeastExplained * (before - floor);
}

bool is_clearly_better(const EquationResult& aligned, const EquationResult& plain) {
  return aligned.unusable.empty() &&
         (aligned.after.train_rms < kClearlyLess * plain.after.train_rms ||
          aligned.after.holdout_rms < kClearlyLess * plain.after.holdout_rms);
}

NamedEffect named(const Delay& delay, const EquationResult& plain, const EquationResult& aligned) {
  NamedEffect late;
  late.effect = kName;
  late.family = EffectFamily::kLog;
  late.parameters = {{"channel", std::string(name_of(delay.channel))}, {"delay_s", delay.delay_s}};
  late.standard_error = {{"delay_s", delay.error_s}};
  late.gain = delay.gain;
  late.holdout_rms_before = plain.before.holdout_rms;
  late.holdout_rms_after = aligned.before.holdout_rms;
  late.evidence = fmt::format(
      "Moving it by {:.1f} ms lowers the squared error by {:.0f} % with friction, inertia, torque "
      "constant and gravity refitted ({:.1f} standard errors).",
      1000.0 * delay.delay_s, 100.0 * delay.gain.share, delay.gain.t);
  return late;
}

}  // namespace

EquationResult with_delay_if_better(EquationResult plain, EquationResult aligned,
                                    const Delay& delay) {
  if (!is_clearly_better(aligned, plain) || !explains(aligned, plain)) return plain;
  NamedEffect late = named(delay, plain, aligned);
  aligned.before = plain.before;
  aligned.structure_before = plain.structure_before;
  std::erase_if(aligned.added, [](const NamedEffect& each) { return each.effect == kName; });
  std::erase_if(aligned.rejected, [](const Rejection& each) { return each.effect == kName; });
  aligned.added.insert(aligned.added.begin(), std::move(late));
  if (aligned.verdict == Verdict::kNothingMissing) aligned.verdict = Verdict::kExplained;
  if (aligned.verdict == Verdict::kUnexplained) aligned.verdict = Verdict::kPartlyExplained;
  return aligned;
}

}  // namespace torquewright::identification
