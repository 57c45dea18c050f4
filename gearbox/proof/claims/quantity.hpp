// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "gearbox/floors.hpp"
#include "gearbox/proof/gears/ratio_condition.hpp"
#include "gearbox/proof/gears/rough_interval.hpp"

namespace torquewright::gearbox::proof {

enum class Measure {
  kPaperCost,
  kMass,
  kHollowShaft,
  kForwardEfficiency,
  kBackwardEfficiency,
  kReflectedInertia,
  kTeeth,
  kCarrierClearance,
  kRingPitchDiameter,
  kRatioError,
  kContactRatio,
  kNeighbourClearance,
  kRingBlankDiameter,
  kBacklash,
  kAxialLength,
};

/// What a claim compares.
struct Quantity {
  Measure measure;
  int gear = 0;  ///< kTeeth only.

  bool greater_is_better() const;
};

/// The objective as quantity.
Quantity objective_quantity(Objective objective);

/// What a floor or ceiling limits.
Quantity floor_quantity(FloorQuantity floor);

/// A value: exact where the quantity is a fraction.
struct Value {
  Interval enclosure;
  std::optional<Rational> exact;
};

/// The quantity's value for one design, a point with positive teeth.
Value value_at(const Quantity& quantity, const Alternative& alternative, const Point& point);

/// An interval that holds the quantity of every design of the box with a ratio among those allowed
/// (which matters to efficiencies and inertia only). The box holds some.
Interval enclosure_on(const Quantity& quantity, const Alternative& alternative, const Box& box,
                      const Interval& allowed_ratio);

/// The same in doubles, which is quick, of objectives; empty for what is exact or needs angles.
std::optional<RoughInterval> rough_enclosure_on(const Quantity& quantity,
                                                const Alternative& alternative, const Box& box,
                                                const RoughInterval& allowed_ratio);

/// What counts as equal to a value that is no fraction: a millionth of a millionth of it.
Interval equality_margin(const Value& value);

/// 1: better than the reference, -1: worse, 0: as good (docs/certificate.md on equality).
int compare(const Quantity& quantity, const Value& value, const Value& reference);

}  // namespace torquewright::gearbox::proof
