// SPDX-License-Identifier: Apache-2.0
#include "src/report/workshop/gear_step.hpp"

#include <fmt/format.h>

#include <vector>

#include "src/report/workshop/step_colours.hpp"
#include "src/report/workshop/step_file.hpp"
#include "src/report/workshop/step_solid.hpp"

namespace torquewright::report {
namespace {

/// What all products of a file share.
struct Contexts {
  StepId product;
  StepId definition;
  StepId geometry;
};

/// A product with its definition and its shape.
struct Product {
  StepId definition;
  StepId shape;
};

StepId add_units(StepFile& file) {
  const StepId length = file.add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))");
  const StepId angle = file.add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))");
  const StepId solid_angle = file.add("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())");
  const StepId accuracy =
      file.add(fmt::format("UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-06),{},"
                           "'distance_accuracy_value','confusion accuracy')",
                           step_reference(length)));
  return file.add(
      fmt::format("(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT(({}))"
                  "GLOBAL_UNIT_ASSIGNED_CONTEXT({})REPRESENTATION_CONTEXT('','3D'))",
                  step_reference(accuracy), step_list({length, angle, solid_angle})));
}

Contexts add_contexts(StepFile& file) {
  const StepId application =
      file.add("APPLICATION_CONTEXT('core data for automotive mechanical design processes')");
  file.add(fmt::format(
      "APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,{})",
      step_reference(application)));
  Contexts contexts;
  contexts.product =
      file.add(fmt::format("PRODUCT_CONTEXT('',{},'mechanical')", step_reference(application)));
  contexts.definition = file.add(fmt::format(
      "PRODUCT_DEFINITION_CONTEXT('part definition',{},'design')", step_reference(application)));
  contexts.geometry = add_units(file);
  return contexts;
}

/// `shape` is a representation.
Product add_product(StepFile& file, const Contexts& contexts, const std::string& name,
                    StepId shape) {
  const std::string quoted = step_string(name);
  const StepId product =
      file.add(fmt::format("PRODUCT({0},{0},'',({1}))", quoted, step_reference(contexts.product)));
  file.add(fmt::format("PRODUCT_RELATED_PRODUCT_CATEGORY('part',$,({}))", step_reference(product)));
  const StepId formation =
      file.add(fmt::format("PRODUCT_DEFINITION_FORMATION('','',{})", step_reference(product)));
  const StepId definition =
      file.add(fmt::format("PRODUCT_DEFINITION('design','',{},{})", step_reference(formation),
                           step_reference(contexts.definition)));
  const StepId whole =
      file.add(fmt::format("PRODUCT_DEFINITION_SHAPE('','',{})", step_reference(definition)));
  file.add(fmt::format("SHAPE_DEFINITION_REPRESENTATION({},{})", step_reference(whole),
                       step_reference(shape)));
  return {definition, shape};
}

Product add_gear(StepFile& file, const Contexts& contexts, const StepFrame& frame,
                 const GearBody& body, std::vector<ColouredSolid>& solids) {
  const StepId solid = add_solid(file, frame, body);
  solids.push_back({solid, body.shape});
  const StepId shape =
      file.add(fmt::format("ADVANCED_BREP_SHAPE_REPRESENTATION({},{},{})", step_string(body.name),
                           step_list({frame.placement, solid}), step_reference(contexts.geometry)));
  return add_product(file, contexts, body.name, shape);
}

/// The gear's own axes are moved to `placement`.
void add_occurrence(StepFile& file, const StepFrame& frame, const Product& whole,
                    const Product& gear, const std::string& name, StepId placement) {
  const StepId occurrence = file.add(
      fmt::format("NEXT_ASSEMBLY_USAGE_OCCURRENCE({0},{0},'',{1},{2},$)", step_string(name),
                  step_reference(whole.definition), step_reference(gear.definition)));
  const StepId shape =
      file.add(fmt::format("PRODUCT_DEFINITION_SHAPE('','',{})", step_reference(occurrence)));
  const StepId transformation =
      file.add(fmt::format("ITEM_DEFINED_TRANSFORMATION('','',{},{})",
                           step_reference(frame.placement), step_reference(placement)));
  const StepId relation = file.add(fmt::format(
      "(REPRESENTATION_RELATIONSHIP('','',{},{})"
      "REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION({})SHAPE_REPRESENTATION_RELATIONSHIP())",
      step_reference(gear.shape), step_reference(whole.shape), step_reference(transformation)));
  file.add(fmt::format("CONTEXT_DEPENDENT_SHAPE_REPRESENTATION({},{})", step_reference(relation),
                       step_reference(shape)));
}

}  // namespace

std::string gear_step(const GearBodies& bodies) {
  StepFile file(bodies.name);
  const Contexts contexts = add_contexts(file);
  const StepFrame frame = add_frame(file);
  std::vector<Product> gears;
  std::vector<ColouredSolid> solids;
  for (const GearBody& body : bodies.bodies) {
    gears.push_back(add_gear(file, contexts, frame, body, solids));
  }
  add_colours(file, contexts.geometry, solids);
  const StepFrame assembly = add_frame(file);
  std::vector<StepId> placements{assembly.placement};
  for (const PlacedBody& placed : bodies.placed) {
    placements.push_back(
        add_placement(file, assembly, placed.middle, placed.from_mm, placed.turn_rad));
  }
  const StepId shape =
      file.add(fmt::format("SHAPE_REPRESENTATION({},{},{})", step_string(bodies.name),
                           step_list(placements), step_reference(contexts.geometry)));
  const Product whole = add_product(file, contexts, bodies.name, shape);
  for (std::size_t i = 0; i < bodies.placed.size(); ++i) {
    const PlacedBody& placed = bodies.placed[i];
    add_occurrence(file, frame, whole, gears[placed.body], placed.name, placements[i + 1]);
  }
  return file.finished();
}

}  // namespace torquewright::report
