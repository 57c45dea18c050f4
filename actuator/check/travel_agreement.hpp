// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "actuator/check/half_swings.hpp"

namespace torquewright::actuator {

/// In the half swing that agrees least, the position changes by the one and the velocity's integral
/// by the other.
struct TravelContradiction {
  double from_s = 0.0;
  double until_s = 0.0;
  double position_change_rad = 0.0;
  double velocity_integral_rad = 0.0;
};

/// Half swings one after another: how far they went, and by how much the two disagree.
struct Stretch {
  std::size_t rows = 0;
  double duration_s = 0.0;
  double travel_rad = 0.0;        ///< Sum of the greater of both changes.
  double left_over_rad = 0.0;     ///< Sum of what is beyond the tolerance.
  double left_over_rad2_s = 0.0;  ///< Sum of its squares over the durations.
  HalfSwing worst;
  double worst_rad = 0.0;

  void add(const HalfSwing& swing);
  double excess_rad() const;  ///< Left over beyond what is forgiven of the travel.
  double speed_rad_s() const;
};

/// The half swings of one series at one height, and the stretch of them that disagrees most.
class Disagreement {
 public:
  Disagreement(double height_rad, double Travel::*followed)
      : followed_(followed), swings_(height_rad, followed) {}

  void add(const Travel& now);
  void interrupt();  ///< What comes is not known to go on from here.
  /// The stretch, if it is as much of a motion as the greatest half swing.
  std::optional<Stretch> found() const;

 private:
  void take(const HalfSwing& swing);

  double Travel::*followed_;
  HalfSwings swings_;
  Stretch now_, most_;
  double greatest_rad_ = 0.0;
};

/// Whether a logged velocity is that of the logged position at all, half swing by half swing: what
/// the position changes by, against the velocity's integral over it. Which height makes a turn
/// follows from the position's own noise and steps. docs/derivations/check.md eq. (11).
class TravelAgreement {
 public:
  TravelAgreement();

  /// A later row; angles that run on.
  void add(double time_s, double position_rad, double velocity_rad_s);

  /// Empty: they agree, or what is left over is too slow to matter to a drive of that no-load
  /// speed [rad/s], or cannot be told from play, rounding and noise.
  std::optional<TravelContradiction> contradiction(double no_load_speed_rad_s) const;

 private:
  struct Row {
    double time_s = 0.0;
    double position_rad = 0.0;
    double velocity_rad_s = 0.0;
  };
  /// All that is followed at one height.
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
  std::vector<Row> waiting_;  ///< The newest, which waits for the one behind it, and its elder.
  std::optional<Row> passed_;
  Travel now_;  ///< Up to the last sample.
  std::size_t rows_ = 0;
  double first_s_ = 0.0, last_s_ = 0.0;
  std::size_t bends_ = 0;
  double bends_rad2_ = 0.0;  ///< Sum of neighbours' products.
  double last_bend_rad_ = 0.0;
  double least_step_rad_;
  bool has_stayed_ = false;  ///< From one row to the next, as rounded positions do.
};

}  // namespace torquewright::actuator
