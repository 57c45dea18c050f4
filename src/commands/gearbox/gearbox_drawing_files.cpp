// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "gearbox/search/design_spec.hpp"
#include "io/files/atomic_file.hpp"
#include "src/commands/gearbox/design_drawing.hpp"
#include "src/commands/gearbox/gearbox_commands.hpp"
#include "src/options/output_files.hpp"
#include "src/report/gearbox/gearbox_drawing.hpp"
#include "src/report/workshop/gear_dxf.hpp"
#include "src/standard_output.hpp"
#include "src/window_text.hpp"

namespace torquewright::cli {
namespace {

struct DrawingOptions {
  std::string result_file;
  std::int64_t design = 1;
  std::string svg_file;
  std::string dxf_file;
};

ExitCode run_drawing(const DrawingOptions& options) {
  const io::Document result = io::read_document(options.result_file, "gearbox_result");
  const gearbox::ReadDesign read =
      gearbox::read_design(result, static_cast<std::size_t>(options.design));
  check_written(named({options.svg_file, options.dxf_file}), {options.result_file});
  require_svg("--svg", options.svg_file);
  const report::DrawnGearbox drawn = drawn_gearbox(read.problem, read.design);
  const report::DrawingLayout layout = report::lay_out(drawn);
  const std::vector<report::GearData> data = report::gear_data(layout, read.face_width_mm);
  std::vector<io::FileContent> files;
  if (!options.svg_file.empty())
    files.push_back({options.svg_file, report::gearbox_drawing(drawn)});
  if (!options.dxf_file.empty())
    files.push_back({options.dxf_file, report::gear_dxf(layout, data)});
  std::string text;
  for (const report::GearData& gear : data) {
    text += gear.gear + "\n";
    for (const auto& [what, value] : report::data_lines(gear)) {
      text += fmt::format("  {:<28} {}\n", what, value);
    }
  }
  text +=
      "Measures are of teeth without backlash (SDP/SI, Elements of Metric Gear Technology, 10).\n";
  deliver(std::move(files), for_window(text));
  return ExitCode::kPasses;
}

}  // namespace

void add_drawing_command(command_line::Command& gearbox) {
  auto options = std::make_shared<DrawingOptions>();
  command_line::Command command = gearbox.add_command(
      "drawing", "The workshop's files of a design, and what is measured of it");
  command.add_option("result", options->result_file, "Document of kind gearbox_result").required();
  command.add_option("--design", options->design, "Which of its designs")
      .otherwise("1")
      .integer_between(1, 1'000'000);
  command.add_option("--dxf", options->dxf_file, "Write the outlines of all gears to this DXF file")
      .names_a_file();
  command.add_option("--svg", options->svg_file, "Write the drawing sheet to this SVG file")
      .names_a_file();
  command.example(
      "torquewright gearbox drawing specs/gearbox/d151_knee_result.json --dxf gears.dxf");
  command.works([options] { return run_drawing(*options); });
}

}  // namespace torquewright::cli
