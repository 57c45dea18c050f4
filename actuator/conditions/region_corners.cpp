// SPDX-License-Identifier: Apache-2.0
#include "actuator/conditions/region_corners.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace torquewright::actuator {
namespace {

constexpr double kJumpShare = 1e-6;  // of the peak torque: no jump is smaller

LimiterStretch stretch_of(const JointRange& range, bool is_greatest) {
  const JointBound& bound = bound_of(range, is_greatest);
  return {bound.limiter, (bound.torque_Nm > 0.0) - (bound.torque_Nm < 0.0)};
}

/// Rows of one direction from rest outward, up to where the region ends; nothing if it has a gap.
std::optional<std::vector<MorRow>> outward(const MorTable& table, double direction) {
  std::vector<MorRow> rows;
  for (const MorRow& row : table.rows) {
    if (row.speed_rad_s * direction >= 0.0) rows.push_back(row);
  }
  if (direction < 0.0) std::reverse(rows.begin(), rows.end());
  // Of two rows at rest the one of the other direction stands last (below) or first (above).
  while (rows.size() > 1 && rows[1].speed_rad_s == 0.0) rows.erase(rows.begin());
  const auto is_empty = [](const MorRow& row) { return row.range.is_empty; };
  const auto end = std::find_if(rows.begin(), rows.end(), is_empty);
  if (!std::all_of(end, rows.end(), is_empty) || end - rows.begin() < 2) return std::nullopt;
  rows.erase(end, rows.end());
  return rows;
}

/// Of one direction, from rest outward, rest and end included.
Corners half_corners(const std::vector<MorRow>& rows, bool is_greatest, double jump_Nm) {
  Corners corners{{0.0}, {}, 0};
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const LimiterStretch here = stretch_of(rows[i - 1].range, is_greatest);
    if (stretch_of(rows[i].range, is_greatest) == here) continue;
    const double change_Nm = bound_of(rows[i].range, is_greatest).torque_Nm -
                             bound_of(rows[i - 1].range, is_greatest).torque_Nm;
    corners.speeds_rad_s.push_back(rows[i - 1].speed_rad_s);
    corners.stretches.push_back(here);
    if (std::abs(change_Nm) <= jump_Nm) continue;
    corners.speeds_rad_s.push_back(rows[i].speed_rad_s);
    corners.stretches.push_back(kJump);
  }
  corners.speeds_rad_s.push_back(rows.back().speed_rad_s);
  corners.stretches.push_back(stretch_of(rows.back().range, is_greatest));
  return corners;
}

/// The shortest sequence that both are part of.
std::vector<LimiterStretch> merged(LimiterStretches one, LimiterStretches other) {
  const std::size_t rows = one.size() + 1;
  const std::size_t columns = other.size() + 1;
  std::vector<std::size_t> length(rows * columns);  // of what is merged from (i, j) on
  const auto at = [&](std::size_t i, std::size_t j) -> std::size_t& {
    return length[i * columns + j];
  };
  for (std::size_t i = rows; i-- > 0;) {
    for (std::size_t j = columns; j-- > 0;) {
      if (i == one.size() || j == other.size()) {
        at(i, j) = one.size() - i + other.size() - j;
      } else {
        at(i, j) =
            one[i] == other[j] ? 1 + at(i + 1, j + 1) : 1 + std::min(at(i + 1, j), at(i, j + 1));
      }
    }
  }
  std::vector<LimiterStretch> all;
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < one.size() || j < other.size()) {
    const bool is_same = i < one.size() && j < other.size() && one[i] == other[j];
    const bool is_ones =
        j == other.size() || (i < one.size() && !is_same && at(i + 1, j) <= at(i, j + 1));
    all.push_back(is_same || is_ones ? one[i] : other[j]);
    i += is_same || is_ones ? 1 : 0;
    j += is_same || !is_ones ? 1 : 0;
  }
  return all;
}

}  // namespace

const JointBound& bound_of(const JointRange& range, bool is_greatest) {
  return is_greatest ? range.greatest : range.least;
}

std::optional<Corners> corners_of(const MorTable& table, bool is_greatest) {
  const auto below = outward(table, -1.0);
  const auto above = outward(table, 1.0);
  if (!below || !above) return std::nullopt;
  const double jump_Nm = kJumpShare * table.peak_torque_Nm;
  const Corners negative = half_corners(*below, is_greatest, jump_Nm);
  const Corners positive = half_corners(*above, is_greatest, jump_Nm);
  Corners all;
  all.speeds_rad_s.assign(negative.speeds_rad_s.rbegin(), negative.speeds_rad_s.rend());
  all.speeds_rad_s.back() = 0.0;  // not -0
  all.stretches.assign(negative.stretches.rbegin(), negative.stretches.rend());
  all.rest = all.speeds_rad_s.size() - 1;
  all.stretches.push_back(kAtRest);
  all.speeds_rad_s.insert(all.speeds_rad_s.end(), positive.speeds_rad_s.begin(),
                          positive.speeds_rad_s.end());
  all.stretches.insert(all.stretches.end(), positive.stretches.begin(), positive.stretches.end());
  return all;
}

bool is_part_of(LimiterStretches one, LimiterStretches other) {
  std::size_t next = 0;
  for (const LimiterStretch& each : other) {
    if (next < one.size() && one[next] == each) ++next;
  }
  return next == one.size();
}

std::vector<LimiterStretch> merged_about_rest(const std::vector<LimiterStretch>& one,
                                              const std::vector<LimiterStretch>& other) {
  const auto split = [](const std::vector<LimiterStretch>& all) {
    const auto rest = std::find(all.begin(), all.end(), kAtRest);
    return std::pair(LimiterStretches(all.begin(), rest), LimiterStretches(rest + 1, all.end()));
  };
  const auto [one_below, one_above] = split(one);
  const auto [other_below, other_above] = split(other);
  std::vector<LimiterStretch> all = merged(one_below, other_below);
  all.push_back(kAtRest);
  for (const LimiterStretch& each : merged(one_above, other_above)) all.push_back(each);
  return all;
}

std::optional<double> opening(const CornersExample& example, std::size_t first, std::size_t last) {
  const std::vector<double>& w = example.corners_rad_s;
  const double whole = w[last + 1] - w[first];
  const bool is_open = w[last] > w[first + 1] && w[first + 1] > w[first] && w[last + 1] > w[last];
  if (!is_open) return std::nullopt;
  return (0.5 * (w[first + 1] + w[last]) - w[first]) / whole;
}

std::optional<Corners> stretched(
    const Corners& found, const std::vector<LimiterStretch>& reference,
    const std::function<std::optional<double>(std::size_t, std::size_t)>& opening_of) {
  const LimiterStretches wanted(reference);
  const LimiterStretches had(found.stretches);
  Corners all{{found.speeds_rad_s.front()}, reference, 0};
  std::size_t next = 0;
  const auto end_here = [&](std::size_t i) {
    if (reference[i] == kAtRest) all.rest = i;
    all.speeds_rad_s.push_back(found.speeds_rad_s[next]);
  };
  for (std::size_t i = 0; i < reference.size(); ++i) {
    if (next == had.size() || !(had[next] == reference[i])) {
      end_here(i);
      continue;
    }
    // Its last like of which the rest still finds its own.
    std::size_t last = i;
    for (std::size_t j = i + 1; j < reference.size() && !(reference[i] == kAtRest); ++j) {
      if (reference[j] == kAtRest) break;
      if (!(reference[j] == reference[i])) continue;
      if (is_part_of(had.subspan(next + 1), wanted.subspan(j + 1))) last = j;
    }
    const std::optional<double> share = last > i ? opening_of(i, last) : std::nullopt;
    if (share) {
      const double opens_rad_s =
          std::lerp(found.speeds_rad_s[next], found.speeds_rad_s[next + 1], *share);
      for (; i < last; ++i) all.speeds_rad_s.push_back(opens_rad_s);
    }
    ++next;
    end_here(i);
  }
  if (next < had.size()) return std::nullopt;
  return all;
}

}  // namespace torquewright::actuator
