// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace torquewright::actuator {

/// Between two instants the position changes by the one and the velocity's integral by the other.
struct TravelContradiction {
  double from_s = 0.0;
  double until_s = 0.0;
  double position_change_rad = 0.0;
  double velocity_integral_rad = 0.0;
};

/// Whether a logged velocity is that of the logged position at all: its integral over a window
/// against what the position changes by in it, for windows of 1, 2, 4, ... steps. In short windows
/// the position's rounding and noise are large, in long ones a motion that comes back cancels; a
/// velocity that belongs to the position agrees in some of those between, one that is dead,
/// constant or another joint's in none. docs/derivations/check.md eq. (11).
class TravelAgreement {
 public:
  /// A later row; angles that run on.
  void add(double time_s, double position_rad, double velocity_rad_s);

  /// Empty: they agree, or what is left over is too slow to matter to a drive of that no-load
  /// speed [rad/s], or too short to be told from play and rounding.
  std::optional<TravelContradiction> contradiction(double no_load_speed_rad_s) const;

 private:
  struct Window {
    double duration_s = 0.0;
    double position_rad = 0.0;   ///< Change.
    double velocity_rad = 0.0;   ///< Integral, by trapezia.
    double tolerance_rad = 0.0;  ///< How far off that may be: the velocity turns between rows.
  };
  struct Scale {
    std::optional<Window> half;  ///< That waits for its other half.
    std::size_t windows = 0;
    double duration_s = 0.0;
    double travel_rad = 0.0;        ///< Sum of the greater of both changes, where it can be seen.
    double left_over_rad = 0.0;     ///< Sum of what is beyond the tolerance, there.
    double left_over_rad2_s = 0.0;  ///< Sum of its squares over the windows' durations.
  };
  struct Mark {
    double time_s = 0.0;
    double position_rad = 0.0;
    double velocity_rad = 0.0;
    double left_over_rad() const { return position_rad - velocity_rad; }
  };

  bool is_gap(double step_s) const;
  void add_window(Window window);
  bool contradicts(const Scale& scale, double no_load_speed_rad_s) const;

  std::vector<Scale> scales_;
  std::size_t rows_ = 0;
  double first_s_ = 0.0, last_s_ = 0.0, last_position_rad_ = 0.0, last_velocity_rad_s_ = 0.0;
  Mark now_, least_, greatest_;  ///< Summed since the first row, gaps left out.
};

}  // namespace torquewright::actuator
