// SPDX-License-Identifier: Apache-2.0
#include "hopper/trials/success_rate.hpp"

#include <cmath>
#include <stdexcept>

namespace torquewright::hopper {
namespace {

constexpr double kNormalQuantile = 1.959963984540054;  // of 97.5 %
constexpr double kShareRounding =
    1e-9;  // of a required share that was written as a decimal fraction

}  // namespace

ShareInterval wilson_interval(std::size_t succeeded, std::size_t tried) {
  if (succeeded > tried) throw std::invalid_argument("wilson_interval: more successes than trials");
  if (tried == 0) return {};
  const auto n = static_cast<double>(tried);
  const double share = static_cast<double>(succeeded) / n;
  constexpr double kSquare = kNormalQuantile * kNormalQuantile;
  // docs/randomisation.md, eq. (1)
  const double center = share + kSquare / (2.0 * n);
  const double half =
      kNormalQuantile * std::sqrt(share * (1.0 - share) / n + kSquare / (4.0 * n * n));
  const double scale = 1.0 + kSquare / n;
  return {succeeded == 0 ? 0.0 : (center - half) / scale,
          succeeded == tried ? 1.0 : (center + half) / scale};
}

ShareInterval success_interval(const TrialCounts& counts) {
  return wilson_interval(counts.succeeded, counts.done());
}

RateVerdict judged_rate(const TrialCounts& counts, double required_share) {
  if (!(required_share >= 0.0 && required_share <= 1.0)) {
    throw std::invalid_argument("judged_rate: no share of 1");
  }
  if (counts.all() == 0) return RateVerdict::kOpen;
  const auto all = static_cast<double>(counts.all());
  const double required = (required_share - kShareRounding) * all;
  if (static_cast<double>(counts.succeeded) >= required) return RateVerdict::kReached;
  const auto at_best = static_cast<double>(counts.succeeded + counts.unfinished);
  return at_best >= required ? RateVerdict::kOpen : RateVerdict::kMissed;
}

}  // namespace torquewright::hopper
