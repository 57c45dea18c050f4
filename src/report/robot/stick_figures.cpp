// SPDX-License-Identifier: Apache-2.0
#include "src/report/robot/stick_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "src/report/parts/svg.hpp"
#include "src/report/robot/figure_view.hpp"
#include "src/report/robot/moments.hpp"

namespace torquewright::report {
namespace {

using Eigen::Index;
using Eigen::Vector2d;

constexpr int kMoments = 12;
constexpr double kLongWay = 3.0;      // width over height of a motion whose view goes along
constexpr double kArrowShare = 0.45;  // of the height: the greatest force

std::set<std::size_t> bad_bodies(const std::vector<ShownViolation>& violations, double time_s) {
  std::set<std::size_t> bodies;
  for (const ShownViolation& violation : violations) {
    if (violation.holds_at(time_s)) bodies.insert(violation.bodies.begin(), violation.bodies.end());
  }
  return bodies;
}

std::string bones_of(const Skeleton& skeleton, const Pose& pose, const std::set<std::size_t>& bad) {
  std::string text;
  for (const Skeleton::Bone& bone : skeleton.bones) {
    text += bone_line(
        bone, pose,
        fmt::format(" class=\"bone{}\" data-body=\"{}\" data-from=\"{}\" "
                    "data-to=\"{}\"",
                    bad.contains(bone.body) ? " bad" : "", bone.body, bone.from, bone.to));
  }
  return text;
}

/// The script's points of the planned pose come after those of the pose that is.
std::string planned_bones(const Skeleton& skeleton, const Pose& pose) {
  const std::size_t points = skeleton.points.size();
  std::string text;
  for (const Skeleton::Bone& bone : skeleton.bones) {
    text += bone_line(bone, pose,
                      fmt::format(" class=\"bone planned\" data-from=\"{}\" data-to=\"{}\"",
                                  points + bone.from, points + bone.to));
  }
  return text;
}

std::string svg_of(const char* style, double width, double height, double ground,
                   const std::string& title) {
  return fmt::format(
      "<svg class=\"{0}\" role=\"img\" viewBox=\"0 0 {1} {2}\">\n<title>{4}</title>\n<line "
      "class=\"ground\" x1=\"0\" y1=\"{3}\" x2=\"{1}\" y2=\"{3}\"/>\n",
      style, decimal(width, 1), decimal(height, 1), decimal(ground, 1), escaped(title));
}

std::string still(const Skeleton& skeleton, const Pose& pose, const Moment& moment,
                  const FigureView& view, const std::set<std::size_t>& bad) {
  const std::string when = decimal(pose.time_s, 3) + " s";
  const char* phase = moment.is_in_flight ? "flight" : "ground";
  std::string text = svg_of(
      "still", view.width(), view.height(), view.ground(),
      fmt::format("The robot at {}, {}{}", when, phase, bad.empty() ? "" : ", violating a limit"));
  text += bones_of(skeleton, pose, bad);
  text += fmt::format("<circle class=\"mass\" cx=\"{}\" cy=\"{}\" r=\"4\"/>\n</svg>\n",
                      decimal(pose.center_of_mass_m.x(), 1), decimal(pose.center_of_mass_m.y(), 1));
  return fmt::format(
      "<figure class=\"moment {0}\">\n{1}<figcaption>{2}<br/>{0}</figcaption>\n"
      "</figure>\n",
      phase, text, when);
}

}  // namespace

DrawnMoments drawn_moments(const HopperPage& page, const Skeleton& skeleton) {
  DrawnMoments drawn{moments_of(page.motion, page.report.flights, kMoments), {}};
  std::vector<Index> samples;
  for (const Moment& moment : drawn.moments) samples.push_back(moment.sample);
  drawn.poses = poses_at(page.robot, page.motion, skeleton, samples);
  return drawn;
}

std::string still_figures(const HopperPage& page, const std::vector<ShownViolation>& violations) {
  if (!page.motion.has_base) return "";
  const Skeleton skeleton = skeleton_of(page.robot);
  const auto [moments, poses] = drawn_moments(page, skeleton);
  const FigureView view(poses, {page.options.contact.ground_height_m, true, 220, 220, 8});
  std::string text = "<div class=\"moments\">\n";
  for (std::size_t i = 0; i < poses.size(); ++i) {
    text += still(skeleton, view.on_paper(poses[i]), moments[i], view,
                  bad_bodies(violations, poses[i].time_s));
  }
  return text + "</div>\n";
}

ForceScale force_scale(const HopperPage& page) {
  std::vector<double> all_N;
  const Eigen::MatrixXd& forces_N = page.report.demand.forces_N;
  for (Index row = 0; row + 2 < forces_N.rows(); row += 3) {
    const Eigen::VectorXd norms_N = forces_N.middleRows(row, 3).colwise().norm();
    all_N.insert(all_N.end(), norms_N.begin(), norms_N.end());
  }
  return force_scale(std::move(all_N));
}

MovingFigure moving_figure(const MovedPoses& moved) {
  MovingFigure figure;
  figure.skeleton = moved.skeleton;
  std::vector<Pose> all = moved.poses;
  all.insert(all.end(), moved.planned.begin(), moved.planned.end());
  figure.follows = FigureView::proportion(all, moved.ground_m) > kLongWay;
  if (figure.follows) {
    // A view that goes with the robot shows how far it is from where it should be.
    for (std::size_t i = 0; i < moved.planned.size(); ++i) {
      all[moved.poses.size() + i].center_of_mass_m = moved.poses[i].center_of_mass_m;
    }
  }
  const FigureView view(all, {moved.ground_m, figure.follows, 640, 400, 26});
  for (std::size_t i = 0; i < all.size(); ++i) {
    (i < moved.poses.size() ? figure.poses : figure.planned).push_back(view.on_paper(all[i]));
  }
  figure.width = view.width();
  figure.height = view.height();
  figure.ground = view.ground();
  figure.force = moved.force;
  figure.longest = kArrowShare * figure.height;
  return figure;
}

MovingFigure moving_figure(const HopperPage& page, const std::vector<Index>& samples) {
  const Skeleton skeleton = skeleton_of(page.robot);
  MovedPoses moved{skeleton, poses_at(page.robot, page.motion, skeleton, samples)};
  moved.ground_m = page.options.contact.ground_height_m;
  moved.force = force_scale(page);
  return moving_figure(moved);
}

std::string figure_svg(const std::string& title, const MovingFigure& figure, std::size_t pose,
                       const std::vector<ShownViolation>& violations) {
  const Pose& at = figure.poses[pose];
  std::string text = svg_of("robot", figure.width, figure.height, figure.ground, title);
  if (!figure.follows) {
    text += "<polyline class=\"way\" points=\"";
    for (const Pose& each : figure.poses) {
      text += fmt::format("{},{} ", decimal(each.center_of_mass_m.x(), 1),
                          decimal(each.center_of_mass_m.y(), 1));
    }
    text += "\"/>\n";
  }
  if (!figure.planned.empty()) text += planned_bones(figure.skeleton, figure.planned[pose]);
  text += bones_of(figure.skeleton, at, bad_bodies(violations, at.time_s));
  for (std::size_t i = 0; i < figure.skeleton.contacts.size(); ++i) {
    text += fmt::format("<path class=\"force\" data-contact=\"{}\"/>\n", i);
  }
  return text + fmt::format("<circle class=\"mass\" cx=\"{}\" cy=\"{}\" r=\"5\"/>\n</svg>\n",
                            decimal(at.center_of_mass_m.x(), 1),
                            decimal(at.center_of_mass_m.y(), 1));
}

}  // namespace torquewright::report
