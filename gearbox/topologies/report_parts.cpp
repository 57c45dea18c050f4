// SPDX-License-Identifier: Apache-2.0
#include "gearbox/topologies/report_parts.hpp"

#include <cmath>
#include <numbers>
#include <numeric>

#include "gearbox/constraints/teeth.hpp"
#include "gearbox/tooth_geometry.hpp"

namespace torquewright::gearbox {

namespace {

constexpr double kMetresPerMillimetre = 1e-3;

}  // namespace

GearReport describe_gear(const std::string& name, std::int64_t teeth, const std::string& layer,
                         bool internal, const Rational& module_mm, double speed_per_input) {
  const double sign = internal ? -1.0 : 1.0;
  const double module = module_mm.get_d();
  const auto count = static_cast<double>(teeth);
  GearReport gear;
  gear.name = name;
  gear.teeth = teeth;
  gear.layer = layer;
  gear.internal = internal;
  gear.pitch_diameter_mm = module * count;
  gear.tip_diameter_mm = module * (count + sign * 2.0);
  gear.root_diameter_mm = module * (count - sign * 2.0 * kDedendum);
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
  mesh.efficiency = friction ? 1.0 - friction->get_d() * loss_per_friction : 1.0;
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

double share_backlash(const std::vector<double>& coefficients, std::vector<MeshReport>& meshes) {
  const double sum = std::accumulate(coefficients.begin(), coefficients.end(), 0.0);
  for (std::size_t mesh = 0; mesh < meshes.size(); ++mesh) {
    meshes[mesh].backlash_share = coefficients[mesh] / sum;
  }
  return sum;
}

double hollow_shaft_mm(const Problem& problem, const Rational& module_mm, std::int64_t sun) {
  const Rational diameter_mm =
      module_mm * (Rational(sun) - Rational(5, 2)) - 2 * problem.hollow_shaft_wall_mm;
  return diameter_mm.get_d();
}

double ring_blank_mm(const Problem& problem, const Rational& module_mm, std::int64_t ring) {
  const Rational diameter_mm =
      module_mm * (Rational(ring) + Rational(5, 2)) + 2 * ring_wall_mm(problem, module_mm);
  return diameter_mm.get_d();
}

std::optional<Blank> blank_of(const Problem& problem, const Rational& module_mm,
                              const std::vector<std::string>& layers) {
  if (!problem.density_kg_m3) return std::nullopt;
  std::vector<double> widths_m;
  for (const std::string& layer : layers) {
    const auto width = problem.face_width_mm.find(layer);
    if (width == problem.face_width_mm.end()) return std::nullopt;
    widths_m.push_back(width->second.get_d() * kMetresPerMillimetre);
  }
  Blank blank;
  blank.module_m = module_mm.get_d() * kMetresPerMillimetre;
  blank.density_kg_m3 = problem.density_kg_m3->get_d();
  blank.face_width_1_m = widths_m[0];
  blank.face_width_2_m = widths_m.size() > 1 ? widths_m[1] : 0.0;
  blank.wall_m = ring_wall_mm(problem, module_mm).get_d() * kMetresPerMillimetre;
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
