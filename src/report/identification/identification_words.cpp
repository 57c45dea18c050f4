// SPDX-License-Identifier: Apache-2.0
#include "src/report/identification/identification_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "identification/answer/refined_json.hpp"
#include "identification/answer/report_spec.hpp"
#include "identification/findings/written.hpp"
#include "src/report/parts/shell_word.hpp"

namespace torquewright::report {
namespace {

using namespace identification;

constexpr int kMostDecimals = 8;

/// The unit that a parameter's name ends with, longest endings first.
std::string_view unit_of_parameter(std::string_view effect, std::string_view name) {
  struct Ending {
    std::string_view name, unit;
  };
  static constexpr std::array<Ending, 12> kEndings = {{{"_Nm_s2_rad2", "Nm s^2/rad^2"},
                                                       {"_Nm_s_rad", "Nm s/rad"},
                                                       {"_Nm_rad", "Nm/rad"},
                                                       {"_kg_m2", "kg m^2"},
                                                       {"_rad_s", "rad/s"},
                                                       {"_1_K", "1/K"},
                                                       {"_ohm", "ohm"},
                                                       {"_Nm", "Nm"},
                                                       {"_rad", "rad"},
                                                       {"_A", "A"},
                                                       {"_V", "V"},
                                                       {"_s", "s"}}};
  for (const Ending& ending : kEndings) {
    if (name.ends_with(ending.name)) return ending.unit;
  }
  if (name != "value") return "";
  if (effect == "current_offset") return "A";
  if (effect == "torque_offset") return "Nm";
  if (effect == "load_inertia_error") return "kg m^2";
  return effect == "load_mass_error" ? "kg" : "";
}

std::string spaced(std::string_view unit) {
  return unit.empty() ? std::string() : " " + std::string(unit);
}

std::string number_text(const FoundNumber& number, std::string_view effect) {
  return fmt::format("{} {}{}", number.name, with_error(number.value, number.standard_error),
                     spaced(unit_of_parameter(effect, number.name)));
}

/// "order 7: amplitude_Nm 0.31 ± 0.01 Nm, phase_rad ..."
std::string wave_text(const FoundWave& wave) {
  return fmt::format("order {:g}: {}, {}", wave.order, number_text(wave.amplitude, ""),
                     number_text(wave.phase_rad, ""));
}

std::string compare_command(const IdentificationContext& context, std::size_t i,
                            const std::string& refined) {
  const std::string nominal =
      i < context.actuator_files.size() ? context.actuator_files[i] : "ACTUATOR";
  const std::string mor = fmt::format("torquewright actuator mor {}", shell_word(refined));
  const bool is_file = i >= context.has_actuator_files.size() || context.has_actuator_files[i];
  return is_file ? fmt::format("{} --compare {}", mor, shell_word(nominal)) : mor;
}

void add_separation(const Identification& found, std::vector<std::string>& steps) {
  for (const EquationResult& equation : found.equations) {
    for (const Confounded& group : equation.confounded) {
      if (group.separated_by.empty()) continue;
      std::string step = fmt::format("measure again with {}", group.separated_by);
      if (std::find(steps.begin(), steps.end(), step) == steps.end())
        steps.push_back(std::move(step));
    }
  }
}

}  // namespace

std::string with_error(double value, double standard_error) {
  if (!std::isfinite(value)) return "unlimited";
  if (!(standard_error > 0.0) || !std::isfinite(standard_error))
    return fmt::format("{:.4g}", value);
  const int decimals = std::max(0, 1 - static_cast<int>(std::floor(std::log10(standard_error))));
  if (decimals > kMostDecimals) return fmt::format("{:.4g} ± {:.2g}", value, standard_error);
  return fmt::format("{:.{}f} ± {:.{}f}", value, decimals, standard_error, decimals);
}

std::vector<std::string> parameter_texts(const NamedEffect& effect) {
  const FoundParameters& found = effect.parameters;
  std::vector<std::string> texts;
  if (!found.channel.empty()) texts.push_back("channel " + found.channel);
  for (const FoundNumber& each : found.numbers) texts.push_back(number_text(each, effect.effect));
  for (const FoundWave& wave : found.waves) texts.push_back(wave_text(wave));
  if (found.proportional.value_or(false)) texts.emplace_back("in proportion to the load");
  return texts;
}

std::string correction_text(const Correction& correction) {
  return fmt::format("{}: stated {:.6g}, fitted {}", correction.pointer, correction.stated,
                     with_error(correction.value, correction.standard_error));
}

std::string band_words(const identification::EquationResult& equation) {
  const bool is_map = !equation.runs.empty() && equation.runs.front().is_map;
  return is_map ? "row by row" : fmt::format("up to {:g} Hz", equation.band_Hz);
}

std::string name_of_equation(const EquationResult& equation) {
  return equation.joint.empty() ? equation.quantity : equation.joint + ": " + equation.quantity;
}

std::string name_of_coordinate(const ResidualStructure& structure) {
  return structure.coordinate + (structure.times_direction ? " x direction" : "");
}

std::string alternatives(const std::vector<std::string>& names) {
  return fmt::format("{}", fmt::join(names, " or "));
}

std::string name_of_model(const ModelWithinNoise& model) {
  std::vector<std::string> names;
  for (const NamedEffect& each : model.effects) names.push_back(each.effect);
  return names.empty() ? "as stated" : fmt::format("{}", fmt::join(names, " + "));
}

std::vector<std::string> next_steps(const Identification& found,
                                    const IdentificationContext& context) {
  std::vector<std::string> steps;
  add_separation(found, steps);
  if (!context.select) {
    if (found.verdict != Verdict::kNothingMissing) {
      steps.emplace_back("the same without \"residual\" looks for the effect that is missing");
    }
    return steps;
  }
  if (found.verdict == Verdict::kUnexplained) {
    steps.emplace_back("--empirical puts a table of what is left into the report");
  }
  const bool has_added = std::any_of(
      found.equations.begin(), found.equations.end(),
      [](const EquationResult& each) { return !each.added.empty() || !each.corrected.empty(); });
  if (!has_added || !identification::has_anything_to_write(found)) return steps;
  if (context.refined_files.empty()) {
    steps.push_back("--refined REFINED writes the refined actuator; then " +
                    compare_command(context, 0, "REFINED"));
  }
  for (std::size_t i = 0; i < context.refined_files.size(); ++i) {
    if (context.refined_files[i].empty()) continue;
    steps.push_back(compare_command(context, i, context.refined_files[i]));
  }
  return steps;
}

std::string written_sentence(const Identification& found, const Identification& judged) {
  std::string text;
  for (const EquationResult& each : found.equations) {
    const auto same = std::find_if(
        judged.equations.begin(), judged.equations.end(), [&](const EquationResult& other) {
          return other.joint == each.joint && other.quantity == each.quantity;
        });
    if (same == judged.equations.end() || each.added.empty()) continue;
    text += fmt::format("{}it leaves {:.4g} {} of {}", text.empty() ? "" : "; ",
                        shown_error(same->before), each.unit, name_of_equation(each));
    for (const NamedEffect* effect : written_of(each)) {
      const std::vector<std::string> others = undecided_with(each, effect->effect);
      if (others.empty()) continue;
      text += fmt::format("; it holds {}, which is not sure: it may be {}", effect->effect,
                          alternatives(others));
    }
  }
  return text;
}

double shown_error(const Errors& errors) {
  return errors.holdout_rms > 0.0 ? errors.holdout_rms : errors.train_rms;
}

std::vector<WaterfallStep> waterfall(const EquationResult& equation) {
  std::vector<WaterfallStep> steps{{"as stated", shown_error(equation.before)}};
  for (const NamedEffect& effect : equation.added) {
    const double rms =
        effect.holdout_rms_after > 0.0 ? effect.holdout_rms_after : equation.after.train_rms;
    steps.push_back({"+ " + effect.effect, rms});
  }
  return steps;
}

bool is_of_interest(const EquationResult& equation) {
  return equation.verdict != Verdict::kNothingMissing || !equation.corrected.empty();
}

}  // namespace torquewright::report
