// SPDX-License-Identifier: Apache-2.0
#include "src/report/identification/identification_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "identification/answer/refined_json.hpp"
#include "identification/answer/report_spec.hpp"
#include "io/text/one_line.hpp"
#include "src/report/identification/identification_verdict.hpp"

namespace torquewright::report {
namespace {

using namespace identification;

constexpr std::size_t kMostRejected = 5;
constexpr std::size_t kMostCoordinates = 4;
constexpr std::size_t kMostRuns = 6;
constexpr std::size_t kMostRivals = 5;
constexpr double kBarLength = 32.0;

/// A line of a step; the step's name stands before the first one only.
std::string line(std::string_view step, const std::string& text) {
  return fmt::format("{:<15}{}\n", step, text);
}

std::string rms(double value, const std::string& unit) {
  return value > 0.0 ? fmt::format("{:.4g} {}", value, unit) : "not measured";
}

std::string log_lines(const Identification& found, actuator::Severity least) {
  std::string text =
      line("1 log", fmt::format("fitted: {}; held out: {}", fmt::join(found.train_runs, ", "),
                                found.holdout_runs.empty()
                                    ? "none"
                                    : fmt::format("{}", fmt::join(found.holdout_runs, ", "))));
  static constexpr const char* kWeights[] = {"note", "warning", "error"};
  for (const DataFinding& finding : found.findings) {
    if (static_cast<int>(finding.weight) < static_cast<int>(least)) continue;  // of one order
    text += line(
        "", fmt::format("{}: {}", kWeights[static_cast<int>(finding.weight)], finding.sentence));
  }
  return text;
}

std::string residual_lines(const EquationResult& equation) {
  std::string text =
      line("2 residual",
           fmt::format("{} {}: {} rms on held-out runs, {} on fitted ones", equation.quantity,
                       band_words(equation), rms(equation.before.holdout_rms, equation.unit),
                       rms(equation.before.train_rms, equation.unit)));
  text += line("3 noise floor",
               fmt::format("{}; {}", rms(equation.noise_floor_rms, equation.unit),
                           equation.is_noise_before ? "the residual is noise"
                                                    : "there is something to explain"));
  return text;
}

std::string coordinates(const std::vector<ResidualStructure>& structures) {
  std::vector<std::string> parts;
  for (const ResidualStructure& each : significant_of(structures)) {
    if (parts.size() == kMostCoordinates) break;
    parts.push_back(fmt::format("{} ({:.0f} %)", name_of_coordinate(each), 100.0 * each.share));
  }
  return parts.empty() ? "no coordinate beyond chance" : fmt::format("{}", fmt::join(parts, ", "));
}

std::string evidence_lines(const EquationResult& equation) {
  std::string text = line(
      "4 evidence", "the residual's square varies with " + coordinates(equation.structure_before));
  if (!equation.not_excited.empty()) {
    text += line(
        "", fmt::format("not excited, so not judged: {}", fmt::join(equation.not_excited, ", ")));
  }
  return text;
}

std::string bar(double value, double full) {
  const double share = full > 0.0 ? std::clamp(value / full, 0.0, 1.0) : 0.0;
  return std::string(static_cast<std::size_t>(std::lround(kBarLength * share)), '#');
}

std::string waterfall_lines(const EquationResult& equation) {
  const std::vector<WaterfallStep> steps = waterfall(equation);
  std::size_t width = std::string("noise floor").size();
  for (const WaterfallStep& step : steps) width = std::max(width, step.label.size());
  const double full = steps.front().rms;
  const bool is_held_out = equation.before.holdout_rms > 0.0;
  std::string text =
      line("5 selection",
           fmt::format("error on {} runs, {}", is_held_out ? "held-out" : "fitted", equation.unit));
  for (const WaterfallStep& step : steps) {
    text += line(
        "", fmt::format("  {:<{}} {:>9.4g} {}", step.label, width, step.rms, bar(step.rms, full)));
  }
  const double floor = equation.noise_floor_rms;
  return text + line("", fmt::format("  {:<{}} {:>9.4g} {}", "noise floor", width, floor,
                                     bar(floor, full)));
}

/// The error in each run; of many, those in which most is left.
std::string run_lines(const EquationResult& equation) {
  std::vector<RunResult> runs = equation.runs;
  if (runs.size() < 2) return "";
  if (runs.size() > kMostRuns) {
    std::stable_sort(runs.begin(), runs.end(), [](const RunResult& a, const RunResult& b) {
      return a.rms_after > b.rms_after;
    });
    runs.resize(kMostRuns);
  }
  std::vector<std::string> parts;
  for (const RunResult& run : runs) {
    parts.push_back(fmt::format("{}{} {:.4g} -> {:.4g}", run.run,
                                run.is_held_out ? " (held out)" : "", run.rms_before,
                                run.rms_after));
  }
  const std::size_t others = equation.runs.size() - runs.size();
  const std::string more =
      others > 0 ? fmt::format("; less is left in {} more runs (--json)", others) : std::string();
  return line("", fmt::format("by run: {}{}", fmt::join(parts, ", "), more));
}

/// What else the log may hold in the place of what was taken.
std::string model_lines(const EquationResult& equation) {
  std::string text;
  for (std::size_t i = 1; i < std::min(1 + kMostRivals, equation.models.size()); ++i) {
    const ModelWithinNoise& model = equation.models[i];
    text += line("", fmt::format("within the noise as well: {}: {}; would be decided by {}",
                                 name_of_model(model),
                                 rms(shown_error(model.errors), equation.unit), model.decided_by));
  }
  if (equation.models.size() > 1 + kMostRivals) {
    text += line("", fmt::format("within the noise as well: {} more (--json)",
                                 equation.models.size() - 1 - kMostRivals));
  }
  return text;
}

/// Lines that findings do not tell of.
std::string spectral_lines_text(const EquationResult& equation) {
  std::vector<std::string> parts;
  for (const SpectralLine& each : equation.lines) {
    if (is_of_the_data(each)) continue;
    parts.push_back(
        fmt::format("{:.4g} Hz ({:.3g} {})", each.frequency_Hz, each.amplitude, equation.unit));
  }
  if (parts.empty()) return "";
  return line("", fmt::format("lines where the motion repeats, so that a law that is missing may "
                              "sound there: {}",
                              fmt::join(parts, ", ")));
}

std::string effect_lines(const EquationResult& equation) {
  std::string text;
  for (const NamedEffect& effect : equation.added) {
    const std::string whose =
        effect.family == EffectFamily::kActuator
            ? std::string()
            : fmt::format(", corrects the {}", identification::name_of(effect.family));
    const std::string replaced =
        effect.replaces.empty() ? std::string() : fmt::format(", replaces {}", effect.replaces);
    text += line("", fmt::format("added: {}{}{}: {}", effect.effect, whose, replaced,
                                 fmt::join(parameter_texts(effect), ", ")));
    text += line("", "  " + effect.evidence);
    if (!effect.doubt.empty()) text += line("", "  not sure: " + effect.doubt);
  }
  for (const Correction& correction : equation.corrected) {
    text += line("", "corrected: " + correction_text(correction));
  }
  return text;
}

std::string rejection_lines(const EquationResult& equation) {
  std::string text;
  const std::vector<Rejection> rejected = rejections_of(equation);
  const std::size_t shown = std::min(kMostRejected, rejected.size());
  for (std::size_t i = 0; i < shown; ++i) {
    text += line("", fmt::format("rejected: {}: {}", rejected[i].effect, rejected[i].reason));
  }
  if (shown < rejected.size()) {
    text += line("", fmt::format("rejected: {} more (--json)", rejected.size() - shown));
  }
  for (const Confounded& group : equation.confounded) {
    text += line("", fmt::format("{}: {}",
                                 group.exact ? "the same on every such rig" : "the log cannot tell",
                                 alternatives(group.effects)));
    text += line("", fmt::format("  would be separated by {}", group.separated_by));
    if (!group.consequence.empty()) text += line("", "  " + group.consequence);
  }
  return text;
}

std::string left_line(const EquationResult& equation) {
  if (equation.is_noise_after) return line("", "left: noise");
  return line("", fmt::format("left: {} rms, whose square varies with {}",
                              rms(shown_error(equation.after), equation.unit),
                              coordinates(equation.structure_after)));
}

std::string equation_text(const EquationResult& equation, bool select, bool is_only) {
  std::string text;
  if (!is_only) {
    text += fmt::format("\n{}: {}\n", name_of_equation(equation),
                        identification::name_of(equation.verdict));
  }
  if (!equation.unusable.empty()) return text + line("2 residual", equation.unusable);
  text += residual_lines(equation) + evidence_lines(equation);
  if (!select) return text;
  text += waterfall_lines(equation) + run_lines(equation) + effect_lines(equation) +
          rejection_lines(equation) + model_lines(equation);
  return text + left_line(equation) + spectral_lines_text(equation);
}

/// An equation in which nothing is missing, in one line.
std::string noise_line(const EquationResult& equation) {
  if (only_confirms(equation) || equation.after.train_rms != equation.before.train_rms) {
    return fmt::format(
        "\n{}: simulated as stated and with what was found, {} -> {} rms, noise floor "
        "{}\n",
        name_of_equation(equation), rms(shown_error(equation.before), equation.unit),
        rms(shown_error(equation.after), equation.unit),
        rms(equation.noise_floor_rms, equation.unit));
  }
  const double error = shown_error(equation.before);
  return fmt::format("\n{}: {}, {}, noise floor {}\n", name_of_equation(equation),
                     identification::name_of(equation.verdict),
                     error > 0.0 ? rms(error, equation.unit) + " rms" : "no error",
                     rms(equation.noise_floor_rms, equation.unit));
}

std::string refined_lines(const Identification& found, const IdentificationContext& context) {
  if (!context.select) return "";
  std::string text;
  std::string_view step = "6 refined";
  for (const std::string& file : context.refined_files) {
    if (file.empty()) continue;
    text += line(step, "written to " + io::name_in_text(file));
    step = "";
  }
  if (!text.empty() && !context.as_written.empty()) text += line("", context.as_written);
  if (!text.empty() && context.is_fitted_by_simulation)
    text +=
        line("",
             "it holds the values that the simulation fitted to the drives; those of bodies and "
             "encoders are in the report alone");
  const bool is_sure =
      context.is_fitted_by_simulation || identification::has_anything_to_write(found);
  if (text.empty()) {
    text = line(step, is_sure ? "not asked for (--refined)" : "none: there is nothing sure to add");
  }
  return "\n" + text;
}

std::string empirical_lines(const Identification& found) {
  std::string text;
  for (const EmpiricalTable& table : found.tables) {
    text += fmt::format("\nempirical table, no physics, over {}{}: {:.0f} % of what is left\n",
                        table.coordinate, table.times_direction ? " x direction" : "",
                        100.0 * table.share);
    for (std::size_t i = 0; i < table.at.size() && i < table.level.size(); ++i) {
      text += fmt::format("  {:>12.5g} {:>12.5g}\n", table.at[i], table.level[i]);
    }
  }
  return text;
}

std::string headline(const Identification& found, const IdentificationContext& context) {
  const std::string logs = context.log_files.size() > 2
                               ? fmt::format("{} logs", context.log_files.size())
                               : fmt::format("{}", fmt::join(context.log_files, ", "));
  std::string text =
      fmt::format("{} on \"{}\": {}\n{}\n", logs,
                  context.rig_name.empty() ? context.rig_file : context.rig_name,
                  identification::name_of(found.verdict), verdict_sentence(found, context.select));
  const std::string not_asked = not_asked_sentence(found);
  if (!not_asked.empty()) text += not_asked + "\n";
  if (!context.select || found.leading >= found.equations.size()) return text;
  const EquationResult& equation = found.equations[found.leading];
  if (equation.added.empty() && equation.corrected.empty()) return text;
  const bool is_held_out = equation.before.holdout_rms > 0.0;
  return text + fmt::format("Error on {} runs, {}: {:.4g} -> {:.4g} {} rms; noise floor {:.4g}.\n",
                            is_held_out ? "held-out" : "fitted", equation.quantity,
                            shown_error(equation.before), shown_error(equation.after),
                            equation.unit, equation.noise_floor_rms);
}

}  // namespace

std::string identification_text(const Identification& found, const IdentificationContext& context) {
  std::string text = headline(found, context) + "\n" + log_lines(found, context.least);
  const bool is_only = found.equations.size() == 1;
  for (const EquationResult& equation : found.equations) {
    text += is_only || is_of_interest(equation) ? equation_text(equation, context.select, is_only)
                                                : noise_line(equation);
  }
  text += empirical_lines(found) + refined_lines(found, context);
  for (const std::string& step : next_steps(found, context)) text += line("next", step);
  return text;
}

}  // namespace torquewright::report
