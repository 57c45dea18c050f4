// SPDX-License-Identifier: Apache-2.0
#include "gearbox/proof/gears/tooth_path.hpp"

namespace torquewright::gearbox::proof {
namespace {

/// Most teeth of a ring whose tip circle lies inside its base circle: z (1 - cos 20 deg) <= 2.
constexpr std::int64_t kMostTeethInsideBase = 33;

struct Profile {
  Interval angle = pi() / 9;
  Interval cosine = cos(angle);
  Interval tangent = tan(angle);
};

const Profile& profile() {
  static const Profile value;
  return value;
}

/// tan of the pressure angle at a circle of `tip` half modules; cos = teeth cos(alpha) / tip.
Interval tip_tangent(std::int64_t teeth, std::int64_t tip) {
  const Interval secant = number(tip) / (number(teeth) * profile().cosine);
  return sqrt(square(secant) - 1);
}

}  // namespace

const Interval& pressure_angle() { return profile().angle; }

bool has_tip_outside_base(std::int64_t ring) { return ring > kMostTeethInsideBase; }

Interval involute(const Interval& angle) { return tan(angle) - angle; }

Interval external_tip_angle(std::int64_t teeth) {
  return acos(number(teeth) * profile().cosine / number(teeth + 2));
}

Interval ring_tip_angle(std::int64_t teeth) {
  if (teeth <= kMostTeethInsideBase) return 0;
  return acos(number(teeth) * profile().cosine / number(teeth - 2));
}

Interval external_path(std::int64_t teeth) {
  return number(teeth) * (tip_tangent(teeth, teeth + 2) - profile().tangent) / (2 * pi());
}

Interval ring_path(std::int64_t teeth) {
  const Interval tip = teeth <= kMostTeethInsideBase ? Interval(0) : tip_tangent(teeth, teeth - 2);
  return number(teeth) * (profile().tangent - tip) / (2 * pi());
}

Interval external_path(std::int64_t fewest, std::int64_t most) {
  if (fewest == most) return external_path(fewest);
  return hull(external_path(fewest), external_path(most));
}

Interval ring_path(std::int64_t fewest, std::int64_t most) {
  if (fewest == most) return ring_path(fewest);
  Interval range = hull(ring_path(fewest), ring_path(most));
  for (const std::int64_t peak : {kMostTeethInsideBase, kMostTeethInsideBase + 1}) {
    if (fewest < peak && peak < most) range = hull(range, ring_path(peak));
  }
  return range;
}

}  // namespace torquewright::gearbox::proof
