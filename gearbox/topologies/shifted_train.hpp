// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearbox/constraints/design_report.hpp"
#include "gearbox/train/cut_train.hpp"

namespace torquewright::gearbox {

// Parts of a report that profile shift or a second module changes, of all topologies. Without both
// they are those of report_parts.hpp.

/// The gears of a shifted design; nothing for a plain one. Throws std::invalid_argument where sun
/// and planet have no working angle: shift_objection() says so before.
std::optional<CutTrain> cut_of(const Problem& problem, const Design& design);

/// Why a shifted design cannot be evaluated at all; a sentence, empty: it can.
std::string shift_objection(const Problem& problem, const Design& design);

/// Diameters of all gears; `speeds` over the sun's, in their order.
std::vector<GearReport> describe_gears(const CutTrain& cut, const std::vector<double>& speeds);

/// Paths of contact by mesh, zeros where there is none.
std::vector<ContactPath<double>> contact_paths(const CutTrain& cut);

/// Sets the centre distance and every mesh's working angle, once the meshes are there.
void state_working_angles(const CutTrain& cut, DesignReport& report);

/// Base radius of a gear [mm].
double base_radius_mm(const CutGear& gear);

/// Hollow shaft, ring blank, mass and inertia: gears are as large as their shifted reference
/// profile, z + 2 x.
void describe_shifted_bodies(const Problem& problem, const CutTrain& cut, DesignReport& report);

/// What a buildable train asks for beyond equations (2)...(9), and what no train can miss.
/// identical_planets is not among them: shift does not change it.
std::vector<ConstraintReport> shifted_conditions(const Problem& problem, const CutTrain& cut);

/// Whether every mesh of a ring has the centre distance of the sun's, a constraint each.
std::vector<ConstraintReport> shifted_coaxiality(const CutTrain& cut);

}  // namespace torquewright::gearbox
