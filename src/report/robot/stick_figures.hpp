// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "src/report/parts/skeleton.hpp"
#include "src/report/robot/hopper_page.hpp"
#include "src/report/robot/moments.hpp"
#include "src/report/robot/shown_violations.hpp"
#include "src/report/turning/force_scale.hpp"

namespace torquewright::report {

/// What pictures show of a motion: moments, half of them in flight, and the poses there.
struct DrawnMoments {
  std::vector<Moment> moments;
  std::vector<Pose> poses;  ///< In metres.
};
/// Requires that the motion says how the base moves.
DrawnMoments drawn_moments(const HopperPage& page, const Skeleton& skeleton);

/// The robot seen from the side (x to the right, z up) at moments of its motion as pictures of a
/// page, one a moment, what violates something in red. Empty where the base's motion is not known.
std::string still_figures(const HopperPage& page, const std::vector<ShownViolation>& violations);

/// The robot's poses on the paper of the figure that the page's cursor moves.
struct MovingFigure {
  Skeleton skeleton;
  std::vector<Pose> poses;    ///< Places on paper, y downwards.
  std::vector<Pose> planned;  ///< What should have been, beside each; empty: nothing is drawn.
  double width = 0.0;
  double height = 0.0;
  double ground = 0.0;  ///< On paper.
  ForceScale force;
  double longest = 0.0;  ///< Of the arrow of the greatest force.
  bool follows = false;  ///< The view goes with the robot: its way is too long.
};
/// What a moving figure is made of, poses in metres; the arrow of the greatest force is about half
/// the figure high.
struct MovedPoses {
  Skeleton skeleton;
  std::vector<Pose> poses;
  std::vector<Pose> planned = {};  ///< As many, or none.
  double ground_m = 0.0;
  ForceScale force = {};
};
MovingFigure moving_figure(const MovedPoses& moved);
/// Requires that the motion says how the base moves.
MovingFigure moving_figure(const HopperPage& page, const std::vector<Eigen::Index>& samples);
/// Of all forces of the ground in a checked motion.
ForceScale force_scale(const HopperPage& page);

/// The figure as an SVG element, as it stands at one of its poses; the script moves it on.
/// `title` is what a screen reader says in its place.
std::string figure_svg(const std::string& title, const MovingFigure& figure, std::size_t pose,
                       const std::vector<ShownViolation>& violations);

}  // namespace torquewright::report
