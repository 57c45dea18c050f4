// SPDX-License-Identifier: Apache-2.0
#include "robot/draft/feet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <initializer_list>

#include "robot/draft/foot_points.hpp"
#include "robot/xml/vocabulary.hpp"

namespace torquewright::hopper {
namespace {

constexpr std::size_t kMostNamed = 6;  // in a note

/// Whether one of these words is in the name, in capitals or not.
bool says(std::string name, std::initializer_list<const char*> words) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return std::any_of(words.begin(), words.end(),
                     [&](const char* word) { return name.find(word) != std::string::npos; });
}

bool is_called_foot(const std::string& name) {
  return says(name, {"foot", "toe", "ankle", "sole"});
}

bool is_called_otherwise(const std::string& name) {
  return says(name, {"head", "neck", "hand", "finger", "thumb", "palm", "arm", "elbow", "wrist",
                     "gripper", "camera", "lidar", "imu", "radar"});
}

bool is_called_leg(const std::string& name) {
  return says(name, {"leg", "hip", "thigh", "knee", "calf", "shank", "shin", "tarsus"});
}

using Shapes = std::vector<const DraftShape*>;

/// Of one body that a robot may stand on; meshes where it has nothing else there.
Shapes standing(const DraftBody& body, bool carries, bool is_on_leg) {
  Shapes named;
  Shapes named_meshes;
  Shapes balls;
  Shapes others;
  Shapes meshes;
  for (const DraftShape& shape : body.shapes) {
    const bool is_foot =
        is_called_foot(shape.link) || is_called_foot(shape.name) || is_called_foot(shape.group);
    if (shape.mesh) {
      if (is_foot) named_meshes.push_back(&shape);
      meshes.push_back(&shape);
      continue;
    }
    if (shape.primitive == Primitive::kEllipsoid) continue;
    if (is_foot) named.push_back(&shape);
    (shape.primitive == Primitive::kSphere ? balls : others).push_back(&shape);
  }
  if (!named.empty()) return named;
  const bool is_other =
      is_called_otherwise(body.body.name) || is_called_otherwise(body.body.joint.name);
  if (!carries && !is_other) {
    if (!balls.empty()) return balls;
    if (!others.empty()) return others;
    if (named_meshes.empty() && is_on_leg) return meshes;
  }
  return named_meshes;
}

/// By body: whether its name or that of one that carries it is a leg's.
std::vector<bool> on_legs(const std::vector<DraftBody>& draft) {
  std::vector<bool> on(draft.size(), false);
  for (std::size_t i = 0; i < draft.size(); ++i) {
    on[i] = is_called_leg(draft[i].body.name) || is_called_leg(draft[i].body.joint.name) ||
            is_called_foot(draft[i].body.joint.name) || (i > 0 && on[draft[i].body.parent]);
  }
  return on;
}

/// Leaves first: what carries feet is none.
std::vector<Shapes> chosen(const std::vector<DraftBody>& draft) {
  std::vector<Shapes> found(draft.size());
  std::vector<bool> carries(draft.size(), false);
  std::vector<bool> carries_feet(draft.size(), false);
  const std::vector<bool> is_on_leg = on_legs(draft);
  for (std::size_t i = draft.size(); i-- > 0;) {
    if (!carries_feet[i]) found[i] = standing(draft[i], carries[i], is_on_leg[i]);
    if (i == 0) break;
    const std::size_t parent = draft[i].body.parent;
    carries[parent] = true;
    carries_feet[parent] = carries_feet[parent] || carries_feet[i] || !found[i].empty();
  }
  return found;
}

/// What a user could name: what is called a foot, else what ends a leg.
std::string what_helps(const std::vector<DraftBody>& draft) {
  const std::vector<bool> is_on_leg = on_legs(draft);
  std::vector<bool> carries(draft.size(), false);
  for (std::size_t i = 1; i < draft.size(); ++i) carries[draft[i].body.parent] = true;
  std::vector<std::string> called, ends;
  for (std::size_t i = 1; i < draft.size(); ++i) {
    const std::string& name = draft[i].body.name;
    if (is_called_foot(name)) called.push_back(name);
    for (const DraftMark& mark : draft[i].marks) {
      if (is_called_foot(mark.name)) called.push_back(mark.name);
    }
    if (is_on_leg[i] && !carries[i]) ends.push_back(name);
  }
  std::vector<std::string>& names = called.empty() ? ends : called;
  if (names.size() > kMostNamed) names.resize(kMostNamed);
  return fmt::format(
      "--feet NAME takes the shapes of the link, geom or site of that name, else its place; "
      "--feet NAME=X0:X1,Y0:Y1,Z states a sole in its axes, in m{}",
      names.empty() ? "" : fmt::format(" (names: {})", listed(names)));
}

}  // namespace

void add_feet(const std::vector<DraftBody>& draft, Robot& robot, std::vector<std::string>& notes) {
  if (robot.tree.base == dynamics::BaseKind::kFixed) return;
  FootPoints feet(draft, robot);
  const std::vector<Shapes> found = chosen(draft);
  for (std::size_t i = 0; i < found.size(); ++i) {
    for (const DraftShape* shape : found[i]) feet.add(i, *shape);
  }
  if (!feet.taken().empty()) {
    notes.push_back(
        fmt::format("contact points are taken from shapes that collide: {}", listed(feet.taken())));
  } else {
    notes.push_back(
        fmt::format("no contact points: no foot of the file has a ball, box, capsule or cylinder "
                    "that collides, or a mesh that is there; {}",
                    what_helps(draft)));
  }
  if (!feet.unread().empty()) {
    notes.push_back(fmt::format("the meshes of these feet do not say where they touch: {}",
                                listed(feet.unread())));
  }
}

}  // namespace torquewright::hopper
