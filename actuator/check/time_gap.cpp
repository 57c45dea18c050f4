// SPDX-License-Identifier: Apache-2.0
#include "actuator/check/time_gap.hpp"

#include <fmt/format.h>

#include "io/text/time_text.hpp"

namespace torquewright::actuator {

std::optional<Finding> gap_finding(const LongestStep& step) {
  if (step.usual_s == 0.0 || step.duration_s <= kGap * step.usual_s) return std::nullopt;
  Finding result;
  result.severity = Severity::kWarning;
  result.rule = "time-gap";
  result.time_s = step.from_s;
  result.value = step.duration_s;
  result.limit = kGap * step.usual_s;
  result.unit = "s";
  result.sentence = fmt::format(
      "no samples for {:.6g} s from t = {} s on, while the other steps are {:.3g} s on "
      "average; "
      "what is integrated, energy, rms and heat, runs straight across",
      step.duration_s, io::time_text(step.from_s), step.usual_s);
  return result;
}

bool hides_motion(const LongestStep& step) {
  return step.usual_s > 0.0 && step.duration_s > kGap * step.usual_s &&
         step.duration_s > kMostUnseen_s;
}

std::string hidden_motion_sentence(const LongestStep& step, double clock_origin_s,
                                   std::string_view rates) {
  const double until_s = clock_origin_s + step.from_s;
  return fmt::format(
      "no samples for {0:.6g} s from t = {1:.6g} s on, while the other steps are {2:.3g} s on "
      "average: {3} are differentiated across them; state {3} in the file, or check the parts "
      "apart, with --until {4:.15g} and with --from {5:.15g}",
      step.duration_s, step.from_s, step.usual_s, rates, until_s, until_s + step.duration_s);
}

}  // namespace torquewright::actuator
