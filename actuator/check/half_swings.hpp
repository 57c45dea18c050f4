// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

namespace torquewright::actuator {

/// How far a motion has come at a row: changes since the first, gaps left out.
struct Travel {
  std::size_t row = 0;
  double time_s = 0.0;
  double position_rad = 0.0;
  double velocity_rad = 0.0;   ///< The velocity's integral, by trapezia.
  double tolerance_rad = 0.0;  ///< How far off that may be: the velocity turns between rows.
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

/// Cuts a motion where what it follows, the position or the velocity's integral, turns by more than
/// a height. What moves by less rests.
class HalfSwings {
 public:
  HalfSwings(double height_rad, double Travel::*followed)
      : height_rad_(height_rad), followed_(followed) {}

  /// The half swing that ends with this row's turn, if one does.
  std::optional<HalfSwing> add(const Travel& now);

  /// What either end of a half swing may lack: what is nearer to a turning point rests there.
  double unseen_rad() const;

  /// The one under way, and none is any more.
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
  double direction_ = 0.0;  ///< 1, -1; 0: nothing has moved.
  bool has_begun_ = false;
  Travel start_;     ///< The turning point behind.
  Travel leaves_;    ///< The last row near it.
  Travel farthest_;  ///< The turning point ahead, as far as is known.
  Travel stays_;     ///< The last row near that.
  Travel arrives_;   ///< The first row near it.
};

}  // namespace torquewright::actuator
