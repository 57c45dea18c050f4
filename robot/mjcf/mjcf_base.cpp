// SPDX-License-Identifier: Apache-2.0
#include "robot/mjcf/mjcf_base.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace torquewright::hopper {
namespace {

using dynamics::BaseKind;
using dynamics::JointKind;
using Eigen::Vector3d;

constexpr double kAlong = 1e-12;  // roundings of a unit vector

bool is_along(const Vector3d& one, const Vector3d& other) { return (one - other).norm() < kAlong; }

/// Slides along x and z in either order, then a hinge about y; null where they are not that.
const MjcfJoint* find_slide(const Placed& pose, const std::vector<MjcfJoint>& joints,
                            const Vector3d& along) {
  for (const MjcfJoint& next : joints) {
    if (next.joint.kind != JointKind::kPrismatic) continue;
    if (is_along(pose.R * next.joint.axis, along)) return &next;
  }
  return nullptr;
}

bool is_planar(const Placed& pose, const std::vector<MjcfJoint>& joints) {
  if (joints.size() != 3 || joints.back().joint.kind != JointKind::kRevolute) return false;
  const bool is_light = std::all_of(joints.begin(), joints.end(), [](const MjcfJoint& next) {
    return next.joint.reflected_inertia == 0;
  });
  return is_light && find_slide(pose, joints, Vector3d::UnitX()) != nullptr &&
         find_slide(pose, joints, Vector3d::UnitZ()) != nullptr &&
         is_along(pose.R * joints.back().joint.axis, Vector3d::UnitY());
}

/// "base_z_position_m is rootz + 1.25", where they are not the same.
void note_offset(const char* ours, const MjcfJoint& joint, double offset, MjcfBase& base) {
  if (offset == 0) return;
  base.notes.push_back(fmt::format("{} is the file's {} {} {:.6g}", ours, joint.joint.name,
                                   offset < 0 ? '-' : '+', std::abs(offset)));
}

/// What a joint of the file has that no base of ours holds.
void note_left_out(const MjcfJoint& joint, const char* kind, MjcfBase& base) {
  const dynamics::JointLimits& limits = joint.joint.limits;
  const bool turns = joint.joint.kind == JointKind::kRevolute;
  if (std::isfinite(limits.position_min) || std::isfinite(limits.position_max)) {
    base.notes.push_back(fmt::format(
        "{}'s range of {:.6g} to {:.6g} {} is left out: a {} base has none", joint.joint.name,
        limits.position_min, limits.position_max, turns ? "rad" : "m", kind));
  }
  if (!joint.joint.passive.is_none()) {
    base.notes.push_back(
        fmt::format("{}'s damping, friction or spring is left out: a {} base has none",
                    joint.joint.name, kind));
  }
}

MjcfBase planar_base(const Placed& pose, const std::vector<MjcfJoint>& joints) {
  MjcfBase base;
  base.kind = BaseKind::kPlanar;
  const MjcfJoint& hinge = joints.back();
  // Our frame sits at the hinge and is the world's at pitch zero.
  base.R_DB = pose.R;
  base.p_DB_m = -(pose.R * hinge.place_m);
  const Vector3d start_m = pose.p_m - base.p_DB_m;
  const MjcfJoint& x = *find_slide(pose, joints, Vector3d::UnitX());
  const MjcfJoint& z = *find_slide(pose, joints, Vector3d::UnitZ());
  note_offset("base_x_position_m", x, start_m.x() - x.reference, base);
  note_offset("base_z_position_m", z, start_m.z() - z.reference, base);
  note_offset("base_pitch_position_rad", hinge, -hinge.reference, base);
  for (const MjcfJoint& joint : joints) note_left_out(joint, "planar", base);
  if (!base.R_DB.isIdentity(kAlong) || base.p_DB_m.norm() > kAlong) {
    base.notes.emplace_back(
        "the base's frame sits at the hinge of its pitch and is the world's where that is zero: "
        "not the frame of the file's body");
  }
  return base;
}

/// Of three slides, or three hinges: whether they leave no direction out.
bool span_space(const std::vector<MjcfJoint>& joints, JointKind kind) {
  constexpr double kLeastVolume = 0.1;  // of the box of three axes; 1 where they are square
  Eigen::Matrix3d axes;
  Eigen::Index count = 0;
  for (const MjcfJoint& next : joints) {
    if (next.joint.kind != kind) continue;
    if (count == 3) return false;
    axes.col(count++) = next.joint.axis;
  }
  return count == 3 && std::abs(axes.determinant()) > kLeastVolume;
}

/// Whether they move a body as a free joint does.
bool moves_freely(const std::vector<MjcfJoint>& joints,
                  const std::map<std::string, std::string>& driven) {
  if (joints.size() != 6) return false;
  const bool is_plain = std::all_of(joints.begin(), joints.end(), [&](const MjcfJoint& next) {
    return next.joint.reflected_inertia == 0 && !driven.contains(next.joint.name);
  });
  return is_plain && span_space(joints, JointKind::kPrismatic) &&
         span_space(joints, JointKind::kRevolute);
}

MjcfBase free_base(const std::vector<MjcfJoint>& joints) {
  MjcfBase base;
  base.kind = BaseKind::kSpatial;
  std::vector<std::string> names;
  for (const MjcfJoint& joint : joints) {
    names.push_back(joint.joint.name);
    note_left_out(joint, "spatial", base);
  }
  base.notes.push_back(fmt::format("{} are one free joint here, which moves the base as they do",
                                   fmt::join(names, ", ")));
  return base;
}

}  // namespace

MjcfBase base_of(const Placed& pose, const std::vector<MjcfJoint>& joints,
                 const std::map<std::string, std::string>& driven, bool drops_armature,
                 Faults& faults) {
  MjcfBase base;
  for (const MjcfJoint& next : joints) {
    if (!next.is_free) continue;
    base.kind = BaseKind::kSpatial;
    if (joints.size() > 1) faults.report(*next.element, "a free joint must be its body's only one");
    const double armature = next.joint.reflected_inertia;
    if (armature == 0) continue;
    if (drops_armature) {
      base.notes.push_back(fmt::format("the free joint's armature of {} is left out", armature));
      continue;
    }
    faults.report(
        *next.element,
        fmt::format("its armature of {} (from a default, perhaps) is inertia of the base "
                    "that no robot document holds; write <freejoint/>, or leave it out by "
                    "--drop-base-armature",
                    armature));
  }
  if (base.kind == BaseKind::kSpatial) return base;
  if (moves_freely(joints, driven)) return free_base(joints);
  return is_planar(pose, joints) ? planar_base(pose, joints) : base;
}

}  // namespace torquewright::hopper
