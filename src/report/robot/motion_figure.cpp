// SPDX-License-Identifier: Apache-2.0
#include "src/report/robot/motion_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "src/report/parts/svg.hpp"
#include "src/report/robot/figure_view.hpp"
#include "src/report/robot/stick_figures.hpp"

namespace torquewright::report {
namespace {

using Eigen::Index;
using Eigen::Vector2d;

constexpr double kWidth = 1000;
constexpr double kHeight = 420;     // of the view in metres, at most
constexpr double kMargin = 56;      // around it: for the axes' numbers
constexpr double kStrip = 150;      // height of the moments by themselves, at most
constexpr double kLegend = 30;      // height of the legend
constexpr double kCaption = 22;     // height of the moments' times
constexpr double kBetween = 50;     // lines of the grid, at least
constexpr Index kWaySamples = 200;  // of the way of the centre of mass

constexpr const char* kStyle =
    "<style>.paper{fill:#ffffff}.words{fill:#49566b}.grid{stroke:#dde3e9}.ground{stroke:#7a8692;"
    "stroke-width:1.5}.way{fill:none;stroke:#49566b;stroke-dasharray:2 4}.frame{fill:none;"
    "stroke:#dde3e9}.end{text-anchor:end}.middle{text-anchor:middle}.overlaid{opacity:.75}\n"
    "@media screen and (prefers-color-scheme:dark){.paper{fill:#1b2027}.words{fill:#a3afbb}"
    ".grid,.frame{stroke:#39424c}.way{stroke:#a3afbb}.pose{filter:brightness(1.6)}}</style>\n";

/// From blue to orange over the motion.
std::string colour(double share) {
  const auto mix = [share](int from, int to) {
    return static_cast<int>(std::lround(from + share * (to - from)));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", mix(0x1f, 0xd9), mix(0x5f, 0x6b), mix(0xa8, 0x0f));
}

double share_of(const HopperPage& page, const Pose& pose) {
  return (pose.time_s - page.motion.times_s.front()) / std::max(page.motion.duration_s(), 1e-9);
}

std::string line(const char* style, const Vector2d& from, const Vector2d& to) {
  return fmt::format("<line class=\"{}\" x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\"/>\n", style,
                     decimal(from.x(), 1), decimal(from.y(), 1), decimal(to.x(), 1),
                     decimal(to.y(), 1));
}

std::string words(const char* style, const Vector2d& place, const std::string& text) {
  return fmt::format("<text class=\"words {}\" x=\"{}\" y=\"{}\">{}</text>\n", style,
                     decimal(place.x(), 1), decimal(place.y(), 1), escaped(text));
}

/// Bones in one colour and the centre of mass; `title` is what a pointer is told.
std::string drawn_pose(const Skeleton& skeleton, const Pose& pose, const std::string& color,
                       const std::string& title) {
  std::string text = fmt::format(
      "<g class=\"pose\" stroke=\"{}\" stroke-width=\"3\" stroke-linecap=\"round\"><title>{}"
      "</title>\n",
      color, escaped(title));
  for (const Skeleton::Bone& bone : skeleton.bones) text += bone_line(bone, pose, "");
  return text +
         fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"4\" stroke=\"none\" fill=\"{}\"/></g>\n",
                     decimal(pose.center_of_mass_m.x(), 1), decimal(pose.center_of_mass_m.y(), 1),
                     color);
}

std::string time_words(const Pose& pose, const Moment& moment) {
  return decimal(pose.time_s, 2) + " s" + (moment.is_in_flight ? " *" : "");
}

/// 1, 2 or 5 times a power of ten [m], so that lines are not closer than kBetween.
double grid_step_m(double scale) {
  const double least_m = kBetween / scale;
  const double decade = std::pow(10.0, std::floor(std::log10(least_m)));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (step * decade >= least_m) return step * decade;
  }
  return 10.0 * decade;
}

std::string tick(double value_m) { return fmt::format("{:.3g}", value_m + 0.0); }

/// Lines every so many metres along both axes, with their numbers.
std::string grid(const FigureView& view) {
  const double step_m = grid_step_m(view.scale());
  const Vector2d& least_m = view.least_m();
  const Vector2d& most_m = view.most_m();
  const auto first = [&](double from_m) { return static_cast<int>(std::ceil(from_m / step_m)); };
  const auto last = [&](double to_m) { return static_cast<int>(std::floor(to_m / step_m)); };
  std::string text;
  for (int i = first(least_m.x()); i <= last(most_m.x()); ++i) {
    const double x_m = i * step_m;
    const Vector2d foot = view.at({x_m, least_m.y()});
    text += line("grid", foot, view.at({x_m, most_m.y()}));
    text += words("middle", foot + Vector2d(0, 16), tick(x_m));
  }
  for (int i = first(least_m.y()); i <= last(most_m.y()); ++i) {
    const double z_m = i * step_m;
    const Vector2d left = view.at({least_m.x(), z_m});
    text += line("grid", left, view.at({most_m.x(), z_m}));
    text += words("end", left + Vector2d(-6, 4), tick(z_m));
  }
  text += words("end", view.at(most_m) + Vector2d(0, -8), "height and way in m, one scale");
  return text + line("ground", {view.at(least_m).x(), view.ground()},
                     {view.at(most_m).x(), view.ground()});
}

std::string way(const HopperPage& page, const Skeleton& skeleton, const FigureView& view) {
  const auto count = static_cast<Index>(page.motion.times_s.size());
  const Index step = std::max<Index>(1, count / kWaySamples);
  std::vector<Index> samples;
  for (Index sample = 0; sample < count; sample += step) samples.push_back(sample);
  std::string text = "<polyline class=\"way\" points=\"";
  for (const Pose& pose : poses_at(page.robot, page.motion, skeleton, samples)) {
    const Vector2d at = view.at(pose.center_of_mass_m);
    text += fmt::format("{},{} ", decimal(at.x(), 1), decimal(at.y(), 1));
  }
  return text + "\"/>\n";
}

std::string in_metres(const HopperPage& page, const Skeleton& skeleton, const DrawnMoments& drawn,
                      const FigureView& view) {
  std::string text = grid(view) + way(page, skeleton, view) + "<g class=\"overlaid\">\n";
  for (std::size_t i = 0; i < drawn.poses.size(); ++i) {
    const Pose& pose = drawn.poses[i];
    text += drawn_pose(skeleton, view.on_paper(pose), colour(share_of(page, pose)),
                       time_words(pose, drawn.moments[i]));
  }
  return text + "</g>\n";
}

/// Each moment in a cell of its own, seen from where its centre of mass is.
std::string strip(const HopperPage& page, const Skeleton& skeleton, const DrawnMoments& drawn,
                  const FigureView& view, double cell) {
  std::string text;
  for (std::size_t i = 0; i < drawn.poses.size(); ++i) {
    const Pose& pose = drawn.poses[i];
    const double x = static_cast<double>(i) * cell;
    text += fmt::format(
        "<g transform=\"translate({},0)\">\n<rect class=\"frame\" x=\"1\" y=\"0\" "
        "width=\"{}\" height=\"{}\"/>\n",
        decimal(x, 1), decimal(cell - 2, 1), decimal(view.height(), 1));
    text += line("ground", {1, view.ground()}, {cell - 1, view.ground()});
    text +=
        fmt::format("<g transform=\"translate({},0)\">\n", decimal(0.5 * (cell - view.width()), 1));
    text += drawn_pose(skeleton, view.on_paper(pose), colour(share_of(page, pose)),
                       time_words(pose, drawn.moments[i]));
    text += "</g>\n" +
            words("middle", {0.5 * cell, view.height() + 15}, time_words(pose, drawn.moments[i]));
    text += "</g>\n";
  }
  return text;
}

std::string legend(double y) {
  return fmt::format("<circle cx=\"20\" cy=\"{}\" r=\"4\" fill=\"{}\"/>\n", decimal(y - 4, 1),
                     colour(0.0)) +
         words("", {30, y}, "centre of mass, its way dotted") +
         words("", {240, y}, "colour: from the begin (blue) to the end (orange)") +
         words("", {590, y}, "* in flight");
}

}  // namespace

std::string motion_figure(const HopperPage& page) {
  if (!page.motion.has_base) return "";
  const Skeleton skeleton = skeleton_of(page.robot);
  const DrawnMoments drawn = drawn_moments(page, skeleton);
  const double ground_m = page.options.contact.ground_height_m;
  const FigureView view(drawn.poses, {ground_m, false, kWidth, kHeight, kMargin});
  const double cell = kWidth / static_cast<double>(drawn.poses.size());
  const FigureView alone(drawn.poses, {ground_m, true, cell - 2, kStrip, 5});
  const double strip_y = view.height();
  const double legend_y = strip_y + alone.height() + kCaption;
  const double height = legend_y + kLegend;
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
             "height=\"{1}\" font-family=\"DejaVu Sans,sans-serif\" font-size=\"12\">\n"
             "<title>The motion, moment by moment, from the side</title>\n{2}"
             "<rect class=\"paper\" width=\"{0}\" height=\"{1}\"/>\n<g transform=\"translate({3},"
             "0)\">\n",
             decimal(kWidth, 1), decimal(height, 1), kStyle,
             decimal(0.5 * (kWidth - view.width()), 1)) +
         in_metres(page, skeleton, drawn, view) +
         fmt::format("</g>\n<g transform=\"translate(0,{})\">\n", decimal(strip_y, 1)) +
         strip(page, skeleton, drawn, alone, cell) + "</g>\n" + legend(legend_y + 18) + "</svg>\n";
}

}  // namespace torquewright::report
