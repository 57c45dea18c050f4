// SPDX-License-Identifier: Apache-2.0
#include "tests/robot/mujoco_twin.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "dynamics/inverse_dynamics.hpp"
#include "dynamics/mass_matrix.hpp"
#include "dynamics/momentum.hpp"
#include "dynamics/passive_forces.hpp"
#include "dynamics/tree_state.hpp"
#include "tests/dynamics/random_numbers.hpp"

namespace torquewright::test {
namespace {

using dynamics::BaseKind;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// The rows of a top body's tree, its base's first: ours in order, for both number depth first.
struct Rows {
  std::vector<int> joints;  ///< MuJoCo's.
  std::vector<Index> dofs;
};

Rows rows_below(const mjModel& model, int top) {
  Rows rows;
  for (int joint = 0; joint < model.njnt; ++joint) {
    if (model.body_rootid[model.jnt_bodyid[joint]] != top) continue;
    rows.joints.push_back(joint);
    const int width = model.jnt_type[joint] == mjJNT_FREE ? 6 : 1;
    for (int k = 0; k < width; ++k) rows.dofs.push_back(model.jnt_dofadr[joint] + k);
  }
  return rows;
}

int find_top(const mjModel& model, const std::string& name) {
  if (name.empty()) return 1;
  return mj_name2id(&model, mjOBJ_BODY, name.c_str());
}

/// Our position and velocity order: a planar base is x, z, pitch, whatever order a file slides in.
void order_base(const hopper::Robot& robot, const mjModel& model, Rows& rows) {
  if (robot.tree.base != BaseKind::kPlanar) return;
  const mjtNum* axis = model.jnt_axis + 3 * rows.joints[0];
  const double* q = model.body_quat + 4 * model.jnt_bodyid[rows.joints[0]];
  mjtNum turned[3];
  mju_rotVecQuat(turned, axis, q);
  if (std::abs(turned[0]) > 0.5) return;
  std::swap(rows.joints[0], rows.joints[1]);
  std::swap(rows.dofs[0], rows.dofs[1]);
}

class Twin {
 public:
  Twin(const hopper::Robot& robot, MujocoEngine& mujoco, int top)
      : robot_(robot), mujoco_(mujoco), top_(top), rows_(rows_below(mujoco.model(), top)) {
    order_base(robot, mujoco.model(), rows_);
  }

  bool has_our_size() const {
    return static_cast<Index>(rows_.dofs.size()) == robot_.tree.velocity_size();
  }

  TwinDifference compare() {
    TwinDifference worst;
    compare_mass(worst);
    compare_ranges(worst);
    dynamics::TreeState state(robot_.tree);
    oracles::Dice dice(5);
    for (int sample = 0; sample < 20; ++sample) compare_at(dice, state, worst);
    return worst;
  }

 private:
  const mjModel& model() { return mujoco_.model(); }

  void compare_mass(TwinDifference& worst) {
    double ours_kg = 0;
    for (const dynamics::Body& body : robot_.tree.bodies) ours_kg += body.inertia.mass_kg;
    const double theirs_kg = model().body_subtreemass[top_];
    worst.mass = std::abs(ours_kg - theirs_kg) / theirs_kg;
  }

  void compare_ranges(TwinDifference& worst) {
    const auto base = static_cast<std::size_t>(rows_.joints.size() - robot_.tree.bodies.size() + 1);
    for (std::size_t i = base; i < rows_.joints.size(); ++i) {
      const auto& limits = robot_.tree.bodies[i - base + 1].joint.limits;
      const int joint = rows_.joints[i];
      if (model().jnt_limited[joint] == 0) continue;
      // Beyond what a document holds there is no limit.
      constexpr double kFar = 1e4;
      const bool is_far =
          model().jnt_range[2 * joint] <= -kFar && model().jnt_range[2 * joint + 1] >= kFar;
      if (is_far && std::isinf(limits.position_min) && std::isinf(limits.position_max)) continue;
      worst.range =
          std::max({worst.range, std::abs(limits.position_min - model().jnt_range[2 * joint]),
                    std::abs(limits.position_max - model().jnt_range[2 * joint + 1])});
    }
  }

  void draw(oracles::Dice& dice, VectorXd& q, VectorXd& v) {
    q = Eigen::Map<const VectorXd>(model().qpos0, mujoco_.nq());
    v = uniform_vector(dice, mujoco_.nv(), 2);
    for (const int joint : rows_.joints) {
      const Index at = model().jnt_qposadr[joint];
      const bool is_free = model().jnt_type[joint] == mjJNT_FREE;
      for (Index k = 0; k < (is_free ? 7 : 1); ++k) q[at + k] += uniform(dice, -1.5, 1.5);
      if (is_free) q.segment<4>(at + 3).normalize();
    }
  }

  /// Ours of the same posture: a planar base sits at the hinge of its pitch.
  VectorXd our_position(const VectorXd& q) {
    VectorXd ours(robot_.tree.position_size());
    Index next = 0;
    std::size_t joint = 0;
    if (robot_.tree.base == BaseKind::kSpatial) {
      ours.head<7>() = q.segment<7>(model().jnt_qposadr[rows_.joints[0]]);
      next = 7;
      joint = 1;
    } else if (robot_.tree.base == BaseKind::kPlanar) {
      const int hinge = rows_.joints[2];
      const mjtNum* anchor = mujoco_.data().xanchor + 3 * hinge;
      const Index at = model().jnt_qposadr[hinge];
      ours.head<3>() << anchor[0], anchor[2], q[at] - model().qpos0[at];
      next = 3;
      joint = 3;
    }
    for (; joint < rows_.joints.size(); ++joint) {
      ours[next++] = q[model().jnt_qposadr[rows_.joints[joint]]];
    }
    return ours;
  }

  void compare_at(oracles::Dice& dice, dynamics::TreeState& state, TwinDifference& worst) {
    VectorXd q;
    VectorXd v;
    draw(dice, q, v);
    mujoco_.set(q, v);
    const Index size = robot_.tree.velocity_size();
    VectorXd our_v(size);
    for (Index i = 0; i < size; ++i) our_v[i] = v[rows_.dofs[static_cast<std::size_t>(i)]];
    state.set(our_position(q), our_v);
    compare_matrix(state, worst);
    compare_bias(state, worst);
    compare_passive(state, worst);
    compare_whole(state, worst);
  }

  void compare_matrix(dynamics::TreeState& state, TwinDifference& worst) {
    const Index size = robot_.tree.velocity_size();
    MatrixXd ours(size, size);
    dynamics::mass_matrix(state, ours);
    const MatrixXd theirs = mujoco_.mass_matrix()(rows_.dofs, rows_.dofs);
    for (Index i = 0; i < size; ++i) {
      for (Index j = 0; j < size; ++j) {
        const double scale = std::sqrt(theirs(i, i) * theirs(j, j));
        worst.matrix = std::max(worst.matrix, std::abs(ours(i, j) - theirs(i, j)) / scale);
      }
    }
  }

  void compare_bias(dynamics::TreeState& state, TwinDifference& worst) {
    if (robot_.tree.velocity_size() == 0) return;
    VectorXd ours(robot_.tree.velocity_size());
    dynamics::bias(state, ours);
    const VectorXd theirs = mujoco_.bias()(rows_.dofs);
    const double scale = std::max(theirs.cwiseAbs().maxCoeff(), 1e-12);
    worst.bias = std::max(worst.bias, (ours - theirs).cwiseAbs().maxCoeff() / scale);
  }

  /// Joint by joint: MuJoCo's own sum holds tendons' forces and the fluid's too.
  void compare_passive(dynamics::TreeState& state, TwinDifference& worst) {
    const Index size = robot_.tree.velocity_size();
    const Index base = robot_.tree.base_velocity_size();
    VectorXd ours = VectorXd::Zero(size);
    dynamics::add_dampers_and_springs(state, ours);
    dynamics::add_dry_friction(state, VectorXd::Zero(size), ours);
    for (Index row = base; row < size; ++row) {
      const Index dof = rows_.dofs[static_cast<std::size_t>(row)];
      const int joint = model().dof_jntid[dof];
      const Index at = model().jnt_qposadr[joint];
      const double v = mujoco_.data().qvel[dof];
      const double theirs =
          model().dof_damping[dof] * v + std::copysign(model().dof_frictionloss[dof], v) +
          model().jnt_stiffness[joint] * (mujoco_.data().qpos[at] - model().qpos_spring[at]);
      worst.passive =
          std::max(worst.passive, std::abs(ours[row] - theirs) / std::max(std::abs(theirs), 1e-9));
    }
  }

  /// Centre of mass and inertia about it, of all bodies as if they were one.
  void compare_whole(dynamics::TreeState& state, TwinDifference& worst) {
    const dynamics::Centroid ours = dynamics::centroid(state);
    Vector3d center = Eigen::Map<const Vector3d>(mujoco_.data().subtree_com + 3 * top_);
    Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
    for (int body = top_; body < model().nbody; ++body) {
      if (model().body_rootid[body] != top_) continue;
      using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
      const RowMajor R = Eigen::Map<const RowMajor>(mujoco_.data().ximat + 9 * body);
      const Vector3d moments = Eigen::Map<const Vector3d>(model().body_inertia + 3 * body);
      const Vector3d arm = Eigen::Map<const Vector3d>(mujoco_.data().xipos + 3 * body) - center;
      const Eigen::Matrix3d steiner =
          arm.squaredNorm() * Eigen::Matrix3d::Identity() - arm * arm.transpose();
      inertia += R * moments.asDiagonal() * R.transpose() + model().body_mass[body] * steiner;
    }
    // What slides in a plane has no place across it.
    if (robot_.tree.base == BaseKind::kPlanar) center.y() = ours.position_m.y();
    worst.place_m = std::max(worst.place_m, (ours.position_m - center).norm());
    worst.inertia = std::max(worst.inertia, (ours.inertia_kg_m2 - inertia).norm() / inertia.norm());
  }

  const hopper::Robot& robot_;
  MujocoEngine& mujoco_;
  int top_;
  Rows rows_;
};

}  // namespace

TwinDifference compare_with_mujoco(const hopper::Robot& robot, MujocoEngine& mujoco,
                                   const std::string& top) {
  const int body = find_top(mujoco.model(), top);
  if (body < 0) return {.trouble = "MuJoCo finds no body of that name"};
  Twin twin(robot, mujoco, body);
  if (!twin.has_our_size()) return {.trouble = "MuJoCo counts other joints"};
  return twin.compare();
}

}  // namespace torquewright::test
