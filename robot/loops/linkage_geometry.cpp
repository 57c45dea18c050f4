// SPDX-License-Identifier: Apache-2.0
// Geometry: docs/derivations/mechanisms.md. Branches are those that stand nearest to the file's own
// posture.
#include "robot/loops/linkage_geometry.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "robot/mechanisms/four_bar.hpp"
#include "robot/mechanisms/parallel_ankle.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Vector3d;

constexpr double kParallel = 1e-3;    // sine; what it does to the joints is measured afterwards
constexpr double kAlike = 1e-9;       // opposite sides of a parallelogram, of what is rounded
constexpr double kNoLength_m = 1e-6;  // the least of documents
constexpr double kWholeTurn = 2 * std::numbers::pi;
constexpr std::array<std::array<int, 2>, 4> kWaysOfTwo{{{1, 1}, {1, -1}, {-1, 1}, {-1, -1}}};
constexpr double kEveryTilt_rad = 1.6;  // no file states a ball's limit

Vector3d across(const Vector3d& v, const Vector3d& normal) { return v - normal * normal.dot(v); }

/// Where a point of a body that the ground carries is when its joint is at zero.
Vector3d in_ground_m(const dynamics::Joint& joint, const Vector3d& point_m) {
  return joint.R_PB * point_m;
}

Vector3d axis_in_ground(const dynamics::Joint& joint) { return joint.R_PB * joint.axis; }

bool are_parallel(const Vector3d& one, const Vector3d& other) {
  return one.cross(other).norm() <= kParallel;
}

double turns_apart_rad(double one_rad, double other_rad) {
  return std::abs(std::remainder(one_rad - other_rad, kWholeTurn));
}

/// Which of the two ways of closing stands nearest to the crank of the file: 1, -1, or none where
/// the loop does not close with these joints, or both are one.
int nearest_branch(const std::array<std::optional<double>, 2>& crank_rad, double file_rad) {
  if (!crank_rad[0] || !crank_rad[1]) return 0;
  const double one = turns_apart_rad(*crank_rad[0], file_rad);
  const double other = turns_apart_rad(*crank_rad[1], file_rad);
  if (std::min(one, other) > 0.5 * std::max(one, other)) return 0;
  return one < other ? 1 : -1;
}

std::string no_branch(const std::vector<DraftBody>& draft, const RodLoop& loop) {
  return fmt::format(
      "where the file puts its bodies the linkage of crank \"{}\" does not close, or stands with "
      "its links in line: which way it is assembled is open",
      draft[loop.crank].body.name);
}

/// A flat view of a loop of hinges that are parallel to the held one's axis.
struct Plane {
  Vector3d normal, along, beside;
  double angle_rad(const Vector3d& v) const { return std::atan2(v.dot(beside), v.dot(along)); }
};

void make_alike(double& one_m, double& other_m) {
  if (std::abs(one_m - other_m) <= kAlike * one_m) other_m = one_m;
}

double rod_across_m(const std::vector<DraftBody>& draft, const RodLoop& loop, double offset_m) {
  if (loop.rod.size() == 1) {
    return across(loop.rod_m, draft[loop.rod.front()].body.joint.axis).norm();
  }
  return std::sqrt(std::max(0.0, loop.rod_m.squaredNorm() - offset_m * offset_m));
}

FourBarGeometry lengths_of(const std::vector<DraftBody>& draft, const RodLoop& loop) {
  const dynamics::Joint& crank = draft[loop.crank].body.joint;
  const dynamics::Joint& rocker = draft[loop.held.front()].body.joint;
  Plane plane;
  plane.normal = axis_in_ground(rocker);
  const Vector3d ground_m = across(rocker.p_PB_m - crank.p_PB_m, plane.normal);
  plane.along = ground_m.normalized();
  plane.beside = plane.normal.cross(plane.along);
  const Vector3d crank_pin_m = in_ground_m(crank, loop.crank_pin_m);
  const Vector3d rocker_pin_m = in_ground_m(rocker, loop.held_pin_m);
  const double offset_m =
      plane.normal.dot(rocker.p_PB_m + rocker_pin_m - crank.p_PB_m - crank_pin_m);
  const Vector3d crank_m = across(crank_pin_m, plane.normal);
  const Vector3d rocker_m = across(rocker_pin_m, plane.normal);
  FourBarGeometry bar;
  bar.crank_m = crank_m.norm();
  bar.coupler_m = rod_across_m(draft, loop, offset_m);
  bar.rocker_m = rocker_m.norm();
  bar.ground_m = ground_m.norm();
  bar.crank_zero_rad = plane.angle_rad(crank_m);
  bar.rocker_zero_rad = plane.angle_rad(rocker_m);
  bar.crank_direction = axis_in_ground(crank).dot(plane.normal) < 0 ? -1 : 1;
  make_alike(bar.rocker_m, bar.crank_m);
  make_alike(bar.ground_m, bar.coupler_m);
  return bar;
}

std::string objection_to_plane(const std::vector<DraftBody>& draft, const RodLoop& loop,
                               const LoopFollower& file_posture) {
  const Vector3d& axis = file_posture.axis(loop.held.front());
  std::vector<std::size_t> hinges{loop.crank};
  if (loop.rod.size() == 1) hinges.push_back(loop.rod.front());
  for (const std::size_t hinge : hinges) {
    if (are_parallel(file_posture.axis(hinge), axis)) continue;
    return fmt::format(
        "joints \"{}\" and \"{}\" are not parallel: with one joint only a planar loop, a four_bar, "
        "is read",
        draft[hinge].body.joint.name, draft[loop.held.front()].body.joint.name);
  }
  return "";
}

}  // namespace

FoundMechanism four_bar_of(const std::vector<DraftBody>& draft, const RodLoop& loop,
                           const LoopFollower& file_posture) {
  std::string objection = objection_to_plane(draft, loop, file_posture);
  if (!objection.empty()) return objection;
  FourBarGeometry bar = lengths_of(draft, loop);
  for (const double length_m : {bar.crank_m, bar.coupler_m, bar.rocker_m, bar.ground_m}) {
    if (length_m < kNoLength_m) return "two of its pins are at one place";
  }
  if (auto why = four_bar_objection(bar)) return std::move(*why);
  const SmallVector joint_rad = SmallVector::Constant(1, file_posture.position(loop.held.front()));
  std::array<std::optional<double>, 2> crank_rad;
  for (const int branch : {1, -1}) {
    bar.branch = branch;
    const auto transfer = FourBar(bar).transfer(joint_rad, SmallVector::Zero(1));
    if (transfer) crank_rad[branch == 1 ? 0 : 1] = transfer->actuator_position_rad[0];
  }
  bar.branch = nearest_branch(crank_rad, file_posture.position(loop.crank));
  if (bar.branch == 0) return no_branch(draft, loop);
  return std::make_shared<FourBar>(bar);
}

FoundMechanism parallel_ankle_of(const std::vector<DraftBody>& draft,
                                 const std::vector<RodLoop>& loops,
                                 const LoopFollower& file_posture) {
  ParallelAnkleGeometry ankle;
  const std::vector<std::size_t>& held = loops.front().held;
  ankle.first = draft[held[0]].body.joint;
  ankle.second = draft[held[1]].body.joint;
  ankle.rod_tilt_limit_rad = kEveryTilt_rad;
  for (std::size_t i = 0; i < 2; ++i) {
    const RodLoop& loop = loops[i];
    if (loop.rod.size() == 1) {
      return fmt::format("the rod's one hinge, joint \"{}\", cannot follow a universal joint",
                         draft[loop.rod.front()].body.joint.name);
    }
    const dynamics::Joint& crank = draft[loop.crank].body.joint;
    AnkleRod& rod = ankle.rods[i];
    rod.actuator_axis = axis_in_ground(crank);
    rod.actuator_center_m = crank.p_PB_m;
    rod.crank_m = in_ground_m(crank, loop.crank_pin_m);
    rod.rod_length_m = loop.rod_m.norm();
    rod.foot_attachment_m = loop.held_pin_m;
    rod.foot_pin_axis = ankle.second.R_PB.transpose() * ankle.first.axis;
    if (rod.rod_length_m < kNoLength_m ||
        rod.actuator_axis.cross(rod.crank_m).norm() < kNoLength_m) {
      return "two of its pins are at one place";
    }
  }
  SmallVector joint_rad(2);
  joint_rad << file_posture.position(held[0]), file_posture.position(held[1]);
  std::array<std::array<std::optional<double>, 2>, 2> crank_rad;
  for (const auto& branches : kWaysOfTwo) {
    for (std::size_t i = 0; i < 2; ++i) ankle.rods[i].branch = branches[i];
    const auto transfer = ParallelAnkle(ankle).transfer(joint_rad, SmallVector::Zero(2));
    for (std::size_t i = 0; transfer && i < 2; ++i) {
      crank_rad[i][branches[i] == 1 ? 0 : 1] =
          transfer->actuator_position_rad[static_cast<Eigen::Index>(i)];
    }
  }
  for (std::size_t i = 0; i < 2; ++i) {
    ankle.rods[i].branch = nearest_branch(crank_rad[i], file_posture.position(loops[i].crank));
    if (ankle.rods[i].branch == 0) return no_branch(draft, loops[i]);
  }
  return std::make_shared<ParallelAnkle>(ankle);
}

}  // namespace torquewright::hopper
