// SPDX-License-Identifier: Apache-2.0
#include "src/report/identification/identification_plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "src/report/identification/identification_words.hpp"
#include "src/report/parts/gnuplot.hpp"

namespace torquewright::report {
namespace {

using namespace identification;

constexpr int kTracesWidth = 900;
constexpr int kBarHeight = 38;
constexpr int kTracesPanelHeight = 230;
constexpr int kStripHeight = 165;
constexpr std::size_t kMostStrips = 16;
constexpr std::size_t kColumns = 3;
constexpr std::size_t kMostPanels = 9;
constexpr const char* kBefore = "#d55e00";  ///< Told apart by the colour-blind as well.
constexpr const char* kAfter = "#0072b2";
constexpr const char* kMeasured = "#b9c2cb";

/// One coordinate before and after; what opposes the motion is shown so.
struct Panel {
  const ResidualStructure* before = nullptr;
  const ResidualStructure* after = nullptr;
};

const ResidualStructure* same(const std::vector<ResidualStructure>& structures,
                              const ResidualStructure& as) {
  for (const ResidualStructure& each : structures) {
    if (each.coordinate == as.coordinate && each.times_direction == as.times_direction) {
      return &each;
    }
  }
  return nullptr;
}

/// What only some logs hold: where no channel did, the values are the model's.
struct LoggedCoordinate {
  std::string_view coordinate;
  std::vector<std::string_view> channels;  ///< One of them.
};

bool is_logged(const std::string& coordinate, const std::vector<std::string>& logged) {
  static const std::vector<LoggedCoordinate> kOptional = {
      {"motor_current_A", {"motor_current_A"}},
      {"load_torque_Nm", {"output_torque_Nm", "linear_force_N"}},
      {"power_W", {"output_torque_Nm", "linear_force_N"}},
      {"winding_temperature_K", {"winding_temperature_K", "case_temperature_K"}}};
  const auto found =
      std::find_if(kOptional.begin(), kOptional.end(),
                   [&](const LoggedCoordinate& each) { return each.coordinate == coordinate; });
  return found == kOptional.end() ||
         std::any_of(found->channels.begin(), found->channels.end(), [&](std::string_view channel) {
           return std::find(logged.begin(), logged.end(), channel) != logged.end();
         });
}

/// With its unit, where its name does not end in one.
std::string axis_title(const ResidualStructure& structure) {
  std::string_view unit;
  if (structure.coordinate == "electrical_angle") unit = ", rad";
  if (structure.coordinate == "time_since_reversal") unit = ", s";
  return name_of_coordinate(structure) + std::string(unit);
}

/// Each coordinate that was logged once, as the table that explains more; the strongest first.
std::vector<Panel> panels_of(const EquationResult& equation,
                             const std::vector<std::string>& logged) {
  std::vector<Panel> panels;
  for (const ResidualStructure& each : equation.structure_before) {
    if (each.centre.empty() || each.centre.size() != each.level.size()) continue;
    if (!is_logged(each.coordinate, logged)) continue;
    const auto known = std::find_if(panels.begin(), panels.end(), [&](const Panel& panel) {
      return panel.before->coordinate == each.coordinate;
    });
    if (known == panels.end()) {
      panels.push_back({&each, nullptr});
    } else if (each.share > known->before->share) {
      known->before = &each;
    }
  }
  std::stable_sort(panels.begin(), panels.end(), [](const Panel& a, const Panel& b) {
    return a.before->share > b.before->share;
  });
  if (panels.size() > kMostPanels) panels.resize(kMostPanels);
  for (Panel& panel : panels) panel.after = same(equation.structure_after, *panel.before);
  return panels;
}

std::string data_block(const std::string& name, const ResidualStructure* structure) {
  std::string text = "$" + name + " << END\n";
  for (std::size_t i = 0; structure != nullptr && i < structure->level.size(); ++i) {
    if (!std::isfinite(structure->centre[i]) || !std::isfinite(structure->level[i])) continue;
    text += fmt::format("{:.7g},{:.7g}\n", structure->centre[i], structure->level[i]);
  }
  return text + "END\n";
}

double percent(const ResidualStructure* structure) {
  return structure == nullptr ? 0.0 : 100.0 * std::max(0.0, structure->share);
}

std::string panel_script(const Panel& panel, std::size_t index, const std::string& unit) {
  const std::string before = fmt::format("before{}", index), after = fmt::format("after{}", index);
  std::string script = data_block(before, panel.before) + data_block(after, panel.after);
  script +=
      fmt::format("set title {}\nset xlabel {} offset 0,0.6\nset ylabel {} offset 1,0\n",
                  gnuplot_quoted(fmt::format("{:.0f} % → {:.0f} % explained by it",
                                             percent(panel.before), percent(panel.after))),
                  gnuplot_quoted(axis_title(*panel.before)), gnuplot_quoted("residual, " + unit));
  script += fmt::format(
      "plot ${} using 1:2 with linespoints pointtype 7 pointsize 0.45 linewidth 1.6 linecolor rgb "
      "'{}' notitle 'residual before'",
      before, kBefore);
  if (panel.after != nullptr) {
    script += fmt::format(
        ", ${} using 1:2 with linespoints pointtype 7 pointsize 0.45 linewidth 1.6 linecolor rgb "
        "'{}' notitle 'residual after'",
        after, kAfter);
  }
  return script + "\n";
}

/// Times count from the run's beginning; a gap is an empty line.
std::string curve_block(const std::string& name, const identification::Curve& curve,
                        double begin_s) {
  std::string text = "$" + name + " << END\n";
  for (std::size_t i = 0; i < curve.value.size(); ++i) {
    text += std::isfinite(curve.value[i])
                ? fmt::format("{:.6g},{:.6g}\n", curve.time_s[i] - begin_s, curve.value[i])
                : "\n";
  }
  return text + "END\n";
}

std::string strip_script(const RunResult& run, const EquationResult& equation, std::size_t index,
                         bool is_refined) {
  struct Drawn {
    const char* name;
    const identification::Curve& curve;
    const char* color;
    double width;
  };
  std::vector<Drawn> all = {{"measured", run.measured, kMeasured, 4.0},
                            {"stated", run.stated, kBefore, 1.3}};
  if (is_refined) all.push_back({"refined", run.refined, kAfter, 1.3});
  const double begin_s = run.measured.time_s.empty() ? 0.0 : run.measured.time_s.front();
  std::string script, curves;
  for (const Drawn& each : all) {
    const std::string block = fmt::format("{}{}", each.name, index);
    script += curve_block(block, each.curve, begin_s);
    curves += fmt::format("{}${} using 1:2 with lines linewidth {} linecolor rgb '{}' notitle '{}'",
                          curves.empty() ? "" : ", ", block, each.width, each.color, each.name);
  }
  const std::string errors = is_refined
                                 ? fmt::format("{:.3g} → {:.3g}", run.rms_before, run.rms_after)
                                 : fmt::format("{:.3g}", run.rms_before);
  script += fmt::format(
      "set title {}\nset xlabel \"{}\" offset 0,0.6\nset ylabel {}\nplot {}\n",
      gnuplot_quoted(fmt::format("{}{}: {} {} rms", run.run, run.is_held_out ? ", held out" : "",
                                 errors, equation.unit)),
      run.is_map ? "sample" : "time from the run's begin, s", gnuplot_quoted(equation.unit),
      curves);
  return script;
}

std::string thin_axes() {
  return "set border 3 linecolor rgb '#888888'\nset tics nomirror scale 0.5 textcolor rgb "
         "'#333333'\n"
         "set grid linecolor rgb '#e6e6e6' linewidth 1 linetype 1\nset datafile separator ','\n";
}

}  // namespace

std::string waterfall_plot(const EquationResult& equation) {
  const std::vector<WaterfallStep> steps = waterfall(equation);
  double most = equation.noise_floor_rms;
  for (const WaterfallStep& step : steps) most = std::max(most, step.rms);
  const int height = 90 + kBarHeight * static_cast<int>(steps.size());
  std::string script = gnuplot_terminal(PlotFormat::kSvg, kTracesWidth, height) + thin_axes();
  script += "$bars << END\n";
  std::string labels;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    script += fmt::format("{},{:.7g},{},{:.4g}\n", i, steps[i].rms, i == 0 ? 0xd55e00 : 0x0072b2,
                          steps[i].rms);
    labels += fmt::format("{}{} {}", i == 0 ? "" : ", ", gnuplot_quoted(steps[i].label), i);
  }
  script += "END\n";
  script +=
      fmt::format("set xrange [0:{:.7g}]\nset yrange [{}:-0.6]\nset ytics ({})\n",
                  most > 0.0 ? 1.16 * most : 1.0, static_cast<double>(steps.size()) - 0.4, labels);
  script +=
      fmt::format("set xlabel {} offset 0,0.4\nset style fill solid 1.0 noborder\nunset key\n",
                  gnuplot_quoted("rms error on runs that were not fitted, " + equation.unit));
  if (equation.noise_floor_rms > 0.0) {
    script += fmt::format(
        "set arrow from {0:.7g}, graph 0 to {0:.7g}, graph 1 nohead front dashtype 2 linewidth 1.5 "
        "linecolor rgb '#222222'\n"
        "set label 'noise floor {0:.3g}' at {0:.7g}, graph 1.0 offset 0.4,0.5 font ',10'\n",
        equation.noise_floor_rms);
  }
  script += "set tmargin 2\nset rmargin 3\n";
  script +=
      "plot $bars using ($2/2):1:(0):2:($1-0.3):($1+0.3):3 with boxxyerror linecolor rgb variable, "
      "'' using 2:1:4 with labels left offset 0.7,0 textcolor rgb '#222222'\n";
  return script;
}

std::vector<const RunResult*> shown_runs(const EquationResult& equation) {
  std::vector<const RunResult*> runs;
  for (const RunResult& run : equation.runs) runs.push_back(&run);
  if (runs.size() <= kMostStrips) return runs;
  const auto comes_first = [](const RunResult* a, const RunResult* b) {
    if (a->is_held_out != b->is_held_out) return a->is_held_out;
    return a->rms_after > b->rms_after;
  };
  std::stable_sort(runs.begin(), runs.end(), comes_first);
  runs.resize(kMostStrips);
  std::sort(runs.begin(), runs.end());
  return runs;
}

std::string run_plot(const EquationResult& equation) {
  const std::vector<const RunResult*> strips = shown_runs(equation);
  if (strips.empty()) return "";
  const bool is_refined = !equation.added.empty() || !equation.corrected.empty();
  std::string script = gnuplot_terminal(PlotFormat::kSvg, kTracesWidth,
                                        static_cast<int>(strips.size()) * kStripHeight) +
                       thin_axes();
  script +=
      "set title font ',10' offset 0,-0.6\nset tics font ',9'\nset format y '%.3g'\nset ytics font "
      "',8'\n";
  script += fmt::format("set lmargin 9\nset multiplot layout {},1\n", strips.size());
  for (std::size_t i = 0; i < strips.size(); ++i) {
    script += strip_script(*strips[i], equation, i, is_refined);
  }
  return script + "unset multiplot\n";
}

std::string structure_plot(const EquationResult& equation, const std::vector<std::string>& logged) {
  const std::vector<Panel> panels = panels_of(equation, logged);
  if (panels.empty()) return "";
  const std::size_t rows = (panels.size() + kColumns - 1) / kColumns;
  std::string script = gnuplot_terminal(PlotFormat::kSvg, kTracesWidth,
                                        static_cast<int>(rows) * kTracesPanelHeight) +
                       thin_axes();
  script += "set xzeroaxis linetype 1 linecolor rgb '#888888'\nset title font ',10'\n";
  script += "set format x '%.3g'\nset format y '%.2g'\nset tics font ',9'\nset xtics autofreq\n";
  script += fmt::format("set multiplot layout {},{}\n", rows, kColumns);
  for (std::size_t i = 0; i < panels.size(); ++i)
    script += panel_script(panels[i], i, equation.unit);
  return script + "unset multiplot\n";
}

}  // namespace torquewright::report
