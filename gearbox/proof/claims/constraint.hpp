// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gearbox/proof/gears/alternative.hpp"

namespace torquewright::gearbox::proof {

enum class ConstraintFamily {
  kPositiveTeeth,  ///< planet_2 >= 1: what makes a point of a 3k box a design.
  kRatio,
  kMinTeeth,
  kCarrierClearance,
  kRotorBore,
  kToothDifference,
  kEqualSpacing,
  kIdenticalPlanets,
  kNeighbourClearance,
  kUndercut,
  kSunUnderLayer2,
  kRingWall,
  kRingTip,
  kInvoluteInterference,
  kTrochoidInterference,
  kHobRootForm,
  kShaperRootForm,
  kShaperFeed,
  kContactRatio,
  kFloor,  ///< Of what the problem asks of a quantity: kFloors.
};

/// One named constraint of docs/gearbox_constraints.md.
struct Constraint {
  std::string name;
  ConstraintFamily family;
  /// Gear 0.. (minima, undercut), layer 1.. (clearances, rings), mesh 0.., or place in kFloors.
  int place = 0;
  std::string key;  ///< Of the bound that sets its limit, as a JSON pointer; empty: none.
};

/// All constraints of the problem, in the order of the documentation.
std::vector<Constraint> constraints_of(const Problem& problem);

/// nullptr if the problem has no constraint of that name.
const Constraint* find_constraint(const std::vector<Constraint>& constraints,
                                  std::string_view name);

/// Whether a design of this alternative satisfies the constraint. Linear constraints are judged for
/// teeth of either sign, the others need positive teeth.
bool satisfies(const Constraint& constraint, const Alternative& alternative, const Teeth& teeth);

}  // namespace torquewright::gearbox::proof
