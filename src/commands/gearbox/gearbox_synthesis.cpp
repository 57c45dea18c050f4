// SPDX-License-Identifier: Apache-2.0
#include "src/commands/gearbox/gearbox_synthesis.hpp"

#include <fmt/format.h>

#include <chrono>
#include <optional>
#include <string>

#include "gearbox/synthesis/floor_conflict.hpp"
#include "gearbox/synthesis/synthesis.hpp"
#include "gearbox/verification/verification_json.hpp"
#include "io/faults/refusal.hpp"
#include "src/commands/gearbox/design_drawing.hpp"
#include "src/commands/gearbox/gearbox_outputs.hpp"
#include "src/commands/gearbox/gearbox_result_json.hpp"
#include "src/commands/gearbox/synthesis_result_json.hpp"
#include "src/interrupt.hpp"
#include "src/loudness.hpp"
#include "src/report/gearbox/design_text.hpp"
#include "src/report/gearbox/proof_text.hpp"
#include "src/report/gearbox/synthesis_text.hpp"
#include "src/report/parts/progress_line.hpp"
#include "src/window_text.hpp"

namespace torquewright::cli {
namespace {

using gearbox::SynthesisResult;
using gearbox::SynthesisStatus;

void refuse_unknown_options(const OptimizeRequest& request) {
  if (request.top != 1) io::refuse("--top", "a synthesis seeks one design");
  if (request.relaxation != "auto") {
    io::refuse("--relaxation",
               "a synthesis computes bounds by intervals alone; leave the option out");
  }
}

SynthesisResult synthesised(const OptimizeRequest& request, const gearbox::Problem& problem,
                            const std::function<bool()>& is_over) {
  report::ProgressLine line;
  gearbox::SynthesisOptions options;
  options.max_boxes = request.max_nodes;
  options.should_stop = is_over;
  options.report = [&line](const gearbox::SynthesisProgress& progress) {
    line.show(fmt::format("{} parts of the search done, {} open, best {}, bound {:.6g} kg",
                          progress.boxes, progress.open,
                          progress.mass_kg ? fmt::format("{:.6g} kg", *progress.mass_kg) : "none",
                          progress.bound_kg));
  };
  SynthesisResult found = gearbox::synthesise(problem, options);
  if (found.status != SynthesisStatus::kInfeasible) return found;
  options.max_boxes = 0;
  gearbox::explain_conflict(problem, options, found);
  return found;
}

ExitCode exit_code_of(SynthesisStatus status) {
  switch (status) {
    case SynthesisStatus::kOptimal:
      return ExitCode::kPasses;
    case SynthesisStatus::kInfeasible:
      return ExitCode::kFails;
    case SynthesisStatus::kLimit:
      break;
  }
  return ExitCode::kUndecided;
}

}  // namespace

ExitCode run_synthesis(const OptimizeRequest& request, const ReadProblem& read,
                       const std::function<bool()>& is_over) {
  refuse_unknown_options(request);
  const auto start = std::chrono::steady_clock::now();
  const SynthesisResult found = synthesised(request, read.problem, is_over);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  std::string json = synthesis_result_json(request, read, found, seconds.count());
  const bool has_all = request.all || loudness().is_verbose;
  std::string text = report::synthesis_text(read.problem, found, has_all);
  if (request.timing) text += fmt::format("Search time: {:.4f} s\n", seconds.count());
  std::optional<gearbox::Verification> check;
  if (request.verify) {
    catch_interrupt();  // what ended the search does not end the check
    check = verified_result(json);
    text += report::proof_text(*check);
  }
  if (found.best && !has_all) text += report::next_text(request.problem_file, found.best->problem);
  std::optional<std::string> drawing;
  if (!request.outputs.drawing.empty() && found.best) {
    drawing = drawing_of(found.best->problem, found.best->design);
  }
  write_outputs(request.outputs, json, drawing,
                !request.json ? for_window(text, report::synthesis_answer(found))
                : check       ? with_verdict(json, *check)
                              : json);
  if (check && !check->is_accepted) {
    return check->is_ended ? ExitCode::kUndecided : ExitCode::kFails;
  }
  return exit_code_of(found.status);
}

}  // namespace torquewright::cli
