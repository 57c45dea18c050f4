// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "actuator/check/half_swings.hpp"

namespace torquewright::actuator {

/// The half swing in which position and velocity agree least: the change of the position, and that
/// of the velocity's integral.
struct TravelContradiction {
  double from_s = 0.0;
  double until_s = 0.0;
  double position_change_rad = 0.0;
  double velocity_integral_rad = 0.0;
};

/// Successive half swings: how far they went, and by how much position and velocity disagree.
struct Stretch {
  std::size_t rows = 0;
  double duration_s = 0.0;
  double travel_rad = 0.0;        ///< Sum of the greater of both changes.
  double left_over_rad = 0.0;     ///< Sum of what exceeds the tolerance.
  double left_over_rad2_s = 0.0;  ///< Sum of its squares over the durations.
  HalfSwing worst;
  double worst_rad = 0.0;

  void add(const HalfSwing& swing);
  double excess_rad() const;  ///< What exceeds the forgiven share of the travel.
  double speed_rad_s() const;
};

/// The half swings of one series at one height, and the stretch of them that disagrees most.
class Disagreement {
 public:
  Disagreement(double height_rad, double Travel::*followed)
      : followed_(followed), swings_(height_rad, followed) {}

  void add(const Travel& now);
  void interrupt();  ///< Ends the present half swing: what follows may not continue it.
  /// Returns the stretch, if it moves as far as the greatest half swing.
  std::optional<Stretch> found() const;

 private:
  void take(const HalfSwing& swing);

  double Travel::*followed_;
  HalfSwings swings_;
  Stretch now_, most_;
  double greatest_rad_ = 0.0;
};

/// Decides whether a logged velocity belongs to the logged position at all, half swing by half
/// swing: the change of the position against the velocity's integral. The height that makes a turn
/// follows from the position's own noise and steps (docs/derivations/check.md eq. (11)).
class TravelAgreement {
 public:
  TravelAgreement();

  /// Adds a later row, with angles that run on.
  void add(double time_s, double position_rad, double velocity_rad_s);

  /// Returns the contradiction. Empty: they agree, or what is left over is too slow to matter to a
  /// drive of that no-load speed [rad/s], or cannot be told from play, rounding and noise.
  std::optional<TravelContradiction> contradiction(double no_load_speed_rad_s) const;

 private:
  struct Row {
    double time_s = 0.0;
    double position_rad = 0.0;
    double velocity_rad_s = 0.0;
  };
  /// Everything that is followed at one height.
  struct Rung {
    double height_rad;
    Disagreement of_positions, of_velocities;
  };

  bool is_gap(double step_s) const;
  void interrupt();
  void learn_noise(const Row& after);
  void go_to(const Row& row);
  double least_height_rad() const;

  std::vector<Rung> rungs_;
  /// The newest row, which waits for the next one, and the row before it.
  std::vector<Row> waiting_;
  std::optional<Row> passed_;
  Travel now_;  ///< Travel up to the last sample.
  std::size_t rows_ = 0;
  double first_s_ = 0.0, last_s_ = 0.0;
  std::size_t bends_ = 0;
  double bends_rad2_ = 0.0;  ///< Sum of products of neighbouring bends.
  double last_bend_rad_ = 0.0;
  double least_step_rad_;
  /// The position has stayed from one row to the next, as rounded positions do.
  bool has_stayed_ = false;
};

}  // namespace torquewright::actuator
