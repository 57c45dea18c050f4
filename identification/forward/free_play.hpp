// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace torquewright::identification {

/// A body that hangs on another through a dead zone. In the gap its equation of motion is J x'' =
/// push_Nm, where x is its place in the gap, from -gap/2 to gap/2.
class FreeSide {
 public:
  virtual ~FreeSide() = default;
  virtual std::size_t samples() const = 0;
  /// Torque on the body at that speed against the other body, less its inertia times the other
  /// body's acceleration; at speed 0 it is what passes between them while they touch. Linear over
  /// `share` (0 to 1), the time from a sample to the next.
  virtual double push_Nm(std::size_t sample, double share, double speed_rad_s) const = 0;
};

/// The longest step in which a free side is simulated.
constexpr double kFreePlayStep_s = 2e-4;

/// Motion of a body in a gap, by sample; acceleration and change of push are means over a step
/// around it.
struct GapMotion {
  std::vector<double> place_rad;
  /// Acceleration against the other body, including the meeting of flanks.
  std::vector<double> acceleration_rad_s2;
  std::vector<double> push_change_Nm;  ///< push_Nm at the body's speed less that at speed 0.
};

/// Simulates the body in the gap. On a flank it rests while it is pushed there; pushed away it
/// leaves, crosses, and meets the other flank without rebound. The torque that passes through the
/// gap is the push less J x'' (docs/derivations/identification.md section 10).
GapMotion move_in_gap(const FreeSide& side, double inertia_kg_m2, double gap_rad, double step_s);

}  // namespace torquewright::identification
