// SPDX-License-Identifier: Apache-2.0
#include "src/report/actuator/shortlist.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace torquewright::report {
namespace {

std::string margin_text(const std::optional<double>& share) {
  if (!share) return "unknown";
  if (!std::isfinite(*share)) return "any";
  return fmt::format("{:+.0f} %", 100.0 * *share);
}

std::string mass_text(const std::optional<double>& mass_kg) {
  return mass_kg ? fmt::format("{:.3g}", *mass_kg) : "-";
}

/// As wide as the widest of them.
std::size_t width_of_names(const std::vector<RankedDrive>& drives) {
  std::size_t width = 5;
  for (const RankedDrive& one : drives) width = std::max(width, one.drive->stem.size());
  return width;
}

}  // namespace

std::string shortlist_text(const std::vector<RankedDrive>& drives,
                           const std::vector<std::string>& left_out) {
  const auto fit = std::count_if(drives.begin(), drives.end(),
                                 [](const RankedDrive& one) { return one.suitability.fits; });
  const auto unknown = std::count_if(drives.begin(), drives.end(), [](const RankedDrive& one) {
    return one.suitability.is_unknown;
  });
  std::string text = fmt::format("{} of {} drives fit", fit, drives.size());
  if (unknown > 0) text += fmt::format(", {} would if what they do not state does", unknown);
  text += "\n";
  const std::size_t width = width_of_names(drives);
  text += fmt::format("  {:<{}}  {:>8}  {:>6}  {:>7}  {}\n", "drive", width, "margin", "kg",
                      "ratio", "why not");
  for (const RankedDrive& one : drives) {
    text += fmt::format("  {:<{}}  {:>8}  {:>6}  {:>7.4g}  {}", one.drive->stem, width,
                        margin_text(one.suitability.margin_share),
                        mass_text(one.drive->actuator.mass_kg), one.suitability.ratio,
                        fmt::join(one.suitability.reasons, "; "));
    text.erase(text.find_last_not_of(' ') + 1);
    text += "\n";
  }
  for (const std::string& sentence : left_out) text += fmt::format("left out: {}\n", sentence);
  return text;
}

}  // namespace torquewright::report
