// SPDX-License-Identifier: Apache-2.0
#include "src/options/mor_request.hpp"

#include <fmt/format.h>

#include "actuator/exporters/library.hpp"
#include "io/faults/refusal.hpp"
#include "src/options/needs.hpp"
#include "src/options/output_files.hpp"

namespace torquewright::cli {
namespace {

/// What `actuator mor --format` takes: csv, json and the name of every exporter.
std::vector<std::string> mor_formats() {
  std::vector<std::string> names{"csv", "json"};
  for (const actuator::Exporter* exporter : actuator::exporter_library()) {
    names.emplace_back(exporter->name);
  }
  return names;
}

/// Questions that no table, file or picture of the region answers: each is asked without those.
void add_questions(command_line::Command& command, MorRequest& request) {
  command_line::Option need =
      command
          .add_option(
              "--need", request.need,
              "TORQUE@SPEED in Nm and rad/s, or with units, 100@95rpm: say whether it is reached, "
              "and if not, what would do; --plot draws it into the region")
          .otherwise("not asked");
  add_lever(command, request.lever_m);
  command_line::Option ratio =
      command
          .add_option("--ratio", request.ratios,
                      "LOW:HIGH: show what these gear ratios would make of the motor")
          .otherwise("not asked");
  command_line::Option compare = command
                                     .add_option("--compare", request.compare_file,
                                                 "Document of kind actuator: show where this one's "
                                                 "region loses and wins torque against it")
                                     .otherwise("not compared");
  compare.excludes("--need").excludes("--ratio");
  compare.excludes("--plot-voltage").excludes("--plot-temperature");
  for (command_line::Option* question : {&need, &ratio, &compare}) {
    for (const char* other : {"--format", "--table", "--at-speed", "--accuracy"})
      question->excludes(other);
  }
  need.excludes("--side");
  ratio.excludes("--plot").excludes("--side");
}

void add_mor_plot_options(command_line::Command& command, MorPlotOptions& options) {
  command
      .add_option("--plot", options.file,
                  "Draw the region to this SVG or PNG; the rows too only with --format, "
                  "--json, --at-speed or -o")
      .names_a_file();
  command
      .add_option("--plot-voltage", options.voltages_V,
                  "Draw the region at these bus voltages too, in V")
      .otherwise("none")
      .separated_by_commas()
      .between(0.5, 2000.0)
      .needs("--plot");
  command
      .add_option("--plot-temperature", options.temperatures_K,
                  "Draw the region at these winding temperatures too, in K")
      .otherwise("none")
      .separated_by_commas()
      .between(200.0, 600.0)
      .needs("--plot");
}

}  // namespace

void add_mor_options(command_line::Command& command, MorRequest& request) {
  command.add_option("actuator", request.actuator_file, "Document of kind actuator").required();
  add_operating_options(command, request.operating);
  command
      .add_option(
          "--side", request.side,
          "Where torque and speed are taken: joint, or motor (at the rotor, before friction)")
      .one_of({"joint", "motor"});
  command.add_option("--format,--for", request.format, "Write csv, json or a simulator's file")
      .otherwise("the region on one screen")
      .one_of(mor_formats());
  command.add_flag("--table", request.table, "Print the region's rows, as --format csv")
      .excludes("--format");
  command
      .add_option("--fit", request.fit,
                  "How a simulator's law that cannot take the region's shape is fitted to it: "
                  "conservative (inside it) or best (least squares)")
      .otherwise("conservative")
      .one_of({"conservative", "best"})
      .needs("--format");
  command
      .add_option("--friction", request.friction,
                  "Where a simulator's file has the drive's friction: joint (in the fields of the "
                  "simulator's joint) or limits (taken off the torque limits)")
      .otherwise("joint where the simulator has such fields, else limits")
      .one_of({"joint", "limits"})
      .needs("--format");
  command
      .add_option("--at-speed", request.speeds_rad_s, "Print rows at these speeds only, in rad/s")
      .otherwise("as many as --accuracy asks for")
      .separated_by_commas()
      .between(-kMostSpeed_rad_s, kMostSpeed_rad_s);
  command
      .add_option("--accuracy", request.accuracy,
                  "Part of the peak torque within which lines between the rows stay; a number from "
                  "1e-8 to 0.1")
      .excludes("--at-speed");
  command.add_option("--export", request.export_file, "Write the simulator's file of --format here")
      .otherwise("-, standard output")
      .names_a_file()
      .needs("--format");
  command
      .add_option("-o,--output", request.output_file,
                  "Write the answer to this file: JSON where its name ends with .json, else the "
                  "table as CSV")
      .otherwise("-, standard output")
      .names_a_file();
  add_mor_plot_options(command, request.plot);
  command
      .add_flag("--watch", request.watch,
                "Draw and answer again each time that an input changes, until Ctrl-C")
      .needs("--plot");
  add_questions(command, request);
  command.add_flag("--json", request.json, "Print the same as JSON");
}

bool is_json(const MorRequest& request) {
  const bool is_beside_export = !request.export_file.empty() && !request.output_file.empty();
  return request.json || request.format == "json" || names_json(request.output_file) ||
         is_beside_export;
}

void require_formats(const MorRequest& request) {
  const actuator::Exporter* exporter = actuator::find_exporter(request.format);
  if (!request.fit.empty() && !exporter) {
    io::refuse("--fit", fmt::format("--format {} fits no law", request.format));
  }
  if (!request.friction.empty() && !exporter) {
    io::refuse("--friction", fmt::format("--format {} is no simulator's", request.format));
  }
  if (!request.export_file.empty() && !exporter) {
    io::refuse("--export",
               fmt::format("--format {} is no simulator's; the table goes to -o", request.format));
  }
  if (exporter && !request.speeds_rad_s.empty()) {
    io::refuse("--at-speed", "rows are for csv and json");
  }
  if (is_json(request) && request.output_file.ends_with(".csv")) {
    io::refuse("--output", fmt::format("\"{}\" would be JSON", request.output_file));
  }
  if (request.format == "csv" && is_json(request)) {
    io::refuse("--format", "csv, but --json or the ending of -o asks for JSON");
  }
}

actuator::Side side_of(const MorRequest& request) {
  return request.side == "motor" ? actuator::Side::kMotor : actuator::Side::kJoint;
}

void require_accuracy(const MorRequest& request) {
  if (request.accuracy >= actuator::kFinestTableAccuracy && request.accuracy <= 0.1) return;
  io::refuse("--accuracy", fmt::format("{} must be from {} to 0.1, a part of the peak torque",
                                       request.accuracy, actuator::kFinestTableAccuracy));
}

std::optional<actuator::Need> need_of(const MorRequest& request) {
  if (request.need.empty()) return std::nullopt;
  require_use_of_lever(request.lever_m, {request.need});
  return read_need("--need", request.need, request.lever_m);
}

std::pair<double, double> ratio_range_of(const MorRequest& request) {
  return read_ratio_range("--ratio", request.ratios);
}

}  // namespace torquewright::cli
