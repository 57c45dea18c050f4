// SPDX-License-Identifier: Apache-2.0
#include "src/report/identification/identification_html.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "identification/answer/report_spec.hpp"
#include "io/documents/provenance.hpp"
#include "io/text/one_line.hpp"
#include "src/report/identification/identification_plots.hpp"
#include "src/report/identification/identification_runs_html.hpp"
#include "src/report/identification/identification_verdict.hpp"
#include "src/report/identification/robot_html.hpp"
#include "src/report/parts/embedded_page.hpp"
#include "src/report/parts/html_page.hpp"
#include "src/report/parts/svg.hpp"

namespace torquewright::report {
namespace {

using namespace identification;

/// Lines stay lines.
std::string escaped_lines(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    result += escaped(text.substr(0, end)) + "\n";
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return result;
}

std::string paragraph(const std::string& text) { return "<p>" + escaped(text) + "</p>\n"; }

std::string list(const std::vector<std::string>& items) {
  if (items.empty()) return "";
  std::string text = "<ul>\n";
  for (const std::string& item : items) text += "<li>" + escaped(item) + "</li>\n";
  return text + "</ul>\n";
}

std::string rms_text(double value, const std::string& unit) {
  return value > 0.0 ? fmt::format("{:.4g} {}", value, unit) : "not measured";
}

std::string card(const std::string& figure, const std::string& what) {
  return fmt::format("<div class=\"card\"><b>{}</b><span>{}</span></div>\n", escaped(figure),
                     escaped(what));
}

std::string badge(Verdict verdict) {
  return fmt::format("<span class=\"badge {0}\">{0}</span>", identification::name_of(verdict));
}

std::string cards(const Identification& found) {
  if (found.leading >= found.equations.size()) return "";
  const EquationResult& equation = found.equations[found.leading];
  if (!equation.unusable.empty()) return "";
  const bool is_held_out = equation.before.holdout_rms > 0.0;
  const std::string runs = is_held_out ? "held-out" : "fitted";
  std::string text = "<div class=\"cards\">\n";
  text += card(rms_text(shown_error(equation.before), equation.unit),
               fmt::format("error as stated, {} runs", runs));
  text += card(rms_text(shown_error(equation.after), equation.unit),
               fmt::format("error of the refined model, {} runs", runs));
  text += card(rms_text(equation.noise_floor_rms, equation.unit), "noise floor");
  text += card(fmt::format("{} + {}", found.train_runs.size(), found.holdout_runs.size()),
               "runs fitted + held out");
  return text + "</div>\n";
}

std::string effects_table(const EquationResult& equation) {
  if (equation.added.empty()) return "";
  std::string text =
      "<h3>Effects that earned their place</h3>\n<table><tr><th>effect</th><th>parameters</th>"
      "<th>error before → after</th><th>evidence</th></tr>\n";
  for (const NamedEffect& effect : equation.added) {
    std::string parameters;
    for (const std::string& each : parameter_texts(effect)) {
      parameters += (parameters.empty() ? "" : "<br/>") + escaped(each);
    }
    const std::string place =
        effect.family == EffectFamily::kActuator
            ? "of the actuator"
            : fmt::format("corrects the {}", identification::name_of(effect.family));
    text += fmt::format(
        "<tr><td><b>{}</b><br/><span class=\"soft\">{}{}</span></td><td>{}</td><td "
        "class=\"number\">{:.4g} → {:.4g} {}</td><td>{}</td></tr>\n",
        escaped(effect.effect), place,
        effect.replaces.empty() ? "" : escaped(", replaces " + effect.replaces), parameters,
        effect.holdout_rms_before, effect.holdout_rms_after, escaped(equation.unit),
        escaped(effect.evidence +
                (effect.doubt.empty() ? "" : " Not sure: " + effect.doubt + ".")));
  }
  return text + "</table>\n";
}

std::string corrections(const EquationResult& equation) {
  std::vector<std::string> items;
  for (const Correction& each : equation.corrected) items.push_back(correction_text(each));
  return items.empty() ? "" : "<h3>Uncertain values, fitted</h3>\n" + list(items);
}

std::string rejections(const EquationResult& equation) {
  const std::vector<Rejection> rejected = rejections_of(equation);
  if (rejected.empty()) return "";
  std::string text = "<h3>Rejected, and why</h3>\n<table>\n";
  for (const Rejection& each : rejected) {
    text += fmt::format("<tr><td>{}</td><td>{}</td></tr>\n", escaped(each.effect),
                        escaped(each.reason));
  }
  return text + "</table>\n";
}

std::string groups(const EquationResult& equation) {
  std::vector<std::string> items;
  for (const Confounded& group : equation.confounded) {
    items.push_back(fmt::format("{}: {}. Would be separated by {}. {}",
                                group.exact ? "The same on every such rig" : "Not told apart",
                                alternatives(group.effects), group.separated_by,
                                group.consequence));
  }
  return items.empty() ? "" : "<h3>Confounded</h3>\n" + list(items);
}

std::string remainder(const EquationResult& equation) {
  std::string text = "<h3>What is left</h3>\n";
  const std::vector<ResidualStructure> left = significant_of(equation.structure_after);
  if (equation.is_noise_after) return text + paragraph("Noise.");
  if (left.empty()) {
    return text + paragraph("More than noise, but along no coordinate that was tried.");
  }
  std::vector<std::string> items;
  for (const ResidualStructure& each : left) items.push_back(sentence_of(each));
  return text + list(items);
}

std::string coordinates_section(const EquationResult& equation,
                                const std::vector<std::string>& logged, Pictures& pictures) {
  const std::string picture = pictures.draw(structure_plot(equation, logged),
                                            "Residual over each coordinate, before and after");
  if (picture.empty()) return "";
  return "<h3>Residual along each coordinate</h3>\n<p class=\"soft\"><span class=\"key\" "
         "style=\"background:#d55e00\"></span>as stated <span class=\"key\" "
         "style=\"background:#0072b2\"></span>refined; the share of the residual that the "
         "coordinate explains where it was not fitted, before → after</p>\n" +
         picture;
}

/// What a model adds, with its numbers.
std::string model_cell(const ModelWithinNoise& model) {
  std::string cell;
  for (const NamedEffect& effect : model.effects) {
    cell += fmt::format("<b>{}</b><br/>", escaped(effect.effect));
    for (const std::string& each : parameter_texts(effect)) cell += escaped(each) + "<br/>";
  }
  return cell.empty() ? escaped(name_of_model(model)) : cell;
}

std::string models_table(const EquationResult& equation) {
  if (equation.models.size() < 2) return "";
  std::string text = fmt::format(
      "<h3>Models within the noise</h3>\n<table><tr><th>effects</th><th>fitted, {0}</th><th>held "
      "out, {0}</th><th>would be decided by</th></tr>\n",
      escaped(equation.unit));
  for (const ModelWithinNoise& model : equation.models) {
    text += fmt::format(
        "<tr><td>{}</td><td class=\"number\">{}</td><td class=\"number\">{}</td><td>{}</td></tr>\n",
        model_cell(model), fmt::format("{:.4g}", model.errors.train_rms),
        model.errors.holdout_rms > 0.0 ? fmt::format("{:.4g}", model.errors.holdout_rms) : "none",
        model.decided_by.empty() ? "the one that was taken" : escaped(model.decided_by));
  }
  return text + "</table>\n";
}

std::string lines_section(const EquationResult& equation) {
  std::vector<std::string> items;
  for (const SpectralLine& each : equation.lines)
    items.push_back(sentence_of(each, equation.quantity, equation.unit));
  return items.empty() ? "" : "<h3>Lines in the spectrum of what is left</h3>\n" + list(items);
}

std::string equation_section(const EquationResult& equation, const IdentificationContext& context,
                             Pictures& pictures) {
  const bool select = context.select;
  std::string text = fmt::format(
      "<section>\n<h2>{} {}</h2>\n", escaped(name_of_equation(equation)),
      only_confirms(equation) ? "<span class=\"soft\">simulated, no verdict of its own</span>"
                              : badge(equation.verdict));
  if (!equation.unusable.empty()) return text + paragraph(equation.unusable) + "</section>\n";
  text += paragraph(fmt::format(
      "The residual {} is {} rms on held-out runs, {} on fitted ones; the noise floor is {}.",
      band_words(equation), rms_text(equation.before.holdout_rms, equation.unit),
      rms_text(equation.before.train_rms, equation.unit),
      rms_text(equation.noise_floor_rms, equation.unit)));
  if (select)
    text += pictures.draw(waterfall_plot(equation),
                          "Error on runs that were not fitted, after each effect") +
            effects_table(equation);
  text += corrections(equation) + runs_section(equation, pictures) +
          coordinates_section(equation, context.logged, pictures);
  if (select) text += remainder(equation);
  text += lines_section(equation);
  if (select) text += groups(equation) + models_table(equation) + rejections(equation);
  if (!equation.not_excited.empty()) {
    text += "<h3>Not excited by this log, so not judged</h3>\n" +
            paragraph(fmt::format("{}", fmt::join(equation.not_excited, ", ")));
  }
  return text + "</section>\n";
}

std::string region_section(const RegionSection& region, Pictures& pictures) {
  return fmt::format(
      "<section>\n<h2>Operating region, refined over stated{}</h2>\n{}<pre>{}</pre>\n</section>\n",
      region.joint.empty() ? "" : escaped(": " + region.joint),
      pictures.draw(region.plot, "Torque over speed, as stated and refined"),
      escaped_lines(region.comparison));
}

std::string data_section(const Identification& found, const IdentificationContext& context) {
  std::string text = "<section>\n<h2>Data</h2>\n<table>\n";
  const auto row = [&](const char* what, const std::string& value) {
    text += fmt::format("<tr><td>{}</td><td>{}</td></tr>\n", what, escaped(value));
  };
  row("rig", fmt::format("{} ({})", context.rig_name, context.rig_file));
  row("actuator", io::one_line(fmt::format("{}", fmt::join(context.actuator_files, ", "))));
  row("runs fitted", fmt::format("{}", fmt::join(found.train_runs, ", ")));
  row("runs held out", fmt::format("{}", fmt::join(found.holdout_runs, ", ")));
  for (const Log::File& file : found.files) {
    row("log", fmt::format("{}, sha256 {}", file.path, file.sha256));
  }
  static constexpr const char* kWeights[] = {"note", "warning", "error"};
  for (const DataFinding& finding : found.findings) {
    row(kWeights[static_cast<int>(finding.weight)], finding.sentence);
  }
  row("noise floor", noise_floor_method());
  return text + "</table>\n</section>\n";
}

std::string head(const Identification& found, const IdentificationContext& context) {
  const std::string title = fmt::format(
      "{}: is the model true?", context.rig_name.empty() ? context.rig_file : context.rig_name);
  const auto verdict = identification::name_of(found.verdict);
  std::string text = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
      "<title>{0}</title>\n<style>{1}{3}{4}</style>\n</head>\n<body>\n<main>\n<section>\n<h1>{0} "
      "<span "
      "class=\"badge "
      "{2}\">{2}</span></h1>\n",
      escaped(title), kPageStyle, verdict, kHopperStyle, kResidualStyle);
  text += paragraph(verdict_sentence(found, context.select));
  const std::string not_asked = not_asked_sentence(found);
  if (!not_asked.empty()) text += paragraph(not_asked);
  text += cards(found);
  std::vector<std::string> steps = next_steps(found, context);
  for (std::string& step : steps) step = io::one_line(step);
  if (!steps.empty()) text += "<h3>Next</h3>\n" + list(steps);
  return text + "</section>\n";
}

std::string tables_section(const Identification& found) {
  std::string text;
  for (const EmpiricalTable& table : found.tables) {
    text += fmt::format(
        "<section>\n<h2>Empirical table, no physics: {}{}</h2>\n<p>{:.0f} % of what is left.</p>\n"
        "<table>\n",
        escaped(table.coordinate), table.times_direction ? " x direction" : "",
        100.0 * table.share);
    for (std::size_t i = 0; i < table.at.size() && i < table.level.size(); ++i) {
      text +=
          fmt::format("<tr><td class=\"number\">{:.5g}</td><td class=\"number\">{:.5g}</td></tr>\n",
                      table.at[i], table.level[i]);
    }
    text += "</table>\n</section>\n";
  }
  return text;
}

}  // namespace

std::string identification_html(const Identification& found, const IdentificationContext& context,
                                const std::vector<RegionSection>& regions,
                                const RobotReport* robot) {
  Pictures pictures("--report");
  std::string text = head(found, context);
  if (robot != nullptr) text += robot_section(found, *robot, pictures);
  for (const EquationResult& equation : found.equations) {
    text += equation_section(equation, context, pictures);
  }
  text += tables_section(found);
  for (const RegionSection& region : regions) text += region_section(region, pictures);
  text += data_section(found, context);
  return text + fmt::format("<p class=\"soft\">torquewright {}</p>\n</main>\n</body>\n</html>\n",
                            io::tool_version());
}

}  // namespace torquewright::report
