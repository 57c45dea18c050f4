// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "gearbox/search/design_spec.hpp"
#include "io/faults/refusal.hpp"
#include "io/files/atomic_file.hpp"
#include "src/commands/gearbox/body_sizes.hpp"
#include "src/commands/gearbox/design_drawing.hpp"
#include "src/commands/gearbox/gearbox_commands.hpp"
#include "src/options/output_files.hpp"
#include "src/report/gearbox/gearbox_drawing.hpp"
#include "src/report/workshop/gear_dxf.hpp"
#include "src/report/workshop/gear_step.hpp"
#include "src/standard_output.hpp"
#include "src/window_text.hpp"

namespace torquewright::cli {
namespace {

struct DrawingOptions {
  std::string result_file;
  std::int64_t design = 1;
  std::string svg_file;
  std::string dxf_file;
  std::string step_file;
  std::vector<double> face_width_mm;  // Of solids; empty: the result's.
  std::vector<std::string> bore;      // GEAR=MM
};

/// Solids of all gears as they stand when assembled.
std::string solids(const DrawingOptions& options, const report::DrawingLayout& layout,
                   const report::BodySizes& sizes) {
  try {
    return report::gear_step(report::gear_bodies(layout, sizes));
  } catch (const std::invalid_argument& error) {
    io::refuse(options.result_file, fmt::format("no solids for --step: {}", error.what()));
  }
}

/// What nobody stated.
std::string solids_text(const report::BodySizes& sizes) {
  const auto bored = [](double bore_mm) {
    return bore_mm > 0.0 ? fmt::format("has a bore of {:g} mm", bore_mm) : "has no bore";
  };
  const bool are_planets_bored = std::any_of(sizes.bore_mm.begin() + 1, sizes.bore_mm.end(),
                                             [](double bore_mm) { return bore_mm > 0.0; });
  return fmt::format("Solids: the sun {}, planets have {}{}.\n", bored(sizes.bore_mm.front()),
                     are_planets_bored ? "those stated" : "none (--bore)",
                     sizes.face_width_mm.size() > 1
                         ? fmt::format("; layer 2 begins at {:g} mm", sizes.face_width_mm.front())
                         : "");
}

ExitCode run_drawing(const DrawingOptions& options) {
  const io::Document result = io::read_document(options.result_file, "gearbox_result");
  const gearbox::ReadDesign read =
      gearbox::read_design(result, static_cast<std::size_t>(options.design));
  check_written(named({options.svg_file, options.dxf_file, options.step_file}),
                {options.result_file});
  require_svg("--svg", options.svg_file);
  report::DrawnGearbox drawn = drawn_gearbox(read.problem, read.design);
  const report::DrawingLayout layout = report::lay_out(drawn);
  const report::BodySizes sizes = body_sizes(
      {options.result_file, options.face_width_mm, options.bore, !options.step_file.empty()},
      read.face_width_mm, layout);
  if (!sizes.face_width_mm.empty()) drawn.face_width_mm = sizes.face_width_mm;
  const std::vector<report::GearData> data = report::gear_data(layout, sizes.face_width_mm);
  std::vector<io::FileContent> files;
  if (!options.svg_file.empty())
    files.push_back({options.svg_file, report::gearbox_drawing(drawn)});
  if (!options.dxf_file.empty())
    files.push_back({options.dxf_file, report::gear_dxf(layout, data)});
  if (!options.step_file.empty())
    files.push_back({options.step_file, solids(options, layout, sizes)});
  std::string text;
  for (const report::GearData& gear : data) {
    text += gear.gear + "\n";
    for (const auto& [what, value] : report::data_lines(gear)) {
      text += fmt::format("  {:<28} {}\n", what, value);
    }
  }
  text +=
      "Measures are of teeth without backlash (SDP/SI, Elements of Metric Gear Technology, 10).\n";
  if (!options.step_file.empty()) text += solids_text(sizes);
  deliver(std::move(files), for_window(text));
  return ExitCode::kPasses;
}

}  // namespace

void add_drawing_command(command_line::Command& gearbox) {
  auto options = std::make_shared<DrawingOptions>();
  command_line::Command command = gearbox.add_command(
      "drawing", "Write a design's files for the workshop, and list what is measured of its gears");
  command.add_option("result", options->result_file, "Document of kind gearbox_result").required();
  command.add_option("--design", options->design, "Which design of the result is drawn")
      .otherwise("1")
      .integer_between(1, 1'000'000);
  command.add_option("--dxf", options->dxf_file, "Write the outlines of all gears to this DXF file")
      .names_a_file();
  command
      .add_option("--step", options->step_file,
                  "Write the solids of all gears, as they stand in the train, to this STEP file")
      .names_a_file();
  command
      .add_option("--face-width", options->face_width_mm,
                  "Face width of the gears, in mm, by layer: 10,8")
      .otherwise("the result's")
      .separated_by_commas()
      .between(0.05, 1000.0);
  command
      .add_option("--bore", options->bore,
                  "Bore of a gear's solid, in mm: planet_1=5,planet_2=5; 0 is none")
      .otherwise("the sun has the hollow shaft's, planets have none")
      .needs("--step")
      .separated_by_commas()
      .one_value_each();
  command.add_option("--svg", options->svg_file, "Write the drawing sheet to this SVG file")
      .names_a_file();
  command.example(
      "torquewright gearbox drawing specs/gearbox/d151_knee_result.json --dxf gears.dxf --step "
      "gears.step --face-width 10,9");
  command.works([options] { return run_drawing(*options); });
}

}  // namespace torquewright::cli
