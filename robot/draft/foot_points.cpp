// SPDX-License-Identifier: Apache-2.0
#include "robot/draft/foot_points.hpp"

#include <fmt/format.h>

#include <variant>

#include "robot/draft/touching_points.hpp"

namespace torquewright::hopper {
namespace {

constexpr double kRubber = 0.8;      // on dry concrete: 0.6 to 0.85
constexpr double kFarthest_m = 100;  // the greatest length of documents

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

}  // namespace

FootPoints::FootPoints(const std::vector<DraftBody>& draft, Robot& robot)
    : robot_(&robot), downs_(downs(draft)) {
  for (const ContactPoint& contact : robot.contacts) names_.insert(contact.name);
}

void FootPoints::add(std::size_t body, const DraftShape& shape) {
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

void FootPoints::add_places(std::size_t body, const std::string& name, const std::string& said,
                            const std::vector<Eigen::Vector3d>& places_m) {
  for (const Eigen::Vector3d& place_m : places_m) add_point(body, name, place_m, 0, {});
  taken_.push_back(said);
}

void FootPoints::add_points(std::size_t body, const DraftShape& shape, const std::string& said) {
  const auto points = touching_points(shape, downs_[body]);
  for (const TouchingPoint& point : points) {
    add_point(body, shape.name, point.p_m, point.radius_m, shape.friction_coefficient);
  }
  taken_.push_back(fmt::format("{} of {}", points.size(), said));
}

void FootPoints::add_point(std::size_t body, const std::string& name,
                           const Eigen::Vector3d& place_m, double radius_m,
                           std::optional<double> friction_coefficient) {
  if (!friction_coefficient) {
    robot_->assumed.push_back(
        fmt::format("/contacts/{}/friction_coefficient", robot_->contacts.size()));
  }
  robot_->contacts.push_back(
      {free_name(name), {body, place_m}, friction_coefficient.value_or(kRubber), 0.0, radius_m});
}

/// Names are given once each: a second "toe" is "toe_2".
std::string FootPoints::free_name(const std::string& name) {
  int& count = counts_[name];  // none below it is free any more
  std::string found = count == 0 ? name : fmt::format("{}_{}", name, count + 1);
  while (!names_.insert(found).second) found = fmt::format("{}_{}", name, ++count + 1);
  return found;
}

}  // namespace torquewright::hopper
