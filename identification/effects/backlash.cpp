// SPDX-License-Identifier: Apache-2.0
// Backlash where one encoder has to do.
#include "identification/backlash_residual.hpp"
#include "identification/effects/families.hpp"

namespace torquewright::identification {
namespace {

constexpr double kNarrowest = 3e-4;  ///< Of the output's range.
constexpr double kWidest = 0.06;
constexpr int kGaps = 12;

}  // namespace

void add_backlash(DictionaryBuilder& builder) {
  if (!shows_backlash(builder.bench()) || builder.stated("backlash") > 0.0) return;
  const double range_rad = builder.extent().output_angle_rad;
  if (!(range_rad > 0.0)) return;
  for (const double gap_rad : geometric(kNarrowest * range_rad, kWidest * range_rad, kGaps)) {
    const std::size_t column = builder.add_stretch(
        "gap",
        [balance = builder.balance(), gap_rad](const Signals& signals, std::vector<double>& out) {
          out = backlash_residual_Nm(*balance, gap_rad, signals);
        });
    builder.variant("backlash", {one(column, 0.0, 1.5)}).shape = {{gap_rad}};
  }
}

}  // namespace torquewright::identification
