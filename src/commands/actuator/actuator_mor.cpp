// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "actuator/exporters/library.hpp"
#include "actuator/mor/mor_table_spec.hpp"
#include "actuator/mor/need.hpp"
#include "actuator/motor/actuator_spec.hpp"
#include "actuator/motor/derived_values_spec.hpp"
#include "io/faults/refusal.hpp"
#include "io/files/atomic_file.hpp"
#include "src/commands/actuator/actuator_commands.hpp"
#include "src/commands/actuator/actuator_export.hpp"
#include "src/commands/actuator/mor_compare.hpp"
#include "src/commands/actuator/mor_plot.hpp"
#include "src/commands/shared/result_json.hpp"
#include "src/commands/shared/watch.hpp"
#include "src/interrupt.hpp"
#include "src/options/mor_request.hpp"
#include "src/options/output_files.hpp"
#include "src/report/actuator/actuator_json.hpp"
#include "src/report/actuator/actuator_text.hpp"
#include "src/report/actuator/region_text.hpp"
#include "src/standard_output.hpp"
#include "src/window_text.hpp"

namespace torquewright::cli {
namespace {

constexpr std::size_t kRatiosInSweep = 25;

struct MorInputs {
  actuator::ReadActuator read;
  actuator::OperatingConditions conditions;
  std::optional<ComparedActuator> compared;         ///< The one of --compare.
  std::optional<std::pair<double, double>> ratios;  ///< Least and greatest to be tried.
  std::optional<actuator::Need> need;
  std::optional<report::PlotFormat> picture;
  std::vector<Overlay> overlays;  ///< Of the picture, where no other actuator is in it.
};

/// The last of the questions: a file for a simulator.
const actuator::Exporter* exporter_of(const MorRequest& request) {
  return actuator::find_exporter(request.format);
}

/// Whether the region's rows, or a simulator's file, are asked for.
bool wants_rows(const MorRequest& request) {
  return request.table || request.json || !request.format.empty() ||
         !request.speeds_rad_s.empty() || !request.output_file.empty() ||
         (request.plot.file.empty() && request.accuracy != MorRequest{}.accuracy);
}

void read_question(const MorRequest& request, MorInputs& inputs) {
  if (!request.ratios.empty()) inputs.ratios = ratio_range_of(request);
  inputs.need = need_of(request);
  if (inputs.ratios || request.plot.file.empty()) return;
  inputs.picture = report::plot_format(request.plot.file);
  if (inputs.compared) return;
  inputs.overlays = overlays_of(request.plot, inputs.read.actuator, inputs.conditions);
}

/// A picture draws its own mesh; the part that was asked for would be dropped.
void require_rows_of_accuracy(const MorRequest& request) {
  if (wants_rows(request) || request.accuracy == MorRequest{}.accuracy) return;
  io::refuse("--accuracy",
             "is of rows, and a picture alone has none; ask for them with --table, --json or -o");
}

MorInputs read(const MorRequest& request) {
  require_rows_of_accuracy(request);
  require_accuracy(request);
  require_formats(request);
  MorInputs inputs;
  inputs.read = actuator::read_actuator(request.actuator_file);
  inputs.conditions = conditions_of(request.operating, inputs.read);
  if (!request.compare_file.empty()) {
    actuator::ReadActuator other = actuator::read_actuator(request.compare_file);
    const actuator::OperatingConditions conditions = conditions_of(request.operating, other);
    inputs.compared = {request.compare_file, std::move(other), conditions};
  }
  read_question(request, inputs);
  check_written(named({request.output_file, request.export_file, request.plot.file}), {});
  return inputs;
}

/// One of the questions that the command answers, answered.
struct MorAnswer {
  std::optional<Report> report = {};     ///< Of the questions that have one.
  std::optional<std::string> rows = {};  ///< The table, or the document of a simulator's file.
  std::optional<std::string> file = {};  ///< The simulator's.
  std::string plot = {};                 ///< A script for gnuplot; empty: no picture.
  ExitCode code = ExitCode::kPasses;
};

MorAnswer sweep(const MorInputs& inputs) {
  const auto [low, high] = *inputs.ratios;
  const auto rows = actuator::ratio_sweep(inputs.read.actuator, inputs.conditions, low, high,
                                          kRatiosInSweep, inputs.need);
  return {.report = Report{result_text(report::sweep_json(rows), inputs.read.documents),
                           report::sweep_text(rows)}};
}

ExitCode code_of(const actuator::NeedAnswer& answer) {
  if (answer.is_ended) return ExitCode::kUndecided;
  return answer.is_reached ? ExitCode::kPasses : ExitCode::kFails;
}

MorAnswer answer_need(const MorInputs& inputs, const actuator::Need& need) {
  catch_interrupt();
  const actuator::NeedAnswer answer =
      actuator::answer_need(inputs.read.actuator, inputs.conditions, need, is_interrupted);
  std::string plot;
  if (inputs.picture) {
    plot = region_plot_of(*inputs.picture, inputs.read.actuator, inputs.overlays,
                          actuator::Side::kJoint, AnsweredNeed{need, answer});
  }
  return {.report = Report{result_text(report::need_json(need, answer), inputs.read.documents),
                           report::need_text(inputs.read.actuator, need, answer)},
          .plot = std::move(plot),
          .code = code_of(answer)};
}

/// Both regions as a table, and drawn where a picture was asked for.
MorAnswer compare(const MorRequest& request, const MorInputs& inputs) {
  const ComparedActuator to{request.actuator_file, inputs.read, inputs.conditions};
  const actuator::Side side = side_of(request);
  std::string plot;
  if (inputs.picture) plot = comparison_plot(*inputs.picture, *inputs.compared, to, side);
  return {.report = Report{comparison_result(*inputs.compared, to, side, true),
                           comparison_result(*inputs.compared, to, side, false)},
          .plot = std::move(plot)};
}

MorAnswer export_region(const MorRequest& request, const MorInputs& inputs,
                        const actuator::Exporter& exporter) {
  const actuator::Actuator& actuator = inputs.read.actuator;
  const actuator::ExportChoices choices{
      .conditions = inputs.conditions,
      .side = side_of(request),
      .fit = request.fit == "best" ? actuator::LawFit::kBest : actuator::LawFit::kConservative,
      .friction = friction_place(request.friction, actuator, exporter, side_of(request)),
      .table_accuracy = request.accuracy};
  const auto written = [&](bool as_json) {
    return exported_file(inputs.read, exporter, choices, as_json);
  };
  MorAnswer answer;
  if (is_json(request)) answer.rows = written(true);
  if (!is_json(request) || !request.export_file.empty()) answer.file = written(false);
  return answer;
}

MorAnswer tabulate(const MorRequest& request, const MorInputs& inputs) {
  const actuator::Region region(inputs.read.actuator, inputs.conditions, side_of(request));
  const actuator::MorTable table = request.speeds_rad_s.empty()
                                       ? actuator::mor_table(region, request.accuracy)
                                       : actuator::mor_rows(region, request.speeds_rad_s);
  const actuator::MorHeader header{&inputs.read.actuator, inputs.conditions, side_of(request)};
  return {.rows = is_json(request)
                      ? result_text(actuator::mor_table_json(header, table), inputs.read.documents)
                      : actuator::mor_table_csv(header, table)};
}

MorAnswer compute(const MorRequest& request, const MorInputs& inputs) {
  if (inputs.ratios) return sweep(inputs);
  if (inputs.need) return answer_need(inputs, *inputs.need);
  if (inputs.compared) return compare(request, inputs);
  MorAnswer answer;
  const actuator::Exporter* exporter = exporter_of(request);
  if (wants_rows(request)) {
    answer = exporter ? export_region(request, inputs, *exporter) : tabulate(request, inputs);
  }
  if (!wants_rows(request) && !inputs.picture) {
    const actuator::MorHeader header{&inputs.read.actuator, inputs.conditions, side_of(request)};
    answer.rows = for_window(
        report::region_text(
            header, request.actuator_file,
            actuator::derived_values(inputs.read.documents.front(), inputs.read.actuator)),
        report::region_answer(header));
  }
  if (inputs.picture) {
    answer.plot =
        region_plot_of(*inputs.picture, inputs.read.actuator, inputs.overlays, side_of(request));
  }
  return answer;
}

void write(const MorRequest& request, const MorAnswer& answer) {
  std::vector<io::FileContent> files;
  if (!answer.plot.empty()) {
    files.push_back({request.plot.file, report::picture_by_gnuplot(answer.plot)});
  }
  if (answer.report) {
    return deliver_report(*answer.report, request.output_file, request.json, std::move(files));
  }
  if (answer.file && !request.export_file.empty()) {
    files.push_back({request.export_file, *answer.file});
  }
  if (answer.rows) return deliver_result(*answer.rows, request.output_file, std::move(files));
  if (!answer.file || !request.export_file.empty()) return deliver(std::move(files), "");
  deliver_result(*answer.file, request.output_file, std::move(files));
  if (request.output_file.empty()) return;
  say_old_spelling(request.output_file, "the simulator's file", "--export " + request.output_file);
}

ExitCode answer_once(const MorRequest& request) {
  const MorInputs inputs = read(request);
  const MorAnswer answer = compute(request, inputs);
  write(request, answer);
  return answer.code;
}

ExitCode run_mor(const MorRequest& request) {
  const auto work = [&request] { return answer_once(request); };
  return request.watch ? watch(work) : work();
}

}  // namespace

void add_mor_command(command_line::Command& actuator) {
  auto request = std::make_shared<MorRequest>();
  command_line::Command command = actuator.add_command(
      "mor", "Compute the motor operating region: which torques are there at each speed");
  add_mor_options(command, *request);
  command.example("torquewright actuator mor specs/actuator/d151_knee.json --at-speed 0,5,10");
  command.works([request] { return run_mor(*request); });
}

}  // namespace torquewright::cli
