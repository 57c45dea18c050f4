// SPDX-License-Identifier: Apache-2.0
#include <numeric>

#include "gearbox/proof/claims/constraint.hpp"
#include "gearbox/proof/claims/quantity.hpp"
#include "gearbox/proof/gears/contact_ratio.hpp"
#include "gearbox/proof/gears/interference.hpp"
#include "gearbox/proof/gears/ratio_condition.hpp"
#include "gearbox/proof/gears/root_form.hpp"
#include "gearbox/proof/gears/tooth_path.hpp"

namespace torquewright::gearbox::proof {
namespace {

Rational fraction(std::int64_t numerator, std::int64_t denominator) {
  Rational value(static_cast<long>(numerator), static_cast<long>(denominator));
  value.canonicalize();
  return value;
}

std::int64_t teeth_of(const Teeth& teeth, int gear) {
  return gear == 0 ? teeth.sun : planet(teeth, gear);
}

bool has_min_teeth(const Alternative& alternative, const Teeth& teeth, int gear) {
  const auto& minima = alternative.problem->min_teeth;
  const auto minimum = minima.find(alternative.train->free_gears[static_cast<std::size_t>(gear)]);
  return minimum == minima.end() || teeth_of(teeth, gear) >= minimum->second;
}

/// Equation (6).
bool has_carrier_clearance(const Alternative& alternative, const Teeth& teeth) {
  const Interval clearance = pi() / number(alternative.planet_count) -
                             asin(Interval(fraction(teeth.planet_1, teeth.sun + teeth.planet_1)));
  return sign(clearance - alternative.problem->min_carrier_clearance_rad) >= 0;
}

/// The star condition: n g divides O P1 - F P2.
bool has_identical_planets(const Alternative& alternative, const Teeth& teeth) {
  const mpz_class offset =
      mpz_class(static_cast<long>(ring(teeth, 2))) * static_cast<long>(teeth.planet_1) -
      mpz_class(static_cast<long>(ring(teeth, 1))) * static_cast<long>(teeth.planet_2);
  const std::int64_t divisor = std::gcd(teeth.planet_1, teeth.planet_2) * alternative.planet_count;
  return offset % static_cast<long>(divisor) == 0;
}

bool has_neighbour_clearance(const Alternative& alternative, const Teeth& teeth, int layer) {
  const Interval clearance =
      Interval(alternative.module_mm) *
      (number(teeth.sun + teeth.planet_1) * alternative.sine - number(planet(teeth, layer) + 2));
  return sign(clearance - alternative.problem->min_neighbour_clearance_mm) > 0;
}

/// Root circle and wall within the blank.
bool has_ring_wall(const Alternative& alternative, std::int64_t teeth) {
  const Rational blank_mm =
      alternative.module_mm *
          (Rational(static_cast<long>(teeth)) + 2 * alternative.problem->cutters.shaper_depth()) +
      2 * alternative.ring_wall_mm;
  return blank_mm <= alternative.ring_space_mm;
}

bool has_ring_tip_outside_base(std::int64_t teeth) {
  return sign(number(teeth) * (1 - cos(pressure_angle())) - 2) > 0;
}

/// Where a ring's tip circle lies inside its base circle there is no contact at all.
bool has_contact_ratio(const Alternative& alternative, const Teeth& teeth, int mesh) {
  if (mesh > 0 && !has_ring_tip_outside_base(ring(teeth, mesh))) return false;
  return sign(contact_ratio({teeth, teeth}, mesh) - alternative.problem->min_contact_ratio) >= 0;
}

bool meets_floor(const Alternative& alternative, const Teeth& teeth, const FloorRecord& floor) {
  const Rational from = met_from(floor, *(alternative.problem->floors.*floor.limit));
  const Point point{teeth.sun, teeth.planet_1, teeth.planet_1 - teeth.planet_2};
  const Value value = value_at(floor_quantity(floor.quantity), alternative, point);
  const int order = value.exact ? cmp(*value.exact, from) : sign(value.enclosure - from);
  return floor.is_ceiling ? order <= 0 : order >= 0;
}

}  // namespace

bool satisfies(const Constraint& constraint, const Alternative& alternative, const Teeth& teeth) {
  const int place = constraint.place;
  switch (constraint.family) {
    case ConstraintFamily::kPositiveTeeth:
      return teeth.planet_2 >= 1;
    case ConstraintFamily::kRatio:
      return has_ratio_in({alternative.least_ratio, alternative.greatest_ratio}, alternative,
                          teeth);
    case ConstraintFamily::kMinTeeth:
      return has_min_teeth(alternative, teeth, place);
    case ConstraintFamily::kCarrierClearance:
      return has_carrier_clearance(alternative, teeth);
    case ConstraintFamily::kRotorBore:
      return Rational(static_cast<long>(ring(teeth, 1))) <= alternative.largest_ring;
    case ConstraintFamily::kToothDifference:
      return teeth.planet_1 - teeth.planet_2 >= alternative.planet_count;
    case ConstraintFamily::kEqualSpacing:
      return 2 * (teeth.sun + teeth.planet_1) % alternative.planet_count == 0;
    case ConstraintFamily::kIdenticalPlanets:
      return has_identical_planets(alternative, teeth);
    case ConstraintFamily::kNeighbourClearance:
      return has_neighbour_clearance(alternative, teeth, place);
    case ConstraintFamily::kUndercut:
      return is_not_undercut(*alternative.problem, teeth_of(teeth, place));
    case ConstraintFamily::kSunUnderLayer2:
      return teeth.planet_1 - teeth.planet_2 > 4;
    case ConstraintFamily::kRingWall:
      return has_ring_wall(alternative, ring(teeth, place));
    case ConstraintFamily::kRingTip:
      return has_ring_tip_outside_base(ring(teeth, place));
    case ConstraintFamily::kInvoluteInterference:
      return is_free_of_involute_interference(planet(teeth, place), ring(teeth, place));
    case ConstraintFamily::kTrochoidInterference:
      return has_ring_tip_outside_base(ring(teeth, place)) &&
             is_free_of_trochoid_interference(planet(teeth, place), ring(teeth, place));
    case ConstraintFamily::kHobRootForm:
      if (place == 0) return has_root_form_of_hob(*alternative.problem, teeth.sun, teeth.planet_1);
      return has_root_form_of_hob(*alternative.problem, ring(teeth, place));
    case ConstraintFamily::kShaperRootForm:
      return has_root_form_of_shaper(*alternative.problem, planet(teeth, place),
                                     ring(teeth, place));
    case ConstraintFamily::kShaperFeed:
      return ring(teeth, place) >= alternative.least_fed_ring;
    case ConstraintFamily::kContactRatio:
      return has_contact_ratio(alternative, teeth, place);
    case ConstraintFamily::kFloor:
      return meets_floor(alternative, teeth, kFloors[static_cast<std::size_t>(place)]);
  }
  return false;
}

}  // namespace torquewright::gearbox::proof
