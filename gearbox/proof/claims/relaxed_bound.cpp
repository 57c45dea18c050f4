// SPDX-License-Identifier: Apache-2.0
#include "gearbox/proof/claims/relaxed_bound.hpp"

#include <algorithm>

#include "gearbox/proof/claims/constraint.hpp"

namespace torquewright::gearbox::proof {
namespace {

constexpr std::string_view kMinTeeth = "/min_teeth/";

std::optional<RelaxedBound> teeth_bound(const Problem& problem, const std::string& gear) {
  const auto& gears = train_of(problem).free_gears;
  const auto found = std::find(gears.begin(), gears.end(), gear);
  const auto minimum = problem.min_teeth.find(gear);
  if (found == gears.end() || minimum == problem.min_teeth.end()) return std::nullopt;
  return RelaxedBound{std::string(kMinTeeth) + gear,
                      "teeth." + gear,
                      {Measure::kTeeth, static_cast<int>(found - gears.begin())},
                      Rational(static_cast<long>(minimum->second))};
}

std::optional<RelaxedBound> floor_bound(const Problem& problem, std::string_view key) {
  for (const FloorRecord& floor : kFloors) {
    if (floor.key != key) continue;
    return RelaxedBound{std::string(key), std::string(floor.name), floor_quantity(floor.quantity),
                        *(problem.floors.*floor.limit)};
  }
  return std::nullopt;
}

/// False: the bound is no floor's.
bool set_floor(const RelaxedBound& bound, const Rational& value, Problem& problem) {
  for (const FloorRecord& floor : kFloors) {
    if (floor.key != bound.key) continue;
    problem.floors.*floor.limit = value;
    return true;
  }
  return false;
}

Rational ring_space_mm(const Problem& problem) {
  return problem.ring_outer_diameter_mm.value_or(problem.rotor_inner_diameter_mm);
}

bool bounds_blank(const std::vector<Constraint>& constraints, std::string_view key) {
  return std::any_of(constraints.begin(), constraints.end(), [&](const Constraint& each) {
    return each.family == ConstraintFamily::kRingWall && each.key == key;
  });
}

}  // namespace

std::optional<RelaxedBound> find_relaxed_bound(const Problem& problem, std::string_view key) {
  const auto constraints = constraints_of(problem);
  const bool is_enforced = std::any_of(constraints.begin(), constraints.end(),
                                       [&](const Constraint& each) { return each.key == key; });
  if (!is_enforced) return std::nullopt;
  if (key.substr(0, kMinTeeth.size()) == kMinTeeth) {
    return teeth_bound(problem, std::string(key.substr(kMinTeeth.size())));
  }
  if (const auto floor = floor_bound(problem, key)) return floor;
  const RelaxedBound blank{std::string(key),
                           "ring_blank_diameter_mm",
                           {Measure::kRingBlankDiameter},
                           ring_space_mm(problem)};
  if (bounds_blank(constraints, key)) return blank;
  const RelaxedBound bounds[] = {
      {"/min_carrier_clearance_rad",
       "carrier_clearance",
       {Measure::kCarrierClearance},
       problem.min_carrier_clearance_rad},
      {"/rotor_inner_diameter_mm",
       "ring_pitch_diameter_mm",
       {Measure::kRingPitchDiameter},
       problem.rotor_inner_diameter_mm},
      {"/ratio_tolerance", "ratio_error", {Measure::kRatioError}, problem.ratio_tolerance},
      {"/min_contact_ratio", "contact_ratio", {Measure::kContactRatio}, problem.min_contact_ratio},
      {"/min_neighbour_clearance_mm",
       "neighbour_clearance_mm",
       {Measure::kNeighbourClearance},
       problem.min_neighbour_clearance_mm},
  };
  for (const RelaxedBound& bound : bounds) {
    if (bound.key == key) return bound;
  }
  return std::nullopt;
}

std::optional<Problem> with_bound(const Problem& problem, const RelaxedBound& bound,
                                  const Rational& value) {
  Problem relaxed = problem;
  if (set_floor(bound, value, relaxed)) return relaxed;
  switch (bound.quantity.measure) {
    case Measure::kTeeth: {
      if (value.get_den() != 1 || !value.get_num().fits_slong_p()) return std::nullopt;
      const auto gear = static_cast<std::size_t>(bound.quantity.gear);
      relaxed.min_teeth[train_of(problem).free_gears[gear]] = value.get_num().get_si();
      break;
    }
    case Measure::kCarrierClearance:
      relaxed.min_carrier_clearance_rad = value;
      break;
    case Measure::kRingPitchDiameter:
      relaxed.rotor_inner_diameter_mm = value;
      break;
    case Measure::kRatioError:
      relaxed.ratio_tolerance = value;
      break;
    case Measure::kContactRatio:
      relaxed.min_contact_ratio = value;
      break;
    case Measure::kNeighbourClearance:
      relaxed.min_neighbour_clearance_mm = value;
      break;
    default: {
      const bool is_stated = problem.ring_outer_diameter_mm.has_value();
      (is_stated ? *relaxed.ring_outer_diameter_mm : relaxed.rotor_inner_diameter_mm) = value;
      break;
    }
  }
  return relaxed;
}

}  // namespace torquewright::gearbox::proof
