// SPDX-License-Identifier: Apache-2.0
#include "actuator/mor/mor_table.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace torquewright::actuator {
namespace {

constexpr int kFirstIntervals = 24;         // of each side, before any refinement
constexpr double kCornerTolerance = 1e-13;  // of the greatest speed
constexpr int kDeepestSplit = 40;  // halvings of one interval: a tip is as steep as a root at 0
// Rows of one interval, times the root of the accuracy, to which smooth bounds take some tenths:
// where a bound scatters (as a search finds it, close to a nose) no number of rows is accurate.
constexpr double kMostRowsTimesRoot = 10.0;

/// What stays the same between two corners.
struct Character {
  bool is_empty;
  Limiter limiter_least;
  Limiter limiter_greatest;
  int sign_least;
  int sign_greatest;
  friend bool operator==(const Character&, const Character&) = default;
};

int sign_of(double value) { return value > 0.0 ? 1 : value < 0.0 ? -1 : 0; }

Character character_of(const JointRange& range) {
  return {range.is_empty, range.least.limiter, range.greatest.limiter,
          sign_of(range.least.torque_Nm), sign_of(range.greatest.torque_Nm)};
}

double between(double one, double other, double share) { return one + share * (other - one); }

/// What the motor can do at speeds of one direction, each asked for once: it serves both.
class MotorRanges {
 public:
  explicit MotorRanges(const Region& region) : region_(region) {}

  JointRange joint_range(double distance_rad_s, double direction) {
    // A curve need not be the same both ways round.
    if (region_.model().envelope) return region_.at(direction * distance_rad_s, direction);
    const auto [place, is_new] = known_.try_emplace(distance_rad_s);
    if (is_new) place->second = region_.motor_at(distance_rad_s);
    return region_.at(direction * distance_rad_s, direction,
                      direction < 0.0 ? mirrored(place->second) : place->second);
  }

 private:
  const Region& region_;
  std::unordered_map<double, MotorRange> known_;
};

/// The rows of one direction of motion, from rest outward.
class HalfTable {
 public:
  HalfTable(const Region& region, MotorRanges& ranges, double direction)
      : region_(region), ranges_(ranges), direction_(direction) {}

  std::vector<MorRow> run(double accuracy, double& peak_Nm, double& error_Nm) {
    const double end_rad_s = region_.greatest_speed_rad_s();
    for (int i = 0; i <= kFirstIntervals; ++i)
      rows_.push_back(row(end_rad_s * i / kFirstIntervals));
    insert_corners();
    for (const MorRow& entry : rows_) peak_Nm = std::max(peak_Nm, magnitude(entry));
    refine(accuracy * peak_Nm, static_cast<std::size_t>(kMostRowsTimesRoot / std::sqrt(accuracy)));
    error_Nm = std::max(error_Nm, error_Nm_);
    return std::move(rows_);
  }

 private:
  MorRow row(double distance_rad_s) const {
    return {direction_ * distance_rad_s, ranges_.joint_range(distance_rad_s, direction_)};
  }

  static double magnitude(const MorRow& entry) {
    if (entry.range.is_empty) return 0.0;
    return std::max(std::abs(entry.range.least.torque_Nm),
                    std::abs(entry.range.greatest.torque_Nm));
  }

  /// Rows on both sides of every change of character between two neighbours, the nearest to the
  /// change that rounding allows.
  void insert_corners() {
    const double tolerance_rad_s = kCornerTolerance * region_.greatest_speed_rad_s();
    std::vector<MorRow> all{rows_.front()};
    for (std::size_t i = 1; i < rows_.size(); ++i) {
      // A neighbour may be several corners away: go from each to the next.
      for (int corners = 0; corners < 8; ++corners) {
        const MorRow near = all.back();
        if (character_of(near.range) == character_of(rows_[i].range)) break;
        const auto [before, after] = corner(near, rows_[i], tolerance_rad_s);
        if (before.speed_rad_s != near.speed_rad_s) all.push_back(before);
        all.push_back(after);
        if (after.speed_rad_s == rows_[i].speed_rad_s) break;
      }
      if (all.back().speed_rad_s != rows_[i].speed_rad_s) all.push_back(rows_[i]);
    }
    rows_ = std::move(all);
  }

  std::pair<MorRow, MorRow> corner(MorRow near, MorRow far, double tolerance_rad_s) const {
    const Character here = character_of(near.range);
    while (std::abs(far.speed_rad_s - near.speed_rad_s) > tolerance_rad_s) {
      const double middle_rad_s = 0.5 * (std::abs(near.speed_rad_s) + std::abs(far.speed_rad_s));
      const MorRow middle = row(middle_rad_s);
      (character_of(middle.range) == here ? near : far) = middle;
    }
    return {near, far};
  }

  void refine(double allowed_Nm, std::size_t most_rows) {
    std::vector<MorRow> all{rows_.front()};
    for (std::size_t i = 1; i < rows_.size(); ++i) {
      const MorRow near = all.back();
      const double width_rad_s = std::abs(rows_[i].speed_rad_s - near.speed_rad_s);
      const bool is_corner = width_rad_s <= 2.0 * kCornerTolerance * region_.greatest_speed_rad_s();
      if (is_corner) {
        all.push_back(rows_[i]);
      } else {
        split(all, near, middle_of(near, rows_[i]), rows_[i],
              {allowed_Nm, kDeepestSplit, all.size() + most_rows});
      }
    }
    rows_ = std::move(all);
  }

  MorRow middle_of(const MorRow& near, const MorRow& far) const {
    return row(0.5 * (std::abs(near.speed_rad_s) + std::abs(far.speed_rad_s)));
  }

  struct Allowance {
    double error_Nm;
    int splits_left;
    std::size_t rows;  ///< At most, with those before the interval.
  };

  /// Adds the rows after `near` up to `far`. The probes at a quarter and three quarters are the
  /// middles of the halves, if it comes to that.
  void split(std::vector<MorRow>& all, const MorRow& near, const MorRow& middle, const MorRow& far,
             Allowance allowed) {
    const MorRow first = middle_of(near, middle);
    const MorRow last = middle_of(middle, far);
    const double error_Nm =
        std::max({miss_Nm(near, first, far), miss_Nm(near, middle, far), miss_Nm(near, last, far)});
    // Nothing is gained where torques have no bound.
    if (!(error_Nm > allowed.error_Nm) || allowed.splits_left == 0 || all.size() >= allowed.rows) {
      error_Nm_ = std::max(error_Nm_, error_Nm);
      all.push_back(far);
      return;
    }
    --allowed.splits_left;
    split(all, near, first, middle, allowed);
    split(all, middle, last, far, allowed);
  }

  /// By how much the line from `near` to `far` misses the row between them.
  static double miss_Nm(const MorRow& near, const MorRow& there, const MorRow& far) {
    if (near.range.is_empty || far.range.is_empty || there.range.is_empty) return 0.0;
    const double share =
        (there.speed_rad_s - near.speed_rad_s) / (far.speed_rad_s - near.speed_rad_s);
    const double least_Nm = between(near.range.least.torque_Nm, far.range.least.torque_Nm, share);
    const double greatest_Nm =
        between(near.range.greatest.torque_Nm, far.range.greatest.torque_Nm, share);
    return std::max(std::abs(there.range.least.torque_Nm - least_Nm),
                    std::abs(there.range.greatest.torque_Nm - greatest_Nm));
  }

  const Region& region_;
  MotorRanges& ranges_;
  double direction_;
  std::vector<MorRow> rows_;
  double error_Nm_ = 0.0;
};

bool jumps(const MorRow& below, const MorRow& above) {
  return below.range.least.torque_Nm != above.range.least.torque_Nm ||
         below.range.greatest.torque_Nm != above.range.greatest.torque_Nm ||
         below.range.is_empty != above.range.is_empty;
}

}  // namespace

MorTable mor_table(const Region& region, double accuracy) {
  MorTable table;
  MotorRanges ranges(region);
  const auto half = [&](double direction) {
    return HalfTable(region, ranges, direction)
        .run(accuracy, table.peak_torque_Nm, table.interpolation_error_Nm);
  };
  std::vector<MorRow> negative = half(-1.0);
  const std::vector<MorRow> positive = half(1.0);
  std::reverse(negative.begin(), negative.end());
  negative.back().speed_rad_s = 0.0;  // not -0
  if (!jumps(negative.back(), positive.front())) negative.pop_back();
  table.rows = std::move(negative);
  table.rows.insert(table.rows.end(), positive.begin(), positive.end());
  return table;
}

MorTable mor_rows(const Region& region, const std::vector<double>& speeds_rad_s) {
  MorTable table;
  for (const double speed_rad_s : speeds_rad_s) {
    table.rows.push_back({speed_rad_s, region.at(speed_rad_s)});
    const JointRange& range = table.rows.back().range;
    if (range.is_empty) continue;
    table.peak_torque_Nm = std::max({table.peak_torque_Nm, std::abs(range.least.torque_Nm),
                                     std::abs(range.greatest.torque_Nm)});
  }
  return table;
}

}  // namespace torquewright::actuator
