// SPDX-License-Identifier: Apache-2.0
#include "identification/reading/saturation.hpp"

#include <algorithm>

namespace torquewright::identification {
namespace {

/// A plateau counts from this many equal samples on.
constexpr std::size_t kShortestPlateau = 5;
/// So many samples on plateaus make a finding.
constexpr std::size_t kFewestSamples = 15;
/// A plateau must last this many times as long as the values beside it do. The top of a sampled and
/// rounded sine lasts 4.8 times as long as the step below it (2/(sqrt(2) - 1)); less: such tops
/// count as saturated.
constexpr double kTimesNeighbours = 8.0;
/// A channel that spends more than this share of its samples at its ends has two states.
constexpr double kMostShare = 0.5;

struct Plateau {
  std::size_t begin;
  std::size_t end;
  std::size_t length() const { return end - begin; }
};

std::vector<Plateau> plateaus_at(const std::vector<double>& values, double level) {
  std::vector<Plateau> plateaus;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] != level) continue;
    const std::size_t begin = i;
    while (i < values.size() && values[i] == level) ++i;
    if (i - begin >= kShortestPlateau) plateaus.push_back({begin, i});
  }
  return plateaus;
}

/// Samples per change of value in as many samples before the plateau, and after it, as it has.
double dwell_beside(const std::vector<double>& values, const Plateau& plateau) {
  const std::size_t begin = plateau.begin > plateau.length() ? plateau.begin - plateau.length() : 0;
  const std::size_t end = std::min(values.size(), plateau.end + plateau.length());
  std::size_t changes = 0;
  for (std::size_t i = begin + 1; i <= plateau.begin; ++i) changes += values[i] != values[i - 1];
  for (std::size_t i = plateau.end; i < end; ++i) changes += values[i] != values[i - 1];
  const std::size_t samples = plateau.begin - begin + (end - plateau.end);
  return static_cast<double>(samples) / static_cast<double>(std::max<std::size_t>(changes, 1));
}

bool is_saturated_at(const std::vector<double>& values, double level) {
  if (level == 0.0) return false;  // at rest, off
  double samples = 0.0;
  double beside = 0.0;
  for (const Plateau& plateau : plateaus_at(values, level)) {
    const auto length = static_cast<double>(plateau.length());
    samples += length;
    beside += dwell_beside(values, plateau);
  }
  return samples >= static_cast<double>(kFewestSamples) && samples >= kTimesNeighbours * beside;
}

}  // namespace

std::vector<double> find_saturated_values(const std::vector<double>& values) {
  std::vector<double> levels;
  if (values.empty()) return levels;
  const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
  if (*least == *greatest) return levels;
  for (const double level : {*least, *greatest}) {
    if (is_saturated_at(values, level)) levels.push_back(level);
  }
  std::size_t count = 0;
  for (const double level : levels) {
    count += static_cast<std::size_t>(std::count(values.begin(), values.end(), level));
  }
  if (static_cast<double>(count) > kMostShare * static_cast<double>(values.size())) return {};
  return levels;
}

}  // namespace torquewright::identification
