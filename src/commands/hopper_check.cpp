// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "hopper/candidates/candidates_spec.hpp"
#include "hopper/check/hopper_report_spec.hpp"
#include "hopper/motion/motion_reader.hpp"
#include "hopper/robot/robot_spec.hpp"
#include "io/atomic_file.hpp"
#include "io/json_text.hpp"
#include "io/provenance.hpp"
#include "io/refusal.hpp"
#include "src/commands/hopper_commands.hpp"
#include "src/options/operating_options.hpp"
#include "src/report/gnuplot.hpp"
#include "src/report/hopper_html.hpp"
#include "src/report/hopper_plots.hpp"
#include "src/report/hopper_text.hpp"
#include "src/report/progress_line.hpp"
#include "src/report/stick_figures.hpp"
#include "src/standard_output.hpp"

namespace torquewright::cli {
namespace {

struct HopperCheckOptions {
  std::string robot_file;
  std::string trajectory_file;
  std::vector<std::string> columns;
  std::vector<std::string> columns_files;
  std::vector<double> from_s;
  std::vector<double> until_s;
  OperatingOptions operating;
  hopper::CheckOptions check;
  std::string torques = "best";
  std::string candidates_folder;
  std::string ratios;
  std::size_t threads = 1;
  std::string plot_file;
  std::string loads_file;
  std::string figures_file;
  std::string report_file;
  std::string output_file;
  bool json = false;
};

hopper::MotionFile motion_file(const HopperCheckOptions& options) {
  hopper::MotionFile source;
  source.file = options.trajectory_file;
  source.mappings = options.columns;
  for (const std::string& file : options.columns_files) {
    source.documents.push_back(io::read_document(file, "trajectory_columns"));
  }
  if (!options.from_s.empty()) source.window.from_s = options.from_s.back();
  if (!options.until_s.empty()) source.window.until_s = options.until_s.back();
  if (source.window.from_s > source.window.until_s) {
    io::refuse("--from", fmt::format("{} s lies after --until {} s", source.window.from_s,
                                     source.window.until_s));
  }
  return source;
}

hopper::CheckOptions check_options(const HopperCheckOptions& options,
                                   const hopper::ReadRobot& read) {
  hopper::CheckOptions check = options.check;
  check.conditions = stated_conditions(options.operating);
  for (const hopper::Drivetrain& drivetrain : read.robot.drivetrains) {
    for (std::size_t i = 0; i < drivetrain.actuators.size(); ++i) {
      require_possible(drivetrain.actuators[i], drivetrain.actuator_files[i], check.conditions);
    }
  }
  check.torques = options.torques == "file"       ? hopper::TorqueSource::kFile
                  : options.torques == "dynamics" ? hopper::TorqueSource::kDynamics
                                                  : hopper::TorqueSource::kBest;
  return check;
}

/// What was asked for beyond the files, where it is not the default.
nlohmann::ordered_json options_json(const HopperCheckOptions& options) {
  const hopper::CheckOptions defaults;
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  const auto add = [&json](const char* key, const auto& value, const auto& usual) {
    if (value != usual) json[key] = value;
  };
  if (!options.columns.empty()) json["column"] = options.columns;
  if (!options.from_s.empty()) json["from_s"] = options.from_s.back();
  if (!options.until_s.empty()) json["until_s"] = options.until_s.back();
  add("rating", options.operating.rating, std::string("peak"));
  add("bus_voltage_V", options.operating.bus_voltage_V, 0.0);
  add("state_of_charge", options.operating.state_of_charge, -1.0);
  add("winding_temperature_K", options.operating.winding_temperature_K, 0.0);
  add("torques", options.torques, std::string("best"));
  add("ground_height_m", options.check.contact.ground_height_m, defaults.contact.ground_height_m);
  add("contact_height_m", options.check.contact.height_m, defaults.contact.height_m);
  add("contact_speed_m_s", options.check.contact.speed_m_s, defaults.contact.speed_m_s);
  add("residual_limit", options.check.residual_share, defaults.residual_share);
  add("load_window_s", options.check.load_window_s, defaults.load_window_s);
  add("repeat", options.check.runs, defaults.runs);
  add("ratios", options.ratios, std::string());
  add("pause_s", options.check.pause_s, defaults.pause_s);
  return json;
}

/// Candidates, if a folder of them is given.
struct Tried {
  hopper::Shelf shelf;
  std::vector<hopper::CandidateResult> results;
};

Tried try_shelf(const HopperCheckOptions& options, const hopper::ReadRobot& read,
                const hopper::Motion& motion, const hopper::CheckOptions& check) {
  if (options.candidates_folder.empty()) {
    if (!options.ratios.empty()) io::refuse("--ratios", "is for --candidates");
    return {};
  }
  std::optional<hopper::RatioSweep> sweep;
  if (!options.ratios.empty()) sweep = hopper::read_ratio_sweep(options.ratios);
  Tried tried;
  tried.shelf = hopper::read_shelf(options.candidates_folder, read, sweep);
  report::ProgressLine progress;
  tried.results = hopper::try_candidates(
      read.robot, motion, check, tried.shelf, options.threads, [&progress](double share) {
        progress.show(fmt::format("trying candidates: {:.0f} %", 100.0 * share));
      });
  return tried;
}

std::string text_of(const hopper::ReadRobot& read, const hopper::Motion& motion,
                    const hopper::HopperReport& report, const Tried& tried) {
  std::string text = report::hopper_text(read.robot, motion, report);
  if (tried.results.empty()) return text;
  text += report::candidates_text(read.robot, tried.results);
  for (const std::string& sentence : tried.shelf.left_out) {
    text += fmt::format("not tried: {}\n", sentence);
  }
  return text;
}

std::string json_text(const HopperCheckOptions& options, const hopper::MotionFile& source,
                      const hopper::ReadRobot& read, const hopper::HopperReport& report,
                      const Tried& tried) {
  nlohmann::ordered_json document = hopper::hopper_report_json(report);
  document["candidates"] = hopper::candidates_json(read.robot, tried.results);
  document["options"] = options_json(options);
  document["tool"] = io::tool_provenance();
  std::vector<io::Document> inputs = read.documents;
  inputs.push_back({options.trajectory_file, "", {}, report.check.sha256});
  inputs.insert(inputs.end(), source.documents.begin(), source.documents.end());
  inputs.insert(inputs.end(), tried.shelf.documents.begin(), tried.shelf.documents.end());
  document["inputs"] = io::input_provenance(inputs);
  return io::json_text(document);
}

/// What is wrong with the files to be written, before the work.
void require_outputs(const HopperCheckOptions& options) {
  for (const std::string* file : {&options.plot_file, &options.loads_file}) {
    if (!file->empty()) report::plot_format(*file);
  }
  if (!options.plot_file.empty()) report::require_gnuplot("--plot");
  if (!options.loads_file.empty()) report::require_gnuplot("--plot-loads");
  if (!options.report_file.empty()) report::require_gnuplot("--report");
  std::vector<std::filesystem::path> outputs;
  for (const std::string* file : {&options.plot_file, &options.loads_file, &options.figures_file,
                                  &options.report_file, &options.output_file}) {
    if (!file->empty()) outputs.emplace_back(*file);
  }
  std::vector<std::filesystem::path> inputs{options.robot_file, options.trajectory_file};
  inputs.insert(inputs.end(), options.columns_files.begin(), options.columns_files.end());
  io::check_outputs(outputs, inputs);
}

/// What was asked for that the motion has something for.
std::vector<io::FileContent> pictures(const HopperCheckOptions& options,
                                      const report::HopperPage& page) {
  std::vector<io::FileContent> files;
  const auto add = [&files](const std::string& file, std::string content) {
    if (!content.empty()) {
      files.push_back({file, std::move(content)});
    } else {
      std::fprintf(stderr, "%s: not drawn, the motion holds nothing for it\n", file.c_str());
    }
  };
  const auto drawn = [](const std::string& script, const char* option) {
    return script.empty() ? std::string() : report::picture_by_gnuplot(script, option);
  };
  if (!options.plot_file.empty()) {
    const std::string title =
        fmt::format("{}: {}", page.robot.name, actuator::name_of(page.report.check.verdict));
    add(options.plot_file,
        drawn(report::drives_plot(report::plot_format(options.plot_file), page.robot,
                                  page.options.conditions, title, page.report),
              "--plot"));
  }
  if (!options.loads_file.empty()) {
    add(options.loads_file,
        drawn(report::loads_plot(report::plot_format(options.loads_file), page.motion, page.report),
              "--plot-loads"));
  }
  if (!options.figures_file.empty()) {
    add(options.figures_file,
        report::stick_figures(page.robot, page.motion, page.options.contact.ground_height_m));
  }
  if (!options.report_file.empty()) add(options.report_file, report::hopper_html(page));
  return files;
}

ExitCode exit_code_of(actuator::Verdict verdict) {
  if (verdict == actuator::Verdict::kPass) return ExitCode::kPasses;
  return verdict == actuator::Verdict::kFail ? ExitCode::kFails : ExitCode::kUndecided;
}

ExitCode run(const HopperCheckOptions& options) {
  require_outputs(options);
  const hopper::ReadRobot read = hopper::read_robot(options.robot_file);
  hopper::MotionFile source = motion_file(options);
  hopper::CheckOptions check = check_options(options, read);
  check.keep_traces = !options.plot_file.empty() || !options.report_file.empty();
  hopper::Motion motion;
  hopper::HopperReport report;
  {
    report::ProgressLine progress;
    source.on_progress = [&progress](double share) {
      progress.show(fmt::format("reading the motion: {:.0f} %", 100.0 * share));
    };
    check.on_progress = [&progress](double share) {
      progress.show(fmt::format("forces and torques: {:.0f} %", 100.0 * share));
    };
    motion = hopper::read_motion(read.robot, source);
    report = hopper::check_motion(read.robot, motion, check);
  }
  const Tried tried = try_shelf(options, read, motion, check);
  const std::string text = options.json ? json_text(options, source, read, report, tried)
                                        : text_of(read, motion, report, tried);
  std::vector<io::FileContent> files =
      pictures(options, {read.robot, motion, check, report, tried.results});
  if (!options.output_file.empty()) files.push_back({options.output_file, text});
  io::write_whole_files(files);
  if (options.output_file.empty()) print_result(text);
  return exit_code_of(report.check.verdict);
}

void add_motion_options(CLI::App& command, HopperCheckOptions& options) {
  command
      .add_option("--column", options.columns,
                  "NAME=OWNER.QUANTITY[:unit][*factor]: what a column is; owners are joints, "
                  "base_x, base_z, base_pitch, ... and contacts (force_x, contact)")
      ->allow_extra_args(false);
  command
      .add_option("--columns", options.columns_files, "The same as a document: trajectory_columns")
      ->allow_extra_args(false);
  command.add_option("--from", options.from_s, "Only rows from this time on, in s")
      ->expected(1)
      ->check(CLI::Range(-1e12, 1e12));
  command.add_option("--until", options.until_s, "Only rows up to this time, in s")
      ->expected(1)
      ->check(CLI::Range(-1e12, 1e12));
  command
      .add_option("--torques", options.torques,
                  "Which torques count: best (the file's where it has all), file, dynamics")
      ->check(CLI::IsMember({"best", "file", "dynamics"}));
}

void add_physics_options(CLI::App& command, hopper::CheckOptions& check) {
  command.add_option("--ground-height", check.contact.ground_height_m, "z of the ground, in m")
      ->check(CLI::Range(-1e6, 1e6));
  command
      .add_option("--contact-height", check.contact.height_m,
                  "Points no higher than this touch, in m")
      ->check(CLI::Range(0.0, 10.0));
  command
      .add_option("--contact-speed", check.contact.speed_m_s,
                  "and that move up or down no faster, in m/s")
      ->check(CLI::Range(0.0, 100.0));
  command
      .add_option("--residual-limit", check.residual_share,
                  "Force that nothing explains, in weights: more is no motion")
      ->check(CLI::Range(0.0, 1e9));
  command
      .add_option("--load-window", check.load_window_s,
                  "Over which a transmission's load is averaged, in s")
      ->check(CLI::Range(1e-6, 10.0));
  command.add_option("--repeat", check.runs, "Runs of the motion, for the windings' temperature")
      ->check(CLI::Range(1, 1000000000));
  command.add_option("--pause", check.pause_s, "Between runs, in s")->check(CLI::Range(0.0, 1e9));
}

}  // namespace

void add_hopper_check_command(CLI::App& hopper, ExitCode& result) {
  auto options = std::make_shared<HopperCheckOptions>();
  CLI::App* command = hopper.add_subcommand("check", "Can this robot do this motion?");
  command->add_option("robot", options->robot_file, "Document of kind robot")->required();
  command
      ->add_option("trajectory", options->trajectory_file,
                   "CSV: time_s, base_..., <joint>_position_rad and, where known, velocities, "
                   "accelerations, torques, contact forces")
      ->required();
  add_motion_options(*command, *options);
  add_physics_options(*command, options->check);
  add_operating_options(*command, options->operating);
  command->add_option("--candidates", options->candidates_folder,
                      "Folder of actuators and gearboxes to try in every place");
  command->add_option("--ratios", options->ratios,
                      "FROM:TO[:STEP]: try the candidates with these gear ratios");
  command->add_option("--threads", options->threads, "That try candidates")
      ->check(CLI::Range(1, 256));
  command->add_option("--plot", options->plot_file,
                      "Draw each region and in it the motion to this SVG or PNG");
  command->add_option("--plot-loads", options->loads_file,
                      "Draw torques, ground forces and gear loads over time to this SVG or PNG");
  command->add_option("--figures", options->figures_file,
                      "Draw the robot at moments of the motion to this SVG");
  command->add_option("--report", options->report_file,
                      "Write a page with everything, pictures included, to this HTML");
  command->add_option("-o,--output", options->output_file, "Write to this file");
  command->add_flag("--json", options->json, "The report as JSON");
  command->footer(
      "Example:\n  torquewright hopper check specs/robot/hopper.json "
      "specs/trajectory/hopper_flip.csv");
  command->callback([options, &result] { result = run(*options); });
}

}  // namespace torquewright::cli
