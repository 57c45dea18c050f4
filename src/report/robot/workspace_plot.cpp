// SPDX-License-Identifier: Apache-2.0
#include "src/report/robot/workspace_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <set>

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
  return fmt::format("set {}label {}\nset {}range [{:.6g}:{:.6g}]\n", axis,
                     gnuplot_quoted(workspace.joints[joint] + ", degrees"), axis,
                     workspace.places.front().joint_rad[joint] * kDegrees,
                     workspace.places.back().joint_rad[joint] * kDegrees);
}

/// The rectangle of both joints' ranges, a line to be closed.
std::string block_of_ranges(const hopper::Workspace& workspace) {
  const auto& [first, second] = workspace.limits;
  std::string text = "$ranges << END\n";
  for (const auto& [x, y] : {std::pair{first.position_min, second.position_min},
                             {first.position_max, second.position_min},
                             {first.position_max, second.position_max},
                             {first.position_min, second.position_max},
                             {first.position_min, second.position_min}}) {
    text += fmt::format("{:.6g} {:.6g}\n", x * kDegrees, y * kDegrees);
  }
  return text + "END\n";
}

/// All words that a place has, those within all limits apart.
std::set<std::string> words_in_picture(const hopper::Workspace& workspace) {
  std::set<std::string> words;
  for (const hopper::WorkspacePlace& place : workspace.places) words.insert(word_of(place));
  words.erase(kInside);
  return words;
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
        "{}$block{} using 1:2 with points pointtype 5 pointsize 0.3 linecolor rgb '{}' title {}",
        block == 0 ? "plot " : ", \\\n  ", block, color, gnuplot_quoted(word));
    ++block;
  };
  const bool has_inside = std::any_of(workspace.places.begin(), workspace.places.end(),
                                      [](const auto& place) { return place.is_inside(); });
  if (has_inside) add(kInside, "#0072b2");
  for (const std::string& word : words_in_picture(workspace))
    add(word, kColors[block % kColors.size()]);
  return script + block_of_ranges(workspace) + plots +
         ", \\\n  $ranges using 1:2 with lines linewidth 2 linecolor rgb 'black' title 'ranges of "
         "the joints'\n";
}

std::string workspace_text(const hopper::Workspace& workspace) {
  const auto all = static_cast<double>(workspace.in_range());
  const auto kept_out = workspace.kept_out();
  double outside = 0;
  std::string reasons;
  for (const auto& [word, count] : kept_out) {
    outside += static_cast<double>(count);
    reasons += fmt::format("  {:5.1f} %  {}\n", 100.0 * static_cast<double>(count) / all, word);
  }
  std::string text;
  for (std::size_t i = 0; i < 2; ++i) {
    const dynamics::JointLimits& limits = workspace.limits[i];
    const auto [from_rad, to_rad] = workspace.own_range_rad(i);
    text += fmt::format(
        "{} from {:.4g} to {:.4g} rad ({:.4g} to {:.4g} degrees); alone the mechanism lets it "
        "stand "
        "from {:.4g} to {:.4g} degrees\n",
        workspace.joints[i], limits.position_min, limits.position_max,
        limits.position_min * kDegrees, limits.position_max * kDegrees, from_rad * kDegrees,
        to_rad * kDegrees);
  }
  return text +
         fmt::format("of {} postures within both ranges\n  {:5.1f} %  {}\n", workspace.in_range(),
                     100.0 * (all - outside) / all, kInside) +
         reasons;
}

}  // namespace torquewright::report
