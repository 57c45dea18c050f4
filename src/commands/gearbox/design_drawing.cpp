// SPDX-License-Identifier: Apache-2.0
#include "src/commands/gearbox/design_drawing.hpp"

#include "gearbox/constraints/existence.hpp"
#include "gearbox/topologies/topology.hpp"
#include "src/report/gearbox/gearbox_drawing.hpp"

namespace torquewright::cli {

report::DrawnGearbox drawn_gearbox(const gearbox::Problem& problem, const gearbox::Design& design) {
  const gearbox::DesignReport report =
      gearbox::find_topology(problem.topology)->evaluate(problem, design);
  report::DrawnGearbox drawing;
  drawing.name = problem.name;
  drawing.topology = problem.topology;
  drawing.teeth = report.design.teeth;
  drawing.planet_count = design.planet_count;
  drawing.module_mm = io::nearest(design.module_mm);
  drawing.ratio = report.ratio.get_str();
  drawing.hollow_shaft_diameter_mm = report.hollow_shaft_diameter_mm;
  if (problem.ring_wall_mm) drawing.ring_wall_mm = io::nearest(*problem.ring_wall_mm);
  drawing.profile_shift = report.design.profile_shift;
  if (design.layer_2_module_mm) {
    drawing.layer_2_module_mm = io::nearest(*design.layer_2_module_mm);
  }
  for (const auto& [layer, width_mm] : problem.face_width_mm) {
    drawing.face_width_mm.push_back(io::nearest(width_mm));
  }
  const gearbox::GearTrain train = gearbox::gear_train(problem, report.design);
  drawing.cutters = train.cutters;
  for (const gearbox::ConstraintReport& violated : gearbox::what_cannot_exist(train)) {
    drawing.cannot_exist.push_back(violated.name);
  }
  return drawing;
}

std::string drawing_of(const gearbox::Problem& problem, const gearbox::Design& design) {
  return report::gearbox_drawing(drawn_gearbox(problem, design));
}

}  // namespace torquewright::cli
