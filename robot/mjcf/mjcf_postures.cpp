// SPDX-License-Identifier: Apache-2.0
// qpos: MuJoCo's documentation, "Computation", "Joints": bodies depth first, of each its joints in
// order; seven numbers of a free joint, four (a quaternion) of a ball, one of others, which counts
// from where the joint is zero.
#include "robot/mjcf/mjcf_postures.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <sstream>

namespace torquewright::hopper {
namespace {

using Eigen::Index;

constexpr std::size_t kFree = 7, kBall = 4;

/// A joint of the file in the order of qpos.
struct FileJoint {
  const Element* element;
  std::size_t size;
};

class FileJoints {
 public:
  FileJoints(const Element& mujoco, const MjcfDefaults& defaults) : defaults_(defaults) {
    for (const Element* world : children(mujoco, "worldbody")) add_bodies(*world, "");
  }
  const std::vector<FileJoint>& all() const { return joints_; }

 private:
  static std::string class_in(const Element& element, const std::string& around) {
    const std::string own = attribute(element, "childclass");
    return own.empty() ? around : own;
  }

  /// A frame's belong to the body around it.
  void add_joints(const Element& holder, const std::string& around) {
    const std::string inside = class_in(holder, around);
    for (const Element& held : holder.children) {
      if (held.name == "frame") add_joints(held, inside);
      if (held.name == "freejoint") joints_.push_back({&held, kFree});
      if (held.name != "joint") continue;
      const std::string type = attribute(defaults_.completed(held, inside), "type");
      joints_.push_back({&held, type == "free" ? kFree : type == "ball" ? kBall : 1});
    }
  }

  void add_bodies(const Element& holder, const std::string& around) {
    const std::string inside = class_in(holder, around);
    for (const Element& held : holder.children) {
      if (held.name == "frame") add_bodies(held, inside);
      if (held.name != "body") continue;
      add_joints(held, inside);
      add_bodies(held, inside);
    }
  }

  const MjcfDefaults& defaults_;
  std::vector<FileJoint> joints_;
};

bool is_of(const FilePlace& place, const Element& joint) {
  return place.line == joint.line && place.file == *joint.file && place.element == joint.name &&
         place.name == attribute(joint, "name");
}

/// Angles of three hinges about x, y and z, one carried by the other, that turn as the quaternion.
Eigen::Vector3d hinges_rad(const double* wxyz) {
  const Eigen::Matrix3d R =
      Eigen::Quaterniond(wxyz[0], wxyz[1], wxyz[2], wxyz[3]).normalized().toRotationMatrix();
  return {std::atan2(-R(1, 2), R(2, 2)), std::asin(std::clamp(R(0, 2), -1.0, 1.0)),
          std::atan2(-R(0, 1), R(0, 0))};
}

std::vector<double> numbers_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<double> numbers;
  for (double number = 0; stream >> number;) numbers.push_back(number);
  if (!stream.eof()) numbers.clear();
  return numbers;
}

class KeyframeReader {
 public:
  KeyframeReader(const std::vector<FileJoint>& joints, Imported& imported)
      : joints_(joints), imported_(imported) {
    for (const FileJoint& joint : joints) length_ += joint.size;
  }

  void read(const Element& key) {
    const std::string own = attribute(key, "name");
    const std::string name = is_blank(own) ? fmt::format("key_{}", count_) : own;
    ++count_;
    const std::string* stated = find_attribute(key, "qpos");
    if (stated == nullptr) return;
    const std::vector<double> qpos = numbers_of(*stated);
    if (qpos.size() != length_) {
      return leave(
          name,
          fmt::format("its qpos is not the {} numbers that the file's joints ask for", length_));
    }
    const Posture posture{name, joints_at(qpos)};
    if (const auto objection = objection_to(posture)) return leave(name, *objection);
    if (!names_.insert(name).second) return leave(name, "another has that name");
    imported_.robot.postures.push_back(posture);
  }

  void note() const {
    if (names_.empty()) return;
    imported_.notes.push_back(fmt::format(
        "postures are those of keyframes, with the base upright: {}", fmt::join(names_, ", ")));
  }

 private:
  void leave(const std::string& name, const std::string& why) {
    imported_.notes.push_back(fmt::format("the keyframe {} is left out: {}", name, why));
  }

  Eigen::VectorXd joints_at(const std::vector<double>& qpos) const {
    const auto& places = imported_.joint_places;
    Eigen::VectorXd joints = Eigen::VectorXd::Zero(static_cast<Index>(places.size()) - 1);
    std::size_t body = 1, at = 0;
    for (const FileJoint& joint : joints_) {
      const double* value = qpos.data() + at;
      at += joint.size;
      // A link of a loop, a joint of the base or of another robot is none of the tree's.
      const auto found =
          std::find_if(places.begin() + static_cast<Index>(body), places.end(),
                       [&](const FilePlace& place) { return is_of(place, *joint.element); });
      if (found == places.end() || joint.size == kFree) continue;
      body = static_cast<std::size_t>(found - places.begin());
      if (joint.size == kBall && body + 2 < places.size()) {
        joints.segment<3>(static_cast<Index>(body) - 1) = hinges_rad(value);
        body += 3;
      } else {
        joints[static_cast<Index>(body) - 1] = *value;
        ++body;
      }
    }
    return joints;
  }

  std::optional<std::string> objection_to(const Posture& posture) const {
    const auto& bodies = imported_.robot.tree.bodies;
    for (std::size_t i = 1; i < bodies.size(); ++i) {
      const dynamics::Joint& joint = bodies[i].joint;
      const double position = posture.joints[static_cast<Index>(i) - 1];
      if (position >= joint.limits.position_min && position <= joint.limits.position_max) continue;
      return fmt::format("{} stands at {:.6g} there, outside its range of {:.6g} to {:.6g}",
                         joint.name, position, joint.limits.position_min,
                         joint.limits.position_max);
    }
    return std::nullopt;
  }

  const std::vector<FileJoint>& joints_;
  Imported& imported_;
  std::size_t length_ = 0;
  std::size_t count_ = 0;
  std::set<std::string> names_;
};

}  // namespace

void read_keyframes(const Element& mujoco, const MjcfDefaults& defaults, Imported& imported) {
  const FileJoints joints(mujoco, defaults);
  KeyframeReader reader(joints.all(), imported);
  for (const Element* section : children(mujoco, "keyframe")) {
    for (const Element* key : children(*section, "key")) reader.read(*key);
  }
  reader.note();
}

}  // namespace torquewright::hopper
