// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gearbox/strength/result_strength_spec.hpp"
#include "gearbox/strength/steels.hpp"
#include "gearbox/topologies/topology.hpp"
#include "io/faults/refusal.hpp"
#include "src/commands/gearbox/gearbox_commands.hpp"
#include "src/commands/shared/result_json.hpp"
#include "src/options/output_files.hpp"
#include "src/report/gearbox/strength_json.hpp"
#include "src/standard_output.hpp"

namespace torquewright::cli {
namespace {

struct StrengthOptions {
  std::string file;
  std::string output_file;
  std::vector<double> torques_Nm;
  std::string side;
  std::vector<double> face_widths_mm;
  std::vector<double> modules_mm;
  std::optional<double> cycles;  // the document's, else
  // Of a gearbox_result, which says none of it.
  std::vector<std::string> steel;
  std::vector<double> face_width_mm;
  std::vector<std::string> rim;
  std::int64_t design = 0;             // 0: the first
  std::optional<double> load_sharing;  // K_gamma; the document's, or assumed, else
  bool json = false;
};

// A range lets NaN pass, and torques of exactly 0 load nothing.
void check_numbers(const std::vector<double>& numbers, const char* option, const char* unit,
                   double least, double greatest) {
  for (const double number : numbers) {
    if (number >= least && number <= greatest) continue;
    io::refuse(option, fmt::format("{} {} must be from {:g} to {:g} {}", number, unit, least,
                                   greatest, unit));
  }
}

/// Each torque on each face width of each module is a row of its own.
void check_rows(const StrengthOptions& options) {
  constexpr std::size_t kMostRows = 10'000;
  const std::size_t widths = std::max<std::size_t>(1, options.face_widths_mm.size());
  const std::size_t modules = std::max<std::size_t>(1, options.modules_mm.size());
  const std::size_t torques = std::max<std::size_t>(1, options.torques_Nm.size());
  const std::size_t rows = torques * widths * modules;
  if (rows <= kMostRows) return;
  io::refuse("--torque, --face-widths, --modules",
             fmt::format("{} torques on {} face widths of {} modules are {} rows; at most {}",
                         torques, widths, modules, rows, kMostRows));
}

void check_options(const StrengthOptions& options, const gearbox::ReadStrength& read) {
  check_numbers(options.torques_Nm, "--torque", "Nm", 1e-6, 1e6);
  check_numbers(options.face_widths_mm, "--face-widths", "mm", 0.05, 1000.0);
  check_numbers(options.modules_mm, "--modules", "mm", 0.05, 25.0);
  check_rows(options);
  const gearbox::GearTrain& train = read.strength.train;
  const bool is_stage = gearbox::find_topology(train.topology)->largest_of_same_ratio != nullptr;
  if (!options.modules_mm.empty()) {
    const bool is_shifted = std::any_of(train.shifts.begin(), train.shifts.end(),
                                        [](double shift) { return shift != 0.0; });
    if (is_stage && is_shifted) {
      io::refuse("--modules", "chooses teeth without profile shift; this gearbox has it");
    }
    if (train.layer_2_module_mm) {
      io::refuse("--modules", "is for gearboxes of one module; this one has two");
    }
    if (!read.strength.rim_mm.empty()) {
      io::refuse("--modules", "does not know the rims of other sizes; state no rims with it");
    }
  }
  if (!options.modules_mm.empty() && is_stage && !read.ring_space_mm) {
    throw io::SpecError({{options.file, "/rotor_inner_diameter_mm",
                          "missing; --modules chooses teeth that fit into it"}});
  }
}

/// A gear_strength document says all of it itself.
void refuse_options_of_results(const StrengthOptions& options) {
  const char* option = !options.steel.empty()           ? "--steel"
                       : !options.face_width_mm.empty() ? "--face-width"
                       : options.design != 0            ? "--design"
                       : !options.rim.empty()           ? "--rim"
                                                        : nullptr;
  if (option == nullptr) return;
  io::refuse(option, "goes with a gearbox_result; a gear_strength document says it itself");
}

gearbox::ReadStrength read_file(const StrengthOptions& options) {
  io::Document document = io::read_document(options.file, {"gear_strength", "gearbox_result"});
  if (document.root["kind"] == "gear_strength") {
    refuse_options_of_results(options);
    return gearbox::strength_of(std::move(document));
  }
  check_numbers(options.face_width_mm, "--face-width", "mm", 0.05, 1000.0);
  gearbox::ResultStrengthOptions wanted;
  wanted.steel = options.steel;
  wanted.face_width_mm = options.face_width_mm;
  wanted.rim = options.rim;
  wanted.load_sharing = options.load_sharing;
  if (options.design != 0) wanted.design = static_cast<std::size_t>(options.design);
  wanted.cycles = options.cycles;
  return gearbox::strength_of_result(std::move(document), wanted);
}

gearbox::ReadStrength read(const StrengthOptions& options) {
  gearbox::ReadStrength read = read_file(options);
  check_options(options, read);
  if (options.cycles) read.strength.cycles = *options.cycles;
  if (options.load_sharing) read.strength.factors.load_sharing = *options.load_sharing;
  check_written(named({options.output_file}), {});
  return read;
}

/// Those of the command line, else the load that a result's problem states, at the joint.
void take_torques(const StrengthOptions& options, report::StrengthReport& report) {
  report.side = options.side == "joint" ? gearbox::TorqueSide::kJoint : gearbox::TorqueSide::kMotor;
  report.torques_Nm = options.torques_Nm;
  if (!options.torques_Nm.empty()) return;
  if (!report.read.load_Nm || *report.read.load_Nm == 0.0) {
    io::refuse("--torque", "missing; only a gearbox_result whose problem has a load states one");
  }
  if (!options.side.empty())
    io::refuse("--side", "says where --torque acts, and --torque is missing");
  report.side = gearbox::TorqueSide::kJoint;
  report.torques_Nm = {*report.read.load_Nm};
  report.read.statements.push_back(
      fmt::format("The torque is the load of its problem, {:g} Nm at the joint (--torque).",
                  *report.read.load_Nm));
}

report::StrengthReport compute(const StrengthOptions& options, gearbox::ReadStrength read) {
  report::StrengthReport report;
  report.read = std::move(read);
  take_torques(options, report);
  if (!options.modules_mm.empty() || !options.face_widths_mm.empty()) {
    report.variants =
        gearbox::strength_variants(report.read.strength, options.modules_mm, options.face_widths_mm,
                                   report.read.ring_space_mm.value_or(0.0));
  }
  return report;
}

void write(const StrengthOptions& options, const report::StrengthReport& report) {
  deliver_report({result_text(report::strength_json(report), report.read.documents),
                  report::strength_text(report)},
                 options.output_file, options.json);
}

/// For the help: the names and their sources.
std::string steel_names() {
  std::string names;
  for (const gearbox::Steel& steel : gearbox::steels()) {
    names += (names.empty() ? "" : ", ") + std::string(steel.name);
  }
  return names;
}

ExitCode run_strength(const StrengthOptions& options) {
  const report::StrengthReport report = compute(options, read(options));
  write(options, report);
  return report.passes() ? ExitCode::kPasses : ExitCode::kFails;
}

}  // namespace

void add_strength_command(command_line::Command& gearbox) {
  auto options = std::make_shared<StrengthOptions>();
  command_line::Command command =
      gearbox.add_command("strength", "Compute what torques do to the teeth");
  command.add_option("strength", options->file, "Document of kind gear_strength or gearbox_result")
      .required();
  command.add_option("--torque", options->torques_Nm, "Torques that are tried, in Nm: 21,17")
      .otherwise("the load that the problem of a gearbox_result states")
      .separated_by_commas();
  command
      .add_option("--side", options->side, "Where these torques act: motor (at the sun) or joint")
      .otherwise("motor")
      .one_of({"motor", "joint"});
  command
      .add_option("--face-widths", options->face_widths_mm,
                  "Try these face widths too, in mm: 6,8,10")
      .otherwise("only the document's")
      .separated_by_commas();
  command
      .add_option("--modules", options->modules_mm,
                  "Try these modules too, in mm; a single stage gets the most teeth that fit")
      .otherwise("only the document's")
      .separated_by_commas();
  command.add_option("--cycles", options->cycles, "How often the most loaded tooth is loaded")
      .otherwise("the document's")
      .between(1.0, 1e12);
  command
      .add_option(
          "--steel", options->steel,
          "Steel of the gears of a gearbox_result, NAME or GEAR=NAME; names are " + steel_names())
      .otherwise("the document's")
      .separated_by_commas()
      .one_value_each();
  command
      .add_option("--rim", options->rim,
                  "How thick the rim behind the roots of a gearbox_result's gears is, in mm: "
                  "sun=1.2,ring=2")
      .otherwise("too thick to matter")
      .separated_by_commas()
      .one_value_each();
  command
      .add_option("--load-sharing", options->load_sharing,
                  "How much the most loaded planet takes, over the mean of all (K_gamma)")
      .otherwise("the document's")
      .between(1.0, 10.0);
  command
      .add_option("--face-width", options->face_width_mm,
                  "Face width of the gears of a gearbox_result, in mm, by layer: 10,8")
      .otherwise("that of its problem")
      .separated_by_commas();
  command.add_option("--design", options->design, "Which design of a gearbox_result is taken")
      .otherwise("1")
      .integer_between(1, 1'000'000);
  command.add_option("-o,--output", options->output_file, "Write the report as JSON to this file")
      .names_a_file();
  command.add_flag("--json", options->json, "Print the report as JSON");
  command.example(
      "torquewright gearbox strength specs/gearbox/d110a_strength.json --torque 21,17 "
      "--face-widths 6,8,10,12 --modules 0.5,0.6,0.7");
  command.works([options] { return run_strength(*options); });
}

}  // namespace torquewright::cli
