// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace torquewright::oracles {

/// Reference pressure angle of 20 degrees.
long double pressure_angle_rad();

/// The path of contact in base pitches from the pitch point, for gears without profile shift and
/// with addenda of one module. NaN where a ring's tip circle lies inside its base circle.
struct ContactPath {
  long double approach = 0;  ///< epsilon_A, ended by the second gear's tip.
  long double recess = 0;    ///< epsilon_R, ended by the first gear's tip.
  long double ratio() const { return approach + recess; }
};

ContactPath external_path(std::int64_t first, std::int64_t second);
ContactPath internal_path(std::int64_t planet, std::int64_t ring);

/// P/R - 1 + tan(alpha_a2)/tan(alpha); NaN as above.
long double involute_margin(std::int64_t planet, std::int64_t ring);

/// theta_1 P/R + inv(alpha) - inv(alpha_a2) - theta_2, in rad; NaN as above.
long double trochoid_margin_rad(std::int64_t planet, std::int64_t ring);

/// How deep below its middle line a hob is straight, and how deep the tip of a ring asks the hob of
/// its planet to be (NaN as above), and that of an external mate. In modules.
long double straight_depth(long double hob_addendum, long double hob_tip_radius);
long double depth_at_ring_tip(std::int64_t ring);
long double depth_at_gear_tip(std::int64_t teeth);

/// How far beyond the pitch point, along the line of action and in modules, the involute of a ring
/// goes that a shaper cut, and the tip of a planet.
long double reach_of_shaper(std::int64_t shaper, long double addendum, long double tip_radius);
long double reach_of_planet(std::int64_t planet);

/// The least height, over all turns, of a ring's tip over the tip of the shaper that rolls in it,
/// in modules: negative, and the shaper cuts the tip away when it is drawn in along that line. NaN
/// where the shaper is too large to pass, or the ring's tips lie inside their base circle.
long double height_over_fed_shaper(std::int64_t ring, std::int64_t shaper, long double addendum,
                                   long double tip_radius);

/// Lambda = 2 * integral of |x|/k(x) along the path, k pairs being in contact at once.
long double loss_factor(const ContactPath& path);

/// Basic efficiency of a mesh with the carrier held: 1 - mu pi (1/z1 +- 1/z2) Lambda.
long double external_efficiency(std::int64_t first, std::int64_t second, long double friction);
long double internal_efficiency(std::int64_t planet, std::int64_t ring, long double friction);

}  // namespace torquewright::oracles
