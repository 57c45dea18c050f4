// SPDX-License-Identifier: Apache-2.0
#include "src/report/stick_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "dynamics/momentum.hpp"
#include "dynamics/point.hpp"
#include "src/report/svg.hpp"

namespace torquewright::report {
namespace {

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kPageHeight = 420;  // points on paper
constexpr double kMostPageWidth = 1400;
constexpr double kPageMargin = 40;
constexpr int kPoses = 12;
constexpr int kFrames = 150;
constexpr double kPathSteps = 200;

/// A robot at one instant: lines of its bodies from the side, the first of each body.
struct Pose {
  double time_s = 0.0;
  std::vector<std::pair<Vector2d, Vector2d>> bones;
  Vector2d center_of_mass;
};

Vector2d seen(const Vector3d& point) { return {point.x(), point.z()}; }

/// From each joint to those it carries; a last body to its contact points, or its centre of mass.
Pose pose_of(const hopper::Robot& robot, const hopper::Motion& motion, dynamics::TreeState& state,
             Index sample) {
  state.set(motion.positions.col(sample), Eigen::VectorXd::Zero(state.tree().velocity_size()));
  Pose pose;
  pose.time_s = motion.time_s(sample);
  const auto& bodies = robot.tree.bodies;
  const auto place = [&](std::size_t body, const Vector3d& p_B_m) {
    return seen(dynamics::point_position_m(state, {body, p_B_m}));
  };
  for (std::size_t body = 0; body < bodies.size(); ++body) {
    const Vector2d from = place(body, Vector3d::Zero());
    bool carries = false;
    for (std::size_t child = 1; child < bodies.size(); ++child) {
      if (bodies[child].parent != body) continue;
      carries = true;
      pose.bones.emplace_back(from, place(child, Vector3d::Zero()));
    }
    std::vector<Vector2d> feet;
    for (const hopper::ContactPoint& contact : robot.contacts) {
      if (contact.point.body == body) feet.push_back(place(body, contact.point.p_B_m));
    }
    for (std::size_t i = 0; i < feet.size(); ++i) {
      pose.bones.emplace_back(from, feet[i]);
      if (i > 0) pose.bones.emplace_back(feet[i - 1], feet[i]);
    }
    if ((!carries && feet.empty()) || body == 0) {
      pose.bones.emplace_back(from, place(body, bodies[body].inertia.center_of_mass_m));
    }
  }
  pose.center_of_mass = seen(dynamics::centroid(state).position_m);
  return pose;
}

/// The sample at, or next after, a share of the motion's time.
Index sample_at(const hopper::Motion& motion, double share) {
  const double time_s = motion.times_s.front() + share * motion.duration_s();
  const auto found = std::lower_bound(motion.times_s.begin(), motion.times_s.end(), time_s);
  return std::min<Index>(found - motion.times_s.begin(), motion.samples() - 1);
}

std::vector<Pose> poses(const hopper::Robot& robot, const hopper::Motion& motion, int count) {
  dynamics::TreeState state(robot.tree);
  std::vector<Pose> all;
  for (int i = 0; i < count; ++i) {
    all.push_back(pose_of(robot, motion, state, sample_at(motion, i / std::max(1.0, count - 1.0))));
  }
  return all;
}

/// Metres to points on paper; every pose moved aside by what belongs to it.
class View {
 public:
  /// `spread_m` between neighbours, so that a motion on the spot can be read.
  View(const std::vector<Pose>& poses, double spread_m, double ground_m) : spread_m_(spread_m) {
    Vector2d least(1e9, ground_m);
    Vector2d most(-1e9, ground_m + 1e-3);
    for (std::size_t i = 0; i < poses.size(); ++i) {
      for (const auto& [from, to] : poses[i].bones) {
        for (const Vector2d& point : {from, to}) {
          const Vector2d moved = point + Vector2d(shift_m(i), 0);
          least = least.cwiseMin(moved);
          most = most.cwiseMax(moved);
        }
      }
    }
    const Vector2d size = most - least;
    scale_ = std::min((kPageHeight - 2 * kPageMargin) / size.y(),
                      (kMostPageWidth - 2 * kPageMargin) / size.x());
    least_ = least;
    width_ = size.x() * scale_ + 2 * kPageMargin;
    bottom_ = size.y() * scale_ + kPageMargin;
  }

  double shift_m(std::size_t pose) const { return spread_m_ * static_cast<double>(pose); }
  double x(const Vector2d& point, std::size_t pose) const {
    return kPageMargin + (point.x() + shift_m(pose) - least_.x()) * scale_;
  }
  double y(const Vector2d& point) const { return bottom_ - (point.y() - least_.y()) * scale_; }
  double width() const { return width_; }
  double height() const { return bottom_ + kPageMargin; }

 private:
  double spread_m_;
  double scale_ = 1.0;
  Vector2d least_;
  double width_ = 0.0;
  double bottom_ = 0.0;
};

std::string opening(const View& view, double ground_m) {
  const double y = view.y({0, ground_m});
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
      "height=\"{1}\" font-family=\"DejaVu Sans,sans-serif\" font-size=\"12\">\n"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n"
      "<line x1=\"0\" y1=\"{2}\" x2=\"{0}\" y2=\"{2}\" stroke=\"#7a8692\" stroke-width=\"1.5\"/>\n",
      decimal(view.width(), 1), decimal(view.height(), 1), decimal(y, 1));
}

/// From blue to orange over the motion.
std::string colour(double share) {
  const auto mix = [share](int from, int to) {
    return static_cast<int>(std::lround(from + share * (to - from)));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", mix(0x1f, 0xd9), mix(0x5f, 0x6b), mix(0xa8, 0x0f));
}

std::string figure(const View& view, const Pose& pose, std::size_t index, double share) {
  std::string text =
      fmt::format("<g stroke=\"{}\" stroke-width=\"3\" stroke-linecap=\"round\">\n", colour(share));
  for (const auto& [from, to] : pose.bones) {
    text += fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\"/>\n",
                        decimal(view.x(from, index), 1), decimal(view.y(from), 1),
                        decimal(view.x(to, index), 1), decimal(view.y(to), 1));
  }
  text += fmt::format("</g>\n<circle cx=\"{}\" cy=\"{}\" r=\"4\" fill=\"{}\"/>\n",
                      decimal(view.x(pose.center_of_mass, index), 1),
                      decimal(view.y(pose.center_of_mass), 1), colour(share));
  return text + fmt::format(
                    "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\" fill=\"#49566b\">{} "
                    "s</text>\n",
                    decimal(view.x(pose.center_of_mass, index), 1), decimal(view.height() - 12, 1),
                    decimal(pose.time_s, 2));
}

/// Room between neighbours, so that they do not hide one another: a third of the robot's height.
double spread_of(const std::vector<Pose>& poses) {
  double widest_m = 0.0;
  for (const Pose& pose : poses) {
    double least_m = 1e9;
    double most_m = -1e9;
    for (const auto& [from, to] : pose.bones) {
      least_m = std::min({least_m, from.x(), to.x()});
      most_m = std::max({most_m, from.x(), to.x()});
    }
    widest_m = std::max(widest_m, most_m - least_m);
  }
  return 0.7 * widest_m;
}

std::string values_of(const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) {
    if (!text.empty()) text += ';';
    text += decimal(number, 1);
  }
  return text;
}

std::string animated(const char* attribute, const std::vector<double>& numbers, double duration_s) {
  return fmt::format(
      "<animate attributeName=\"{}\" values=\"{}\" dur=\"{}s\" repeatCount=\"indefinite\"/>",
      attribute, values_of(numbers), decimal(std::max(duration_s, 0.1), 3));
}

}  // namespace

std::string stick_figures(const hopper::Robot& robot, const hopper::Motion& motion,
                          double ground_height_m) {
  if (!motion.has_base) return "";
  const std::vector<Pose> all = poses(robot, motion, kPoses);
  const View view(all, spread_of(all), ground_height_m);
  std::string text = opening(view, ground_height_m);
  for (std::size_t i = 0; i < all.size(); ++i) {
    text += figure(view, all[i], i, static_cast<double>(i) / (kPoses - 1));
  }
  return text + "</svg>\n";
}

std::string stick_animation(const hopper::Robot& robot, const hopper::Motion& motion,
                            double ground_height_m) {
  if (!motion.has_base) return "";
  const std::vector<Pose> all = poses(robot, motion, kFrames);
  const View view(all, 0.0, ground_height_m);
  const double duration_s = motion.duration_s();
  std::string text = opening(view, ground_height_m);
  text += "<g stroke=\"#1f5fa8\" stroke-width=\"4\" stroke-linecap=\"round\">\n";
  for (std::size_t bone = 0; bone < all.front().bones.size(); ++bone) {
    std::array<std::vector<double>, 4> ends;
    for (const Pose& pose : all) {
      const auto& [from, to] = pose.bones[bone];
      ends[0].push_back(view.x(from, 0));
      ends[1].push_back(view.y(from));
      ends[2].push_back(view.x(to, 0));
      ends[3].push_back(view.y(to));
    }
    text += "<line>";
    constexpr std::array kNames{"x1", "y1", "x2", "y2"};
    for (std::size_t i = 0; i < 4; ++i) text += animated(kNames[i], ends[i], duration_s);
    text += "</line>\n";
  }
  std::vector<double> x;
  std::vector<double> y;
  for (const Pose& pose : all) {
    x.push_back(view.x(pose.center_of_mass, 0));
    y.push_back(view.y(pose.center_of_mass));
  }
  return text + "</g>\n<circle r=\"5\" fill=\"#d96b0f\">" + animated("cx", x, duration_s) +
         animated("cy", y, duration_s) + "</circle>\n</svg>\n";
}

}  // namespace torquewright::report
