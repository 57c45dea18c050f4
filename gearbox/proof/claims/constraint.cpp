// SPDX-License-Identifier: Apache-2.0
#include "gearbox/proof/claims/constraint.hpp"

#include <algorithm>

#include "gearbox/floors.hpp"

namespace torquewright::gearbox::proof {
namespace {

using Constraints = std::vector<Constraint>;

void add_paper(const Problem& problem, Constraints& all) {
  all.push_back({"ratio", ConstraintFamily::kRatio, 0, "/ratio_tolerance"});
  const std::vector<std::string>& gears = train_of(problem).free_gears;
  for (int gear = 0; gear < static_cast<int>(gears.size()); ++gear) {
    const std::string& name = gears[static_cast<std::size_t>(gear)];
    all.push_back({"min_teeth." + name, ConstraintFamily::kMinTeeth, gear, "/min_teeth/" + name});
  }
  all.push_back(
      {"carrier_clearance", ConstraintFamily::kCarrierClearance, 1, "/min_carrier_clearance_rad"});
  all.push_back({"rotor_bore", ConstraintFamily::kRotorBore, 1, "/rotor_inner_diameter_mm"});
  if (train_of(problem).is_stepped()) {
    all.push_back({"tooth_difference", ConstraintFamily::kToothDifference, 0, ""});
  }
  all.push_back({"equal_spacing", ConstraintFamily::kEqualSpacing, 0, ""});
}

void add_clearances(const Problem& problem, Constraints& all) {
  const Train& train = train_of(problem);
  if (train.is_stepped()) {
    all.push_back({"identical_planets", ConstraintFamily::kIdenticalPlanets, 0, ""});
  }
  for (int layer = 1; layer <= train.layers(); ++layer) {
    all.push_back({"neighbour_clearance.layer_" + std::to_string(layer),
                   ConstraintFamily::kNeighbourClearance, layer, "/min_neighbour_clearance_mm"});
  }
  const std::vector<std::string>& gears = train_of(problem).free_gears;
  for (int gear = 0; gear < static_cast<int>(gears.size()); ++gear) {
    all.push_back({"undercut." + gears[static_cast<std::size_t>(gear)], ConstraintFamily::kUndercut,
                   gear, ""});
  }
  if (train.is_stepped() && problem.sun_under_second_layer) {
    all.push_back({"sun_under_layer_2", ConstraintFamily::kSunUnderLayer2, 0, ""});
  }
}

void add_for_rings(const Problem& problem, const std::string& prefix, ConstraintFamily family,
                   const std::string& key, Constraints& all) {
  int layer = 0;
  for (const std::string& ring : train_of(problem).rings) {
    all.push_back({prefix + ring, family, ++layer, key});
  }
}

void add_for_meshes(const Problem& problem, const std::string& prefix, ConstraintFamily family,
                    const std::string& key, bool internal_only, Constraints& all) {
  const std::vector<std::string>& meshes = train_of(problem).meshes;
  for (std::size_t mesh = internal_only ? 1 : 0; mesh < meshes.size(); ++mesh) {
    all.push_back({prefix + meshes[mesh], family, static_cast<int>(mesh), key});
  }
}

/// What is stated of the cutters and can fail.
void add_cutters(const Problem& problem, Constraints& all) {
  const StatedCutters& cutters = problem.cutters;
  if (cutters.hob_tip_radius || cutters.hob_addendum) {
    const bool rings_only = !cutters.hob_tip_radius || !cutters.hob_addendum;
    add_for_meshes(problem, "root_form.hob.", ConstraintFamily::kHobRootForm, "", rings_only, all);
  }
  if (cutters.shaper_teeth || (cutters.shaper_addendum && cutters.shaper_tip_radius)) {
    add_for_meshes(problem, "root_form.shaper.", ConstraintFamily::kShaperRootForm, "", true, all);
  }
  if (cutters.shaper_teeth) {
    add_for_meshes(problem, "shaper_feed.", ConstraintFamily::kShaperFeed, "", true, all);
  }
}

void add_buildable(const Problem& problem, Constraints& all) {
  add_clearances(problem, all);
  add_for_rings(
      problem, "ring_wall.", ConstraintFamily::kRingWall,
      problem.ring_outer_diameter_mm ? "/ring_outer_diameter_mm" : "/rotor_inner_diameter_mm", all);
  add_for_rings(problem, "ring_tip.", ConstraintFamily::kRingTip, "", all);
  add_for_meshes(problem, "interference.involute.", ConstraintFamily::kInvoluteInterference, "",
                 true, all);
  add_for_meshes(problem, "interference.trochoid.", ConstraintFamily::kTrochoidInterference, "",
                 true, all);
  add_for_meshes(problem, "contact_ratio.", ConstraintFamily::kContactRatio, "/min_contact_ratio",
                 false, all);
  add_cutters(problem, all);
}

void add_floors(const Problem& problem, Constraints& all) {
  for (std::size_t i = 0; i < kFloors.size(); ++i) {
    if (!(problem.floors.*kFloors[i].limit)) continue;
    all.push_back({std::string(kFloors[i].name), ConstraintFamily::kFloor, static_cast<int>(i),
                   std::string(kFloors[i].key)});
  }
}

}  // namespace

Constraints constraints_of(const Problem& problem) {
  Constraints all;
  add_paper(problem, all);
  if (problem.constraints != ConstraintSet::kPaper) add_buildable(problem, all);
  add_floors(problem, all);
  return all;
}

const Constraint* find_constraint(const Constraints& constraints, std::string_view name) {
  const auto found = std::find_if(constraints.begin(), constraints.end(),
                                  [&](const Constraint& each) { return each.name == name; });
  return found == constraints.end() ? nullptr : &*found;
}

}  // namespace torquewright::gearbox::proof
