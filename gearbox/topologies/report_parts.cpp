// SPDX-License-Identifier: Apache-2.0
#include "gearbox/topologies/report_parts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "gearbox/constraints/condition.hpp"
#include "gearbox/constraints/teeth.hpp"
#include "gearbox/teeth/tooth_geometry.hpp"
#include "gearbox/walls.hpp"

namespace torquewright::gearbox {

namespace {

constexpr double kMetresPerMillimetre = 1e-3;

}  // namespace

GearReport describe_gear(const std::string& name, std::int64_t teeth, const std::string& layer,
                         bool internal, const Rational& module_mm, const StatedCutters& cutters,
                         double speed_per_input) {
  const double sign = internal ? -1.0 : 1.0;
  const double module = io::nearest(module_mm);
  const auto count = static_cast<double>(teeth);
  const double root_depth = io::nearest(internal ? cutters.shaper_depth() : cutters.hob_depth());
  GearReport gear;
  gear.name = name;
  gear.teeth = teeth;
  gear.layer = layer;
  gear.internal = internal;
  gear.module_mm = module;
  gear.pitch_diameter_mm = module * count;
  gear.tip_diameter_mm = module * (count + sign * 2.0);
  gear.root_diameter_mm = module * (count - sign * 2.0 * root_depth);
  gear.base_diameter_mm = module * count * kReferenceCosine;
  gear.speed_per_input = speed_per_input;
  return gear;
}

double loss_per_friction(const ContactPath<double>& path, double curvature) {
  if (contact_ratio(path) < 1.0) return 0.0;
  return std::numbers::pi * curvature * sliding_loss_factor(path);
}

MeshReport describe_mesh(const std::string& name, const ContactPath<double>& path,
                         double loss_per_friction, const std::optional<Rational>& friction) {
  MeshReport mesh;
  mesh.name = name;
  mesh.contact_ratio = contact_ratio(path);
  mesh.approach_ratio = path.approach;
  mesh.recess_ratio = path.recess;
  mesh.efficiency = friction ? 1.0 - io::nearest(*friction) * loss_per_friction : 1.0;
  if (mesh.contact_ratio < 1.0 || mesh.efficiency < 0.0) mesh.efficiency = 0.0;
  return mesh;
}

void share_losses(const std::vector<double>& weights, const std::vector<double>& losses,
                  std::vector<MeshReport>& meshes) {
  const double sum = std::inner_product(weights.begin(), weights.end(), losses.begin(), 0.0);
  for (std::size_t mesh = 0; mesh < meshes.size(); ++mesh) {
    meshes[mesh].loss_share = sum > 0.0 ? weights[mesh] * losses[mesh] / sum : 0.0;
  }
}

void state_losses(const std::vector<double>& forward, const std::vector<double>& backward,
                  std::vector<MeshReport>& meshes) {
  const double sum = std::accumulate(forward.begin(), forward.end(), 0.0);
  for (std::size_t mesh = 0; mesh < meshes.size(); ++mesh) {
    meshes[mesh].forward_loss = forward[mesh];
    meshes[mesh].backward_loss = backward[mesh];
    if (sum > 0.0) meshes[mesh].loss_share = forward[mesh] / sum;
  }
}

void state_input_torques(const Problem& problem, DesignReport& report) {
  if (!report.input_torque_Nm || !problem.friction_coefficient) return;
  if (!(report.forward_efficiency > 0.0)) return;
  report.driving_torque_Nm = *report.input_torque_Nm / report.forward_efficiency;
  report.backdriven_torque_Nm = *report.input_torque_Nm * report.backward_efficiency;
}

void state_rotor(const Problem& problem, DesignReport& report) {
  if (problem.rotor_inertia_kg_m2 == 0 || report.ratio == 0) return;
  report.rotor_inertia_at_output_kg_m2 =
      io::nearest(report.ratio * report.ratio * problem.rotor_inertia_kg_m2);
}

namespace {

/// A module that the problem does not offer.
ConstraintReport foreign_module(const Problem& problem, const std::string& name,
                                const Rational& module_mm) {
  DesignCondition condition{name, "/module_mm", "mm"};
  condition.limit = problem.module_mm.front();
  std::string offered;
  for (const Rational& each_mm : problem.module_mm) {
    offered += (offered.empty() ? "" : ", ") + with_unit(each_mm, "mm");
  }
  ConstraintReport report = violated_without_value(
      condition, fmt::format("{}; the problem offers {}; needs one of these.",
                             with_unit(module_mm, "mm"), offered));
  report.value = io::nearest(module_mm);
  report.margin = -std::abs(report.value - report.limit);
  return report;
}

}  // namespace

std::vector<ConstraintReport> choices(const Problem& problem, const Design& design) {
  std::vector<ConstraintReport> list;
  const auto offers = [](const auto& offered, const auto& chosen) {
    return std::find(offered.begin(), offered.end(), chosen) != offered.end();
  };
  if (!offers(problem.planet_count, design.planet_count)) {
    DesignCondition condition{"planet_count", "/planet_count", "1"};
    condition.limit = Rational(problem.planet_count.front());
    list.push_back(violated_without_value(
        condition, fmt::format("{} planets; the problem offers {}; needs one of these.",
                               design.planet_count, fmt::join(problem.planet_count, ", "))));
    list.back().value = static_cast<double>(design.planet_count);
    list.back().margin = -std::abs(list.back().value - list.back().limit);
  }
  if (!offers(problem.module_mm, design.module_mm)) {
    list.push_back(foreign_module(problem, "module", design.module_mm));
  }
  if (design.layer_2_module_mm && !offers(problem.module_mm, *design.layer_2_module_mm)) {
    list.push_back(foreign_module(problem, "module.layer_2", *design.layer_2_module_mm));
  }
  return list;
}

double share_backlash(const std::vector<double>& coefficients, std::vector<MeshReport>& meshes) {
  const double sum = std::accumulate(coefficients.begin(), coefficients.end(), 0.0);
  for (std::size_t mesh = 0; mesh < meshes.size(); ++mesh) {
    meshes[mesh].backlash_share = coefficients[mesh] / sum;
  }
  return sum;
}

double hollow_shaft_mm(const Problem& problem, const Rational& module_mm, std::int64_t sun) {
  const Rational diameter_mm = module_mm * (Rational(sun) - 2 * problem.cutters.hob_depth()) -
                               2 * hollow_shaft_wall_mm(problem, module_mm);
  return io::nearest(diameter_mm);
}

std::optional<Blank> blank_of(const Problem& problem, const Rational& module_mm,
                              const std::vector<std::string>& layers) {
  if (!problem.density_kg_m3) return std::nullopt;
  std::vector<double> widths_m;
  for (const std::string& layer : layers) {
    const auto width = problem.face_width_mm.find(layer);
    if (width == problem.face_width_mm.end()) return std::nullopt;
    widths_m.push_back(io::nearest(width->second) * kMetresPerMillimetre);
  }
  Blank blank;
  blank.module_m = io::nearest(module_mm) * kMetresPerMillimetre;
  blank.density_kg_m3 = io::nearest(*problem.density_kg_m3);
  blank.face_width_1_m = widths_m[0];
  blank.face_width_2_m = widths_m.size() > 1 ? widths_m[1] : 0.0;
  blank.wall_m = io::nearest(ring_wall_mm(problem, module_mm)) * kMetresPerMillimetre;
  blank.hob_depth = io::nearest(problem.cutters.hob_depth());
  blank.shaper_depth = io::nearest(problem.cutters.shaper_depth());
  return blank;
}

void state_objective(const Problem& problem, double paper_cost, DesignReport& report) {
  const auto state = [&report](double value, const std::string& unit) {
    report.objective = value;
    report.objective_unit = unit;
  };
  switch (problem.objective) {
    case Objective::kPaperCost:
      return state(paper_cost, "1");
    case Objective::kMass:
      return state(report.mass_kg.value_or(0.0), "kg");
    case Objective::kHollowShaft:
      return state(report.hollow_shaft_diameter_mm, "mm");
    case Objective::kForwardEfficiency:
      return state(report.forward_efficiency, "1");
    case Objective::kBackwardEfficiency:
      return state(report.backward_efficiency, "1");
    case Objective::kReflectedInertia:
      return state(report.reflected_inertia_kg_m2.value_or(0.0), "kg m^2");
  }
}

}  // namespace torquewright::gearbox
