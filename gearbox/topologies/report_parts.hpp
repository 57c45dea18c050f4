// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearbox/constraints/design_report.hpp"
#include "gearbox/teeth/mesh.hpp"
#include "gearbox/teeth/shifted_mesh.hpp"
#include "gearbox/train/mass.hpp"

namespace torquewright::gearbox {

// Parts of a report that all topologies share; profile shift is shifted_train.hpp's matter.

/// Describes a gear: its diameters in mm, and its speed per input speed.
GearReport describe_gear(const std::string& name, std::int64_t teeth, const std::string& layer,
                         bool internal, const Rational& module_mm, const StatedCutters& cutters,
                         double speed_per_input);

/// Contact ratios and basic efficiency of a mesh, given its loss per unit of friction. A contact
/// ratio below 1 does not run: efficiency 0.
MeshReport describe_mesh(const std::string& name, const ContactPath<double>& path,
                         double loss_per_friction, const std::optional<Rational>& friction);

/// Loss of a mesh per unit of friction coefficient; 0 where its contact ratio is below 1.
/// curvature: 1/z1 + 1/z2, or the difference for a ring.
double loss_per_friction(const ContactPath<double>& path, double curvature);

/// Sets every loss_share to weight times loss over their sum.
void share_losses(const std::vector<double>& weights, const std::vector<double>& losses,
                  std::vector<MeshReport>& meshes);

/// Sets losses of both directions, and every loss_share to the forward loss over its sum. Where
/// nothing is lost, the shares are those to first order, weight times loss per friction.
void state_losses(const std::vector<double>& forward, const std::vector<double>& backward,
                  std::vector<MeshReport>& meshes);

/// Torques at the sun with losses, once ratio, load and efficiencies are known.
void state_input_torques(const Problem& problem, DesignReport& report);

/// What depends on the motor alone: its inertia seen from the output.
void state_rotor(const Problem& problem, DesignReport& report);

/// Planet count and module where the problem does not offer this choice.
std::vector<ConstraintReport> choices(const Problem& problem, const Design& design);

/// Sets every backlash_share and returns the sum of the coefficients.
double share_backlash(const std::vector<double>& coefficients, std::vector<MeshReport>& meshes);

/// The hollow shaft's diameter m (S - 2 h) - 2 wall [mm]; negative where none fits.
double hollow_shaft_mm(const Problem& problem, const Rational& module_mm, std::int64_t sun);

/// Face widths and density as the mass formulas need them; nothing where the problem lacks one.
std::optional<Blank> blank_of(const Problem& problem, const Rational& module_mm,
                              const std::vector<std::string>& layers);

/// Sets objective and objective_unit from the report's own fields; paper_cost is the value of
/// equation (1), where the topology has it.
void state_objective(const Problem& problem, double paper_cost, DesignReport& report);

/// Remarks on held-ring phasing, gears that share divisors, unequal spacing and the ring's blank.
std::vector<Remark> common_remarks(const Problem& problem, const DesignReport& report,
                                   std::int64_t sun, std::int64_t held_ring);

/// How the planets' meshes with a ring follow each other, for equally spaced planets.
Remark phasing_remark(const std::string& ring_name, std::int64_t ring, std::int64_t planet_count);

/// A remark whether the planet could be pushed into its ring radially.
Remark trimming_remark(const std::string& mesh, std::int64_t planet, std::int64_t ring);
/// The same of gears as they are cut; nothing: they do not mesh.
Remark trimming_remark(const std::string& mesh, const std::optional<CutPair>& cut);

/// A remark on two gears in mesh whose counts have a common divisor; nothing if they have none.
std::optional<Remark> hunting_remark(const std::string& mesh, std::int64_t teeth_1,
                                     std::int64_t teeth_2);

}  // namespace torquewright::gearbox
