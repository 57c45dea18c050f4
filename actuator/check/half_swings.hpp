// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

namespace torquewright::actuator {

/// Changes of a motion since its first row, gaps left out.
struct Travel {
  std::size_t row = 0;
  double time_s = 0.0;
  double position_rad = 0.0;
  double velocity_rad = 0.0;   ///< Integral of the velocity, by trapezia.
  double tolerance_rad = 0.0;  ///< Error bound of that integral: the velocity turns between rows.
};

/// The motion from one turning point to the next, without the rest before and after it.
struct HalfSwing {
  Travel from, until;

  std::size_t rows() const { return until.row - from.row; }
  double duration_s() const { return until.time_s - from.time_s; }
  double position_rad() const { return until.position_rad - from.position_rad; }
  double velocity_rad() const { return until.velocity_rad - from.velocity_rad; }
  double tolerance_rad() const { return until.tolerance_rad - from.tolerance_rad; }
};

/// Cuts a motion into half swings, where what it follows, the position or the velocity's integral,
/// turns by more than a height. Smaller motion counts as rest.
class HalfSwings {
 public:
  HalfSwings(double height_rad, double Travel::*followed)
      : height_rad_(height_rad), followed_(followed) {}

  /// Adds a row and returns the half swing that ends with its turn, if one does.
  std::optional<HalfSwing> add(const Travel& now);

  /// What either end of a half swing may lack: motion nearer to a turning point counts as rest.
  double unseen_rad() const;

  /// Returns the half swing under way and ends it.
  std::optional<HalfSwing> rest();

 private:
  double change_rad(const Travel& from, const Travel& until) const {
    return until.*followed_ - from.*followed_;
  }
  bool is_near(const Travel& one, const Travel& other) const;
  void look_for_start(const Travel& now);
  void begin_at(const Travel& turn, const Travel& leaves, const Travel& now);
  void go_on(const Travel& now);

  double height_rad_;
  double Travel::*followed_;
  double direction_ = 0.0;  ///< 1 or -1; 0: nothing has moved.
  bool has_begun_ = false;
  Travel start_;     ///< The turning point behind.
  Travel leaves_;    ///< The last row near it.
  Travel farthest_;  ///< The turning point ahead, as far as it is known.
  Travel stays_;     ///< The last row near the turning point ahead.
  Travel arrives_;   ///< The first row near the turning point ahead.
};

}  // namespace torquewright::actuator
