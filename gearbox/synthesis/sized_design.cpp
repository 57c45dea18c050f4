// SPDX-License-Identifier: Apache-2.0
#include "gearbox/synthesis/sized_design.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "gearbox/constraints/condition.hpp"
#include "gearbox/strength/mesh_stiffness.hpp"
#include "gearbox/strength/problem_strength.hpp"
#include "gearbox/strength/tooth_load.hpp"
#include "gearbox/synthesis/stiff_widths.hpp"
#include "gearbox/teeth/profile_shift.hpp"
#include "gearbox/teeth/tooth_geometry.hpp"
#include "gearbox/topologies/topology.hpp"
#include "gearbox/train/cut_train.hpp"
#include "gearbox/train_parts.hpp"

namespace torquewright::gearbox {
namespace {

constexpr const char* kDoNotMesh = "gears_do_not_mesh";

/// Shifts of sun and planets from the point; those of the rings close the centre distance.
bool set_shifts(const Problem& problem, const std::array<double, 3>& point, Design& design) {
  const double between = static_cast<double>(design.teeth[0] + design.teeth[1]);
  const auto angle = working_angle_at_rad(between, point[0] / io::nearest(design.module_mm));
  if (!angle) return false;
  const double shifts =
      between * (involute(*angle) - kReferenceInvolute) / (2.0 * kReferenceTangent);
  const TrainParts& parts = train_parts(problem.topology);
  design.profile_shift.assign(parts.gears.size(), 0.0);
  design.profile_shift[0] = shifts - point[1];
  for (std::size_t layer = 0; layer < parts.layer_count(); ++layer) {
    design.profile_shift[TrainParts::planet_of_layer(layer)] = point[1 + layer];
  }
  const GearTrain open = gear_train(problem, design);
  const auto cut = cut_train(open);
  if (!cut) return false;
  for (const CutMesh& mesh : cut->meshes) {
    if (!cut->gears[mesh.gear_2].internal) continue;
    if (!mesh.closing_ring_shift) return false;
    design.profile_shift[mesh.gear_2] = *mesh.closing_ring_shift;
  }
  return true;
}

/// What the load asks of each layer's width: bending goes with 1/b, pressure with its root.
std::array<double, 2> needed_widths_mm(const StrengthCase& of_one_mm, double sun_Nm) {
  std::array<double, 2> widths{};
  const TrainParts& parts = train_parts(of_one_mm.train.topology);
  for (const ToothLoad& load : tooth_loads(of_one_mm, sun_Nm)) {
    const auto mesh = std::find_if(parts.meshes.begin(), parts.meshes.end(),
                                   [&](const MeshedGears& each) { return each.name == load.mesh; });
    double& width = widths[parts.gear_layers[mesh->gear_2]];
    const double flank = of_one_mm.demanded_flank_safety / load.flank.least_safety();
    width =
        std::max({width, of_one_mm.demanded_root_safety / load.root.least_safety(), flank * flank});
  }
  return widths;
}

/// Up to a whole nanometre, as a decimal.
Rational rounded_up_mm(double width_mm) {
  return Rational(mpz_class(std::ceil(width_mm * (1.0 + 1e-12) * 1e6)), 1000000);
}

/// The name of what a design violates that `evaluate` does not know of.
std::string own_objection(const SizedDesign& sized) {
  const SynthesisRequest& request = *sized.problem.synthesis;
  for (std::size_t i = 0; i < train_parts(sized.problem.topology).free_gears; ++i) {
    const double shift = sized.design.profile_shift[i];
    if (shift < io::nearest(request.least_shift) - 1e-9 ||
        shift > io::nearest(request.greatest_shift) + 1e-9) {
      return "profile_shift";
    }
  }
  for (const ConstraintReport& constraint : sized.report.constraints) {
    if (!constraint.name.starts_with("tip_thickness.")) continue;
    const auto gear = std::find_if(
        sized.report.gears.begin(), sized.report.gears.end(),
        [&](const GearReport& each) { return constraint.name.ends_with("." + each.name); });
    if (constraint.value < io::nearest(request.least_tip_thickness) * gear->module_mm - 1e-9) {
      return constraint.name;
    }
  }
  const auto& [first, second] = sized.face_width_mm;
  const auto widest_mm = greatest_face_widths_mm(sized.problem, sized.design);
  const std::size_t layers = train_parts(sized.problem.topology).layer_count();
  const bool is_second_wide = layers > 1 && second > io::nearest(widest_mm[1]);
  if (first > io::nearest(widest_mm[0]) || is_second_wide) return "face_width";
  return "";
}

/// The floor of what the teeth bear.
ConstraintReport torque_borne(const SizedDesign& sized) {
  DesignCondition condition{"torque_borne", "/synthesis/min_torque_borne_Nm", "Nm"};
  condition.value = io::exact(sized.borne.joint_Nm);
  condition.limit = *sized.problem.floors.torque_borne_Nm;
  condition.meaning = "at the output that the teeth bear for the load's cycles";
  return judge(condition);
}

/// The floor of what the teeth give way.
ConstraintReport stiffness(const SizedDesign& sized) {
  DesignCondition condition{"stiffness", "/synthesis/min_stiffness_Nm_rad", "Nm/rad"};
  condition.value = io::exact(sized.stiffness_Nm_rad);
  condition.limit = *sized.problem.floors.stiffness_Nm_rad;
  condition.meaning = "of torsional stiffness of the teeth at the output";
  return judge(condition);
}

/// Mass of a millimetre of each layer: that of all gears is linear in the widths.
std::array<double, 2> kg_per_mm(const SizedDesign& sized) {
  const std::vector<std::string> layers = train_parts(sized.problem.topology).layer_names();
  Problem of_widths = sized.problem;
  const auto mass_kg = [&](int first_mm) {
    for (const std::string& layer : layers) of_widths.face_width_mm[layer] = 1;
    of_widths.face_width_mm[layers[0]] = first_mm;
    const Topology& topology = *find_topology(of_widths.topology);
    return topology.evaluate(of_widths, sized.design).mass_kg.value_or(0.0);
  };
  const double at_one_kg = mass_kg(1);
  const double first = mass_kg(2) - at_one_kg;
  return {first, layers.size() > 1 ? at_one_kg - first : 0.0};
}

/// What stiffness makes of the widths that the load asks for; where the widest are too soft, they
/// stay.
void widen_for_stiffness(const SizedDesign& sized, const StrengthCase& of_one_mm,
                         std::array<double, 2>& needed_mm) {
  const Floors& floors = sized.problem.floors;
  if (!floors.stiffness_Nm_rad) return;
  const std::vector<double> softness = layer_softness_rad_mm_Nm(of_one_mm);
  const std::array<double, 2> share = kg_per_mm(sized);
  const auto widest_mm = greatest_face_widths_mm(sized.problem, sized.design);
  const double least_mm = io::nearest(sized.problem.synthesis->least_face_width_mm);
  std::array<LayerWidth, 2> layers;
  for (std::size_t i = 0; i < softness.size(); ++i) {
    layers[i] = {std::max(needed_mm[i], least_mm), io::nearest(widest_mm[i]), softness[i],
                 share[i]};
  }
  const auto& longest_mm = floors.axial_length_mm;
  const auto stiff_mm = stiff_widths_within_mm(
      layers, 1.0 / io::nearest(*floors.stiffness_Nm_rad),
      longest_mm ? io::nearest(*longest_mm) : std::numeric_limits<double>::infinity());
  if (stiff_mm) needed_mm = *stiff_mm;
}

void offer_all_modules(const LayerModules& modules, Problem& problem) {
  std::vector<Rational>& offered = problem.module_mm;
  offered.insert(offered.end(), modules.second_mm.begin(), modules.second_mm.end());
  std::sort(offered.begin(), offered.end());
  offered.erase(std::unique(offered.begin(), offered.end()), offered.end());
}

bool set_widths(SizedDesign& sized) {
  const std::vector<std::string> layers = train_parts(sized.problem.topology).layer_names();
  for (const std::string& layer : layers) sized.problem.face_width_mm[layer] = 1;
  const auto of_one_mm = strength_of_design(sized.problem, sized.design);
  if (!of_one_mm) return false;
  const double load_Nm = io::nearest(torque_to_bear_Nm(sized.problem));
  auto needed =
      needed_widths_mm(*of_one_mm, sun_torque_Nm(of_one_mm->train, load_Nm, TorqueSide::kJoint));
  widen_for_stiffness(sized, *of_one_mm, needed);
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const Rational width_mm =
        std::max(rounded_up_mm(needed[i]), sized.problem.synthesis->least_face_width_mm);
    sized.problem.face_width_mm[layers[i]] = width_mm;
    sized.face_width_mm[i] = io::nearest(width_mm);
  }
  const auto strength = strength_of_design(sized.problem, sized.design);
  if (!strength) return false;
  sized.borne = torque_limits(*strength).for_cycles;
  sized.stiffness_Nm_rad = torsional_stiffness_Nm_rad(*strength);
  return true;
}

}  // namespace

SizedDesign sized_design(const Problem& problem, const Design& shifted) {
  SizedDesign sized;
  sized.design = shifted;
  sized.problem = problem;
  offer_all_modules(layer_modules(problem), sized.problem);
  if (!set_widths(sized)) {
    sized.objection = kDoNotMesh;
    return sized;
  }
  sized.report = find_topology(problem.topology)->evaluate(sized.problem, sized.design);
  if (problem.floors.torque_borne_Nm) sized.report.constraints.push_back(torque_borne(sized));
  if (problem.floors.stiffness_Nm_rad) sized.report.constraints.push_back(stiffness(sized));
  sized.mass_kg = sized.report.mass_kg.value_or(0.0);
  for (const ConstraintReport& constraint : sized.report.constraints) {
    if (constraint.satisfied) continue;
    sized.objection = constraint.name;
    return sized;
  }
  sized.objection = own_objection(sized);
  if (sized.objection.empty() && sized.borne.joint_Nm < io::nearest(torque_to_bear_Nm(problem))) {
    sized.objection = "strength";
  }
  return sized;
}

SizedDesign sized_design(const Problem& problem, const LayerModules& modules,
                         const TrainChoice& choice, const std::array<double, 3>& point) {
  Design design = design_of(train_parts(problem.topology), modules, choice);
  if (set_shifts(problem, point, design)) return sized_design(problem, design);
  SizedDesign none;
  none.design = std::move(design);
  none.problem = problem;
  none.objection = kDoNotMesh;
  return none;
}

}  // namespace torquewright::gearbox
