// SPDX-License-Identifier: Apache-2.0
#include "src/report/workshop/step_colours.hpp"

#include <fmt/format.h>

#include <map>
#include <string_view>

namespace torquewright::report {
namespace {

/// Red, green and blue as the sheet has them (drawing_sheet.cpp).
const std::map<std::string, unsigned, std::less<>> kColours{{"sun", 0xf5d58a},
                                                            {"planet_1", 0xa9cce3},
                                                            {"planet_2", 0xaed9bd},
                                                            {"fixed_ring", 0xccd1d1},
                                                            {"output_ring", 0xe5c1b0}};

std::string share_of(unsigned colour, unsigned shift) {
  return step_number((colour >> shift & 0xFFU) / 255.0);
}

/// Adds an entity of one reference: "KIND('',(#12))".
StepId add_around(StepFile& file, std::string_view entity, StepId inner) {
  return file.add(fmt::format(fmt::runtime(entity), step_reference(inner)));
}

StepId add_style(StepFile& file, unsigned colour) {
  const StepId rgb = file.add(fmt::format("COLOUR_RGB('',{},{},{})", share_of(colour, 16),
                                          share_of(colour, 8), share_of(colour, 0)));
  StepId style = add_around(file, "FILL_AREA_STYLE_COLOUR('',{})", rgb);
  for (const std::string_view around :
       {"FILL_AREA_STYLE('',({}))", "SURFACE_STYLE_FILL_AREA({})", "SURFACE_SIDE_STYLE('',({}))",
        "SURFACE_STYLE_USAGE(.BOTH.,{})", "PRESENTATION_STYLE_ASSIGNMENT(({}))"}) {
    style = add_around(file, around, style);
  }
  return style;
}

}  // namespace

void add_colours(StepFile& file, StepId geometry, const std::vector<ColouredSolid>& solids) {
  std::vector<StepId> styled;
  for (const ColouredSolid& coloured : solids) {
    const auto colour = kColours.find(coloured.shape);
    if (colour == kColours.end()) continue;
    styled.push_back(file.add(fmt::format("STYLED_ITEM('',({}),{})",
                                          step_reference(add_style(file, colour->second)),
                                          step_reference(coloured.solid))));
  }
  file.add(fmt::format("MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION('',{},{})",
                       step_list(styled), step_reference(geometry)));
}

}  // namespace torquewright::report
