// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

namespace torquewright::gearbox {

// Whether a shaper that is fed in radially cuts away the tips of its ring:
// docs/derivations/tooth_outline.md eqs. (17)...(21). Lengths in modules.

/// A shaper without profile shift of its own.
struct FedShaper {
  double teeth = 0.0;
  double tip_radius = 0.0;  ///< Radius of its tip circle.
  double rounding = 0.0;    ///< Rounding of its tips; 0 is on the safe side.
};

struct FedRing {
  double teeth = 0.0;
  double profile_shift = 0.0;
  double tip_radius = 0.0;  ///< Radius of its tip circle.
};

/// Eq. (21): how much farther the ring's tips could reach before the shaper's tips touch them on
/// their way in [rad at the ring]. Negative: they are cut away. Nothing where the shaper is larger
/// than the ring's tip circle, or the ring's tips lie inside their base circle.
std::optional<double> feed_margin_rad(const FedShaper& shaper, const FedRing& ring);

/// The fewest teeth of a ring without profile shift into which a shaper with this addendum can be
/// fed. The margin grows with the ring.
std::int64_t least_fed_ring(std::int64_t shaper_teeth, double addendum, double rounding);

}  // namespace torquewright::gearbox
