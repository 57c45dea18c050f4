// SPDX-License-Identifier: Apache-2.0
#include "robot/mjcf/mjcf_keyframes.hpp"

#include <algorithm>

#include "dynamics/point.hpp"
#include "robot/mjcf/mjcf_bodies.hpp"
#include "robot/model/touching_point.hpp"
#include "robot/xml/xml_text.hpp"

namespace torquewright::hopper {
namespace {

using dynamics::BaseKind;
using Eigen::Index;

Posture home_of(const dynamics::Tree& tree) {
  Posture home{"home", Eigen::VectorXd::Zero(static_cast<Index>(tree.bodies.size()) - 1)};
  for (std::size_t i = 1; i < tree.bodies.size(); ++i) {
    const auto& limits = tree.bodies[i].joint.limits;
    home.joints[static_cast<Index>(i) - 1] =
        std::clamp(0.0, limits.position_min, limits.position_max);
  }
  return home;
}

/// Of the base, so that the lowest contact point is at the world's height zero.
double standing_height_m(const Robot& robot, const Eigen::VectorXd& q) {
  if (robot.contacts.empty() || robot.tree.base == BaseKind::kFixed) return 0;
  dynamics::TreeState state(robot.tree);
  state.set(q, Eigen::VectorXd::Zero(robot.tree.velocity_size()));
  double lowest_m = 0;
  for (std::size_t i = 0; i < robot.contacts.size(); ++i) {
    const dynamics::BodyPoint point = touching_point(robot.contacts[i], state);
    const double height_m = dynamics::point_position_m(state, point).z();
    lowest_m = i == 0 ? height_m : std::min(lowest_m, height_m);
  }
  return -lowest_m;
}

/// `shown`: the posture that the tree's frames show where all joints count from zero.
std::string position_text(const Robot& robot, const Posture& posture,
                          const Eigen::VectorXd& shown) {
  Posture counted = posture;
  counted.joints -= shown;
  const Eigen::VectorXd q = position_of(robot.tree, counted);
  const double height_m = standing_height_m(robot, q);
  std::string text;
  if (robot.tree.base == BaseKind::kSpatial) text = "0 0 " + text_of(height_m) + " 1 0 0 0";
  if (robot.tree.base == BaseKind::kPlanar) text = "0 " + text_of(height_m) + " 0";
  for (const std::size_t body : mjcf_order(robot.tree)) {
    if (body == 0) continue;
    if (!text.empty()) text += ' ';
    text += text_of(posture.joints[static_cast<Index>(body) - 1]);
  }
  return text;
}

/// What stands in the document knows nothing of cranks and rods, which stand at zero.
Posture completed(Posture posture, const dynamics::Tree& tree) {
  posture.joints.conservativeResizeLike(
      Eigen::VectorXd::Zero(static_cast<Index>(tree.bodies.size()) - 1));
  return posture;
}

}  // namespace

void write_keyframes(tinyxml2::XMLPrinter& out, const Robot& robot,
                     const std::vector<double>& references) {
  Eigen::VectorXd shown = Eigen::VectorXd::Zero(static_cast<Index>(robot.tree.bodies.size()) - 1);
  for (std::size_t i = 1; i < references.size(); ++i) {
    shown[static_cast<Index>(i) - 1] = references[i];
  }
  std::vector<Posture> postures;
  for (const Posture& next : robot.postures) postures.push_back(completed(next, robot.tree));
  const bool has_home = std::any_of(postures.begin(), postures.end(),
                                    [](const Posture& next) { return next.name == "home"; });
  if (!has_home) postures.insert(postures.begin(), home_of(robot.tree));
  out.OpenElement("keyframe");
  for (const Posture& posture : postures) {
    if (!references.empty() && posture.joints != shown) continue;
    out.OpenElement("key");
    out.PushAttribute("name", posture.name.c_str());
    out.PushAttribute("qpos", position_text(robot, posture, shown).c_str());
    out.CloseElement();
  }
  out.CloseElement();
}

}  // namespace torquewright::hopper
