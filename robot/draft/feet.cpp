// SPDX-License-Identifier: Apache-2.0
#include "robot/draft/feet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <map>
#include <set>
#include <variant>

#include "robot/draft/touching_points.hpp"
#include "robot/xml/vocabulary.hpp"

namespace torquewright::hopper {
namespace {

constexpr double kRubber = 0.8;      // on dry concrete: 0.6 to 0.85
constexpr double kFarthest_m = 100;  // the greatest length of documents

/// Names that are given once each: a second "toe" is "toe_2".
class FreeNames {
 public:
  explicit FreeNames(const std::vector<ContactPoint>& taken) {
    for (const ContactPoint& contact : taken) taken_.insert(contact.name);
  }

  std::string next(const std::string& name) {
    int& count = counts_[name];  // none below it is free any more
    std::string found = count == 0 ? name : fmt::format("{}_{}", name, count + 1);
    while (!taken_.insert(found).second) found = fmt::format("{}_{}", name, ++count + 1);
    return found;
  }

 private:
  std::set<std::string> taken_;
  std::map<std::string, int> counts_;
};

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
    const bool is_foot = is_called_foot(shape.link) || is_called_foot(shape.name);
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
            (i > 0 && on[draft[i].body.parent]);
  }
  return on;
}

/// The box that holds a mesh, in m in the mesh's own axes; or why there is none.
std::variant<MeshBox, std::string> box_of(const DraftMesh& mesh) {
  std::variant<MeshBox, std::string> read = std::string();
  if (mesh.stated) {
    read = *mesh.stated;
  } else {
    read = mesh_box(mesh.file);
  }
  auto* box = std::get_if<MeshBox>(&read);
  if (box == nullptr) return read;
  const Eigen::Vector3d one = box->least.cwiseProduct(mesh.scale);
  const Eigen::Vector3d other = box->most.cwiseProduct(mesh.scale);
  box->least = one.cwiseMin(other);
  box->most = one.cwiseMax(other);
  if (!(box->least.cwiseAbs().cwiseMax(box->most.cwiseAbs()).maxCoeff() < kFarthest_m)) {
    return "is larger than 100 m: a scale is missing";
  }
  return read;
}

/// Each body's down, in its own frame, where all joints are at zero.
std::vector<Eigen::Vector3d> downs(const std::vector<DraftBody>& draft) {
  std::vector<Eigen::Vector3d> down{-Eigen::Vector3d::UnitZ()};
  for (std::size_t i = 1; i < draft.size(); ++i) {
    const dynamics::Body& body = draft[i].body;
    down.push_back(body.joint.R_PB.transpose() * down[body.parent]);
  }
  return down;
}

class Feet {
 public:
  Feet(const std::vector<DraftBody>& draft, Robot& robot)
      : draft_(&draft), robot_(&robot), downs_(downs(draft)), names_(robot.contacts) {}

  /// Leaves first: what carries feet is none.
  std::vector<Shapes> chosen() const {
    std::vector<Shapes> found(draft_->size());
    std::vector<bool> carries(draft_->size(), false);
    std::vector<bool> carries_feet(draft_->size(), false);
    const std::vector<bool> is_on_leg = on_legs(*draft_);
    for (std::size_t i = draft_->size(); i-- > 0;) {
      if (!carries_feet[i]) found[i] = standing((*draft_)[i], carries[i], is_on_leg[i]);
      if (i == 0) break;
      const std::size_t parent = (*draft_)[i].body.parent;
      carries[parent] = true;
      carries_feet[parent] = carries_feet[parent] || carries_feet[i] || !found[i].empty();
    }
    return found;
  }

  void add(std::size_t body, const DraftShape& shape) {
    if (!shape.mesh) return add_points(body, shape, shape.name);
    const auto read = box_of(*shape.mesh);
    if (const auto* why = std::get_if<std::string>(&read)) {
      unread_.push_back(fmt::format("{} (\"{}\" {})", shape.name, shape.mesh->file.string(), *why));
      return;
    }
    const MeshBox& box = std::get<MeshBox>(read);
    DraftShape solid;
    solid.name = shape.name;
    solid.primitive = Primitive::kBox;
    solid.size_m = 0.5 * (box.most - box.least);
    solid.R = shape.R;
    solid.p_m = shape.p_m + shape.R * (0.5 * (box.most + box.least));
    solid.friction_coefficient = shape.friction_coefficient;
    add_points(body, solid, shape.name + "'s mesh (its bounding box)");
  }

  const std::vector<std::string>& taken() const { return taken_; }
  const std::vector<std::string>& unread() const { return unread_; }

 private:
  void add_points(std::size_t body, const DraftShape& shape, const std::string& said) {
    const auto points = touching_points(shape, downs_[body]);
    for (const TouchingPoint& point : points) {
      if (!shape.friction_coefficient) {
        robot_->assumed.push_back(
            fmt::format("/contacts/{}/friction_coefficient", robot_->contacts.size()));
      }
      robot_->contacts.push_back({names_.next(shape.name),
                                  {body, point.p_m},
                                  shape.friction_coefficient.value_or(kRubber),
                                  0.0,
                                  point.radius_m});
    }
    taken_.push_back(fmt::format("{} of {}", points.size(), said));
  }

  const std::vector<DraftBody>* draft_;
  Robot* robot_;
  std::vector<Eigen::Vector3d> downs_;
  FreeNames names_;
  std::vector<std::string> taken_;
  std::vector<std::string> unread_;
};

}  // namespace

void add_feet(const std::vector<DraftBody>& draft, Robot& robot, std::vector<std::string>& notes) {
  if (robot.tree.base == dynamics::BaseKind::kFixed) return;
  Feet feet(draft, robot);
  const std::vector<Shapes> chosen = feet.chosen();
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    for (const DraftShape* shape : chosen[i]) feet.add(i, *shape);
  }
  notes.push_back(
      feet.taken().empty()
          ? "no contact points: no foot of the file has a ball, box, capsule or cylinder that "
            "collides, or a mesh that is there"
          : fmt::format("contact points taken from shapes that collide: {}", listed(feet.taken())));
  if (!feet.unread().empty()) {
    notes.push_back(fmt::format("feet whose meshes say nothing of where they touch: {}",
                                listed(feet.unread())));
  }
}

}  // namespace torquewright::hopper
