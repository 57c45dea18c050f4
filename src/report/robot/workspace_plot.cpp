// SPDX-License-Identifier: Apache-2.0
#include "src/report/robot/workspace_plot.hpp"

#include <fmt/format.h>

#include <array>
#include <numbers>

namespace torquewright::report {
namespace {

constexpr int kWorkspaceWidth = 720;
constexpr int kWorkspaceHeight = 560;
constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr const char* kInside = "within all limits";
/// Of what keeps postures out, in the order of the names; told apart by all eyes.
constexpr std::array<const char*, 6> kColors{"#d55e00", "#e69f00", "#cc79a7",
                                             "#56b4e9", "#f0e442", "#999999"};

std::string word_of(const hopper::WorkspacePlace& place) {
  if (place.is_inside()) return kInside;
  return place.is_reached ? place.crossed : "not reached";
}

std::string block_of(const hopper::Workspace& workspace, const std::string& word, std::size_t i) {
  std::string text = fmt::format("$block{} << END\n", i);
  for (const hopper::WorkspacePlace& place : workspace.places) {
    if (word_of(place) != word) continue;
    text += fmt::format("{:.6g} {:.6g}\n", place.joint_rad[0] * kDegrees,
                        place.joint_rad[1] * kDegrees);
  }
  return text + "END\n";
}

std::string axis_of_joint(const char* axis, const hopper::Workspace& workspace, std::size_t joint) {
  const dynamics::JointLimits& limits = workspace.limits[joint];
  return fmt::format("set {}label {}\nset {}range [{:.6g}:{:.6g}]\n", axis,
                     gnuplot_quoted(workspace.joints[joint] + ", degrees"), axis,
                     limits.position_min * kDegrees, limits.position_max * kDegrees);
}

}  // namespace

std::string workspace_plot(PlotFormat format, const std::string& title,
                           const hopper::Workspace& workspace) {
  std::string script = gnuplot_terminal(format, kWorkspaceWidth, kWorkspaceHeight);
  script += fmt::format("set title {}\n", gnuplot_quoted(title));
  script += axis_of_joint("x", workspace, 0) + axis_of_joint("y", workspace, 1);
  script += "set key outside below\n";
  std::string plots;
  std::size_t block = 0;
  const auto add = [&](const std::string& word, const char* color) {
    script += block_of(workspace, word, block);
    plots += fmt::format(
        "{}$block{} using 1:2 with points pointtype 5 pointsize 0.45 linecolor rgb '{}' title {}",
        block == 0 ? "plot " : ", \\\n  ", block, color, gnuplot_quoted(word));
    ++block;
  };
  const auto kept_out = workspace.kept_out();
  std::size_t inside = workspace.places.size();
  for (const auto& [word, count] : kept_out) inside -= count;
  if (inside > 0) add(kInside, "#0072b2");
  for (const auto& [word, count] : kept_out) add(word, kColors[block % kColors.size()]);
  return script + plots + "\n";
}

std::string workspace_text(const hopper::Workspace& workspace) {
  const auto all = static_cast<double>(workspace.places.size());
  const auto kept_out = workspace.kept_out();
  double outside = 0;
  std::string reasons;
  for (const auto& [word, count] : kept_out) {
    outside += static_cast<double>(count);
    reasons += fmt::format("  {:5.1f} %  {}\n", 100.0 * static_cast<double>(count) / all, word);
  }
  std::string text;
  for (std::size_t i = 0; i < 2; ++i) {
    text += fmt::format(
        "{} from {:.4g} to {:.4g} rad ({:.4g} to {:.4g} degrees)\n", workspace.joints[i],
        workspace.limits[i].position_min, workspace.limits[i].position_max,
        workspace.limits[i].position_min * kDegrees, workspace.limits[i].position_max * kDegrees);
  }
  return text +
         fmt::format("of {} postures\n  {:5.1f} %  {}\n", workspace.places.size(),
                     100.0 * (all - outside) / all, kInside) +
         reasons;
}

}  // namespace torquewright::report
