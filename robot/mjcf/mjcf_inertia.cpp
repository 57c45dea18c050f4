// SPDX-License-Identifier: Apache-2.0
// Rules: MuJoCo's XML reference, "compiler", "inertial", "geom".
#include "robot/mjcf/mjcf_inertia.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "dynamics/rigid_inertia.hpp"
#include "robot/draft/primitive_inertia.hpp"
#include "robot/mjcf/mjcf_shapes.hpp"

namespace torquewright::hopper {
namespace {

using dynamics::RigidInertia;
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kWater_kg_m3 = 1000;  // MJCF's default density
constexpr double kNoMass_kg = 1e-15;   // mjMINVAL

Matrix3d symmetric(const Matrix3d& R, const Vector3d& moments) {
  const Matrix3d turned = R * moments.asDiagonal() * R.transpose();
  return 0.5 * (turned + turned.transpose());
}

RigidInertia stated_inertia(const Element& element, const MjcfContext& context) {
  Faults& faults = context.faults;
  context.vocabulary.check(element);
  RigidInertia inertia;
  inertia.mass_kg = faults.number(element, "mass", 0);
  if (inertia.mass_kg < 0) faults.report(element, "the mass is negative");
  inertia.center_of_mass_m = faults.vector(element, "pos", Vector3d::Zero());
  const Matrix3d R = rotation_of(element, context.compiler, faults);
  if (const auto full = faults.numbers(element, "fullinertia", 6)) {
    const std::vector<double>& I = *full;
    if (find_attribute(element, "diaginertia") != nullptr) {
      faults.report(element, "states both diaginertia and fullinertia; leave out one");
    }
    if (!R.isIdentity(0)) faults.report(element, "fullinertia is in the body's own axes");
    inertia.inertia_kg_m2 << I[0], I[3], I[4], I[3], I[1], I[5], I[4], I[5], I[2];
    return inertia;
  }
  inertia.inertia_kg_m2 = symmetric(R, faults.vector(element, "diaginertia", Vector3d::Zero()));
  return inertia;
}

/// Of one shape in the body's frame; no mass where it has none.
RigidInertia shape_inertia(const Placed& placed, const MjcfContext& context) {
  const Element geom = context.defaults.completed(*placed.element, placed.childclass);
  Faults& faults = context.faults;
  const double group = faults.number(geom, "group", 0);
  const double stated_kg = faults.number(geom, "mass", -1);
  const double density_kg_m3 = faults.number(geom, "density", kWater_kg_m3);
  const std::string type = attribute(geom, "type");
  const bool has_mass =
      find_attribute(geom, "mass") != nullptr ? stated_kg != 0 : density_kg_m3 != 0;
  const auto& groups = context.compiler.shape_groups;
  if (!has_mass || group < groups[0] || group > groups[1]) return {};
  if (type == "plane" || type == "hfield") return {};
  context.vocabulary.check_attributes(geom);
  const auto shape = shape_of(type);
  if (!shape) {
    if (find_attribute(geom, "mesh") == nullptr) {
      faults.report(geom, fmt::format("type=\"{}\" is no shape whose inertia is known here", type));
    }
    return {};
  }
  Placed pose = placed;
  const auto size_m = size_of(geom, *shape, pose, context);
  if (!size_m) return {};
  RigidInertia inertia;
  inertia.mass_kg =
      stated_kg > 0 ? stated_kg : density_kg_m3 * volume_m3(shape->primitive, *size_m);
  if (!(inertia.mass_kg > 0)) faults.report(geom, "its mass is negative");
  inertia.center_of_mass_m = pose.p_m;
  inertia.inertia_kg_m2 =
      symmetric(pose.R, inertia.mass_kg * moments_per_mass_m2(shape->primitive, *size_m));
  return inertia;
}

RigidInertia inertia_of_shapes(const std::vector<Placed>& held, const MjcfContext& context) {
  RigidInertia whole;
  for (const Placed& placed : held) {
    if (placed.element->name != "geom") continue;
    const RigidInertia part = shape_inertia(placed, context);
    if (part.mass_kg > kNoMass_kg) whole = dynamics::welded(whole, part);
  }
  return whole;
}

/// No moment below the least one, and all the same where they are those of no body.
void bound(const MjcfCompiler& compiler, RigidInertia& inertia) {
  inertia.mass_kg = std::max(inertia.mass_kg, compiler.least_mass_kg);
  if (!(compiler.least_moment_kg_m2 > 0) && !compiler.balances_inertia) return;
  const Eigen::SelfAdjointEigenSolver<Matrix3d> axes(inertia.inertia_kg_m2);
  Vector3d moments = axes.eigenvalues();  // ascending
  const Vector3d before = moments;
  moments = moments.cwiseMax(compiler.least_moment_kg_m2);
  constexpr double kRounding = 1e-12;
  const bool is_a_body = moments[0] + moments[1] >= moments[2] * (1 - kRounding);
  if (compiler.balances_inertia && !is_a_body) moments.setConstant(moments.mean());
  if (moments != before) inertia.inertia_kg_m2 = symmetric(axes.eigenvectors(), moments);
}

}  // namespace

RigidInertia compiled_inertia(const Element& body, const std::vector<Placed>& held,
                              const MjcfContext& context) {
  const Element* stated = context.faults.only_child(body, "inertial");
  RigidInertia inertia;
  const FromShapes rule = context.compiler.inertia;
  const bool has_shapes = std::any_of(held.begin(), held.end(), [](const Placed& placed) {
    return placed.element->name == "geom";
  });
  const bool uses_shapes =
      has_shapes &&
      (rule == FromShapes::kAlways || (rule == FromShapes::kWhereNotStated && stated == nullptr));
  if (uses_shapes) {
    inertia = inertia_of_shapes(held, context);
  } else if (stated != nullptr) {
    inertia = stated_inertia(*stated, context);
    const auto at = std::find_if(held.begin(), held.end(),
                                 [&](const Placed& placed) { return placed.element == stated; });
    if (at != held.end()) inertia = dynamics::moved(inertia, at->R, at->p_m);
  }
  bound(context.compiler, inertia);
  return inertia;
}

double total_mass_kg(const Placed& body, const MjcfContext& context) {
  const std::vector<Placed> held = contents(*body.element, body.childclass, context);
  double mass_kg = compiled_inertia(*body.element, held, context).mass_kg;
  for (const Placed& placed : held) {
    if (placed.element->name == "body") mass_kg += total_mass_kg(placed, context);
  }
  return mass_kg;
}

}  // namespace torquewright::hopper
