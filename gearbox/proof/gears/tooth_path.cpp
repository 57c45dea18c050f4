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

/// What paths need of it.
template <typename Number>
struct PathConstants {
  Number cosine = profile().cosine;
  Number tangent = profile().tangent;
  Number whole_turn = 2 * pi();
};

template <typename Number>
const PathConstants<Number>& constants() {
  static const PathConstants<Number> value;
  return value;
}

/// tan of the pressure angle at a circle of `tip` half modules; cos = teeth cos(alpha) / tip.
template <typename Number>
Number tip_tangent(std::int64_t teeth, std::int64_t tip) {
  const Number secant = number<Number>(tip) / (number<Number>(teeth) * constants<Number>().cosine);
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

template <typename Number>
Number external_path(std::int64_t teeth) {
  const auto& [cosine, tangent, whole_turn] = constants<Number>();
  return number<Number>(teeth) * (tip_tangent<Number>(teeth, teeth + 2) - tangent) / whole_turn;
}

template <typename Number>
Number ring_path(std::int64_t teeth) {
  const auto& [cosine, tangent, whole_turn] = constants<Number>();
  const Number tip =
      teeth <= kMostTeethInsideBase ? Number(0) : tip_tangent<Number>(teeth, teeth - 2);
  return number<Number>(teeth) * (tangent - tip) / whole_turn;
}

template <typename Number>
Number external_path(std::int64_t fewest, std::int64_t most) {
  if (fewest == most) return external_path<Number>(fewest);
  return hull(external_path<Number>(fewest), external_path<Number>(most));
}

template <typename Number>
Number ring_path(std::int64_t fewest, std::int64_t most) {
  if (fewest == most) return ring_path<Number>(fewest);
  Number range = hull(ring_path<Number>(fewest), ring_path<Number>(most));
  for (const std::int64_t peak : {kMostTeethInsideBase, kMostTeethInsideBase + 1}) {
    if (fewest < peak && peak < most) range = hull(range, ring_path<Number>(peak));
  }
  return range;
}

template Interval external_path<Interval>(std::int64_t, std::int64_t);
template Interval ring_path<Interval>(std::int64_t, std::int64_t);
template RoughInterval external_path<RoughInterval>(std::int64_t, std::int64_t);
template RoughInterval ring_path<RoughInterval>(std::int64_t, std::int64_t);

}  // namespace torquewright::gearbox::proof
