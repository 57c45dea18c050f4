// SPDX-License-Identifier: Apache-2.0
#include "src/report/identification/identification_runs_html.hpp"

#include <fmt/format.h>

#include "src/report/identification/identification_plots.hpp"
#include "src/report/identification/identification_words.hpp"
#include "src/report/parts/chart.hpp"
#include "src/report/parts/page_parts.hpp"
#include "src/report/parts/svg.hpp"

namespace torquewright::report {
namespace {

using namespace identification;

std::string runs_table(const EquationResult& equation) {
  std::string text = fmt::format(
      "<table><tr><th>run</th><th></th><th>error as stated, {0}</th><th>error refined, "
      "{0}</th></tr>\n",
      escaped(equation.unit));
  for (const RunResult& run : equation.runs) {
    text += fmt::format(
        "<tr><td>{}</td><td>{}</td><td class=\"number\">{:.4g}</td><td "
        "class=\"number\">{:.4g}</td></tr>\n",
        escaped(run.run), run.is_held_out ? "<b>held out</b>" : "fitted", run.rms_before,
        run.rms_after);
  }
  return text + "</table>\n";
}

/// One run's residual on a scale of its own: beside torques of 20 Nm an error of 1 is not seen.
std::string residual_chart(const RunResult& run, const Curve& left, double rms,
                           const EquationResult& equation, bool is_after) {
  const Eigen::VectorXd value =
      Eigen::Map<const Eigen::VectorXd>(left.value.data(), std::ssize(left.value));
  Eigen::VectorXd time_s =
      Eigen::Map<const Eigen::VectorXd>(left.time_s.data(), std::ssize(left.time_s));
  time_s.array() -= time_s[0];
  Axis y = axis_of("measured less predicted, " + equation.unit, value);
  y.include(0.0);
  const Axis x = axis_of(run.is_map ? "sample" : "time from the run's begin, s", time_s);
  Chart chart(x.roomy(0.0), y.roomy(0.06));
  chart.curve(is_after ? "left after" : "left before", time_s, value);
  const char* model = is_after ? "refined" : "as stated";
  return panel_of(fmt::format("{}{}, {}: {:.3g} {} rms", run.run,
                              run.is_held_out ? ", held out" : "", model, rms, equation.unit),
                  chart.svg(fmt::format("Residual of the run {}, {}: from {:.3g} to {:.3g} {}.",
                                        run.run, model, y.low, y.high, equation.unit)));
}

std::string residuals(const EquationResult& equation) {
  const bool is_refined = !equation.added.empty() || !equation.corrected.empty();
  std::string charts;
  for (const RunResult* run : shown_runs(equation)) {
    if (run->left_before.value.empty()) continue;
    charts += residual_chart(*run, run->left_before, run->rms_before, equation, false);
    if (!is_refined || run->left_after.value.empty()) continue;
    charts += residual_chart(*run, run->left_after, run->rms_after, equation, true);
  }
  return charts.empty() ? ""
                        : "<h3>What is left by time, run by run</h3>\n<p class=\"soft\">Each chart "
                          "has a scale of its own.</p>\n" +
                              panels(charts);
}

}  // namespace

const char* const kResidualStyle =
    ".chart path.left{stroke-width:1.3}.chart path.before{stroke:#d55e00}"
    ".chart path.after{stroke:#0072b2}@media (prefers-color-scheme:dark){.chart path.before"
    "{stroke:#ff9248}.chart path.after{stroke:#5cb3ec}}";

std::string runs_section(const EquationResult& equation, Pictures& pictures) {
  if (equation.runs.empty()) return "";
  const std::size_t shown = shown_runs(equation).size();
  const std::string which =
      shown < equation.runs.size()
          ? fmt::format(
                "; {} runs of {}: those that are held out, then those of which most is left", shown,
                equation.runs.size())
          : std::string();
  return fmt::format(
      "<h3>Measured and predicted, run by run</h3>\n<p class=\"soft\"><span class=\"key\" "
      "style=\"background:#b9c2cb\"></span>measured <span class=\"key\" "
      "style=\"background:#d55e00\"></span>as stated <span class=\"key\" "
      "style=\"background:#0072b2\"></span>refined; {}, where a point was used; of more "
      "than 600 points the least and the greatest of each three-hundredth{}</p>\n{}{}{}",
      band_words(equation), which,
      pictures.draw(run_plot(equation), "Measured and predicted by time, run by run"),
      residuals(equation), runs_table(equation));
}

}  // namespace torquewright::report
