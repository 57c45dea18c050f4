// SPDX-License-Identifier: Apache-2.0
#include "src/report/identification/robot_html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "identification/answer/report_spec.hpp"
#include "identification/findings/joint_verdicts.hpp"
#include "src/report/identification/identification_words.hpp"
#include "src/report/parts/gnuplot.hpp"
#include "src/report/parts/svg.hpp"

namespace torquewright::report {
namespace {

using namespace identification;

constexpr int kStripWidth = 900, kJointStrip = 110;
constexpr std::size_t kMostJointStrips = 32;

std::string cell(const std::string& text) { return "<td>" + escaped(text) + "</td>"; }

const NamedEffect* effect_of(const JointVerdict& joint, const std::string& name) {
  for (const EquationResult* equation : joint.equations) {
    for (const NamedEffect& each : equation->added) {
      if (each.effect == name) return &each;
    }
  }
  return nullptr;
}

std::vector<std::string> effect_names(const std::vector<JointVerdict>& joints) {
  std::vector<std::string> names;
  for (const JointVerdict& joint : joints) {
    for (const EquationResult* equation : joint.equations) {
      for (const NamedEffect& each : equation->added) {
        if (std::find(names.begin(), names.end(), each.effect) == names.end()) {
          names.push_back(each.effect);
        }
      }
    }
  }
  return names;
}

std::string effect_cell(const JointVerdict& joint, const std::string& name) {
  const NamedEffect* effect = effect_of(joint, name);
  if (effect == nullptr) return "<td></td>";
  std::string text;
  for (const std::string& each : parameter_texts(*effect)) {
    text += (text.empty() ? "" : "<br/>") + escaped(each);
  }
  if (!effect->doubt.empty()) text += "<br/><span class=\"soft\">not sure</span>";
  return "<td>" + text + "</td>";
}

/// The coordinate with which most goes of what is left in the joint's first equation.
std::string left_at(const JointVerdict& joint) {
  const EquationResult& equation = *joint.equations.front();
  if (!equation.unusable.empty()) return equation.unusable;
  if (equation.is_noise_after) return "noise";
  const auto left = significant_of(equation.structure_after);
  const std::string size = fmt::format("{:.3g} {}", shown_error(equation.after), equation.unit);
  if (left.empty()) return size;
  return fmt::format("{}, {:.0f} % of its square along {}", size, 100.0 * left.front().share,
                     name_of_coordinate(left.front()));
}

std::string error_cell(const SimulatedErrors& errors, std::size_t joint) {
  const auto text = [&](const RobotErrors& of) {
    const std::vector<double>& all = judged(of.whole).by_joint_rad;
    return joint < all.size() ? fmt::format("{:.3g}", 1e3 * all[joint]) : std::string("none");
  };
  return fmt::format("<td class=\"number\">{}{}</td>", text(errors.before),
                     errors.is_refined ? " → " + text(errors.after) : "");
}

std::string joints_table(const Identification& found, const RobotReport& robot) {
  const std::vector<JointVerdict> joints = joint_verdicts(found.equations);
  const std::vector<std::string> names = effect_names(joints);
  std::string text =
      "<table><tr><th>joint</th><th>balance of torques</th><th>simulated, mrad</th><th>left in the "
      "balance</th>";
  for (const std::string& name : names) text += "<th>" + escaped(name) + "</th>";
  text += "</tr>\n";
  for (const JointVerdict& joint : joints) {
    const auto& all = robot.errors.joints;
    const auto place = std::find(all.begin(), all.end(), joint.joint) - all.begin();
    text += "<tr>" + cell(joint.joint) + cell(std::string(identification::name_of(joint.verdict))) +
            error_cell(robot.errors, static_cast<std::size_t>(place)) + cell(left_at(joint));
    for (const std::string& name : names) text += effect_cell(joint, name);
    text += "</tr>\n";
  }
  return text + "</table>\n";
}

std::string value_cell(const FittedValue& value) {
  if (!value.is_told()) return "<td class=\"soft\">not told</td>";
  return "<td>" + escaped(with_error(value.value, value.standard_error)) + "</td>";
}

/// A column for each number that some joint has, a row for each joint.
std::string values_table(const RobotReport& robot) {
  std::vector<std::string> names;
  const auto label = [](const FittedValue& each) {
    return each.which.effect.empty() ? each.which.name : each.which.effect + ": " + each.which.name;
  };
  for (const FittedValue& each : robot.study->fit.values) {
    if (each.which.is_of_all()) continue;
    if (std::find(names.begin(), names.end(), label(each)) == names.end())
      names.push_back(label(each));
  }
  std::string text = "<table><tr><th>joint</th>";
  for (const std::string& name : names) text += "<th>" + escaped(name) + "</th>";
  text += "</tr>\n";
  for (std::size_t joint = 0; joint < robot.errors.joints.size(); ++joint) {
    text += "<tr>" + cell(robot.errors.joints[joint]);
    for (const std::string& name : names) {
      const auto& values = robot.study->fit.values;
      const auto own = std::find_if(values.begin(), values.end(), [&](const FittedValue& each) {
        return !each.which.is_of_all() && each.which.joint == joint && label(each) == name;
      });
      text += own == values.end() ? "<td></td>" : value_cell(*own);
    }
    text += "</tr>\n";
  }
  return text + "</table>\n";
}

std::string told_text(const RobotStudy& study) {
  std::string text;
  for (const LoadRank& each : study.load.limbs) {
    if (each.of == 0) continue;
    text += fmt::format("{}{}: {} of {}", text.empty() ? "" : "; ", each.bodies.back(), each.told,
                        each.of);
  }
  return text.empty() ? ""
                      : "<p class=\"soft\">Of mass and centre of the bodies of each limb, by its "
                        "last body, the motion tells so many numbers: " +
                            escaped(text) + ".</p>\n";
}

/// The first that no fit saw, else the first.
const RolloutTrace* shown_trace(const RobotErrors& errors) {
  const auto& traces = errors.whole.traces;
  const auto held_out = std::find_if(traces.begin(), traces.end(),
                                     [](const RolloutTrace& each) { return each.is_held_out; });
  if (held_out != traces.end()) return &*held_out;
  return traces.empty() ? nullptr : &traces.front();
}

std::string curve_data(const std::string& name, const identification::Curve& curve) {
  std::string text = "$" + name + " << END\n";
  for (std::size_t i = 0; i < curve.value.size(); ++i) {
    text += fmt::format("{:.6g},{:.6g}\n", curve.time_s[i], 1e3 * curve.value[i]);
  }
  return text + "END\n";
}

}  // namespace

std::string joint_errors_plot(const SimulatedErrors& errors) {
  const RolloutTrace* before = shown_trace(errors.before);
  const RolloutTrace* after = errors.is_refined ? shown_trace(errors.after) : nullptr;
  if (before == nullptr) return "";
  const std::size_t strips = std::min(kMostJointStrips, before->error_rad.size());
  std::string script =
      gnuplot_terminal(PlotFormat::kSvg, kStripWidth, kJointStrip * static_cast<int>(strips)) +
      "set border 3 linecolor rgb '#888888'\nset tics nomirror scale 0.5 font ',8'\n"
      "set grid linecolor rgb '#e6e6e6' linewidth 1 linetype 1\nset datafile separator ','\n"
      "set title font ',10' offset 0,-0.7\nset lmargin 9\nset xzeroaxis\nset ytics autofreq\n";
  script += fmt::format("set multiplot layout {},1\n", strips);
  for (std::size_t joint = 0; joint < strips; ++joint) {
    script += curve_data(fmt::format("before{}", joint), before->error_rad[joint]);
    std::string curves = fmt::format(
        "$before{} using 1:2 with lines linewidth 1.3 linecolor rgb '#d55e00' notitle 'error "
        "before'",
        joint);
    if (after != nullptr && joint < after->error_rad.size()) {
      script += curve_data(fmt::format("after{}", joint), after->error_rad[joint]);
      curves += fmt::format(
          ", $after{} using 1:2 with lines linewidth 1.3 linecolor rgb '#0072b2' notitle 'error "
          "after'",
          joint);
    }
    script += fmt::format("set title {}\nplot {}\n",
                          gnuplot_quoted(errors.joints[joint] + ", mrad over s"), curves);
  }
  return script + "unset multiplot\n";
}

std::string robot_section(const Identification& found, const RobotReport& robot,
                          Pictures& pictures) {
  std::string text = "<section>\n<h2>The robot, joint by joint</h2>\n" + joints_table(found, robot);
  const RolloutTrace* shown = shown_trace(robot.errors.before);
  if (shown != nullptr) {
    text += fmt::format(
        "<h3>Simulated less measured position by time</h3>\n<p class=\"soft\"><span class=\"key\" "
        "style=\"background:#d55e00\"></span>as stated <span class=\"key\" "
        "style=\"background:#0072b2\"></span>{}; the robot under its own controllers over the run "
        "{}{}</p>\n{}",
        robot.is_fitted ? "with values fitted by simulation" : "with what was found",
        escaped(shown->run), shown->is_held_out ? ", which no fit saw" : "",
        pictures.draw(joint_errors_plot(robot.errors), "Error of each joint by time"));
  }
  std::string items;
  for (const std::string& each : robot_findings(robot)) {
    items += "<li>" + escaped(each) + "</li>\n";
  }
  if (!items.empty()) {
    text += "<h3>Joints, sisters and bodies</h3>\n<ul>\n" + items + "</ul>\n";
  }
  if (robot.study) {
    text +=
        told_text(*robot.study) + "<h3>Values that the motion gives</h3>\n" + values_table(robot);
  }
  return text + "</section>\n";
}

}  // namespace torquewright::report
