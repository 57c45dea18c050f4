// SPDX-License-Identifier: Apache-2.0
#include "src/commands/planning/hopper_flip_outputs.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "hopper/motion/motion_csv.hpp"
#include "io/faults/refusal.hpp"
#include "io/files/atomic_file.hpp"
#include "src/commands/planning/hopper_flip_json.hpp"
#include "src/commands/planning/hopper_flip_next.hpp"
#include "src/commands/planning/hopper_flip_robust.hpp"
#include "src/options/output_files.hpp"
#include "src/report/motion/flip_html.hpp"
#include "src/report/motion/flip_text.hpp"
#include "src/report/parts/gnuplot.hpp"
#include "src/report/robot/momentum_plot.hpp"
#include "src/report/robot/motion_figure.hpp"
#include "src/standard_output.hpp"
#include "src/window_text.hpp"

namespace torquewright::cli {
namespace {

bool is_planned(const hopper::PlanResult& result) {
  return result.status == hopper::PlanStatus::kPlanned;
}

void say_left_out(const std::string& file) {
  std::fprintf(stderr, "%s: not written, there is no plan\n", file.c_str());
}

void add_motions(const HopperFlipRequest& request, const hopper::Robot& robot,
                 const hopper::PlanResult& result, std::vector<io::FileContent>& files) {
  if (is_planned(result)) {
    files.push_back({request.motion_file, hopper::motion_csv(robot, result.motion)});
    return;
  }
  say_left_out(request.motion_file);
  if (request.best_file.empty()) return;
  if (result.motion.samples() == 0) {
    std::fprintf(stderr, "%s: not written, nothing was found\n", request.best_file.c_str());
    return;
  }
  files.push_back({request.best_file,
                   fmt::format("# No plan: {}. What comes closest.\n", name_of(result.status)) +
                       hopper::motion_csv(robot, result.motion)});
}

void add_pictures(const HopperFlipRequest& request, const report::HopperPage& page,
                  std::vector<io::FileContent>& files) {
  if (!request.momentum_file.empty()) {
    const std::string script =
        report::momentum_plot(report::plot_format(request.momentum_file), page);
    files.push_back({request.momentum_file, report::picture_by_gnuplot(script, "--plot-momentum")});
  }
  if (!request.figures_file.empty()) {
    files.push_back({request.figures_file, report::motion_figure(page)});
  }
}

std::vector<io::FileContent> files_of(const HopperFlipRequest& request,
                                      const HopperFlipInputs& inputs,
                                      const hopper::PlanResult& result) {
  const hopper::Robot& robot = inputs.robot.robot;
  std::vector<io::FileContent> files;
  add_motions(request, robot, result, files);
  if (is_planned(result) && result.check) {
    const std::vector<hopper::CandidateResult> none;
    add_pictures(request, {robot, result.motion, inputs.plan.check, *result.check, none}, files);
  } else {
    for (const std::string* file : {&request.momentum_file, &request.figures_file}) {
      if (!file->empty()) say_left_out(*file);
    }
  }
  if (!request.report_file.empty()) {
    files.push_back({request.report_file, report::flip_html(robot, inputs.plan, result)});
  }
  return files;
}

}  // namespace

void require_flip_outputs(const HopperFlipRequest& request) {
  for (const std::string* file : {&request.motion_file, &request.best_file}) {
    if (!names_json(*file)) continue;
    io::refuse(file == &request.motion_file ? "--output" : "--write-best",
               fmt::format("\"{}\" becomes a motion, which is a CSV; --json prints the answer as "
                           "JSON",
                           *file));
  }
  if (is_standard_output(request.motion_file) && request.json) {
    io::refuse("--json", "standard output takes the motion of -o -");
  }
  require_svg("--figures", request.figures_file);
  if (!request.momentum_file.empty()) {
    report::plot_format(request.momentum_file);
    report::require_gnuplot("--plot-momentum");
  }
  check_flip_files(request);
}

void check_flip_files(const HopperFlipRequest& request) {
  check_written(
      named({request.motion_file, request.best_file, request.momentum_file, request.figures_file,
             request.report_file}),
      named({request.warm.robot_file, request.warm.trajectory_file, request.robust_file}));
}

void write_flip_outputs(const HopperFlipRequest& request, const HopperFlipInputs& inputs,
                        hopper::PlanResult& result, const std::optional<RobustChoice>& robust) {
  result.motion.file = is_planned(result) ? request.motion_file : request.best_file;
  const report::FlipAnswer answer{inputs.robot.robot,
                                  inputs.plan,
                                  result,
                                  next_commands(request, result),
                                  robust ? robust_lines(request, *robust) : "",
                                  request.timing};
  const std::string text =
      request.json ? hopper_flip_json(request, inputs, result, robust) : report::flip_text(answer);
  deliver(files_of(request, inputs, result), request.json ? text : for_window(text));
}

}  // namespace torquewright::cli
