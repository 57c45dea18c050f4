// SPDX-License-Identifier: Apache-2.0
#include "src/report/identification/identification_runs_html.hpp"

#include <fmt/format.h>

#include "src/report/identification/identification_plots.hpp"
#include "src/report/identification/identification_words.hpp"
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

}  // namespace

std::string runs_section(const EquationResult& equation, Pictures& pictures) {
  if (equation.runs.empty()) return "";
  const std::size_t shown = plotted_runs(equation);
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
      "than 600 points the least and the greatest of each three-hundredth{}</p>\n{}{}",
      band_words(equation), which,
      pictures.draw(run_plot(equation), "Measured and predicted by time, run by run"),
      runs_table(equation));
}

}  // namespace torquewright::report
