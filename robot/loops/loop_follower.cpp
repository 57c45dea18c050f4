// SPDX-License-Identifier: Apache-2.0
#include "robot/loops/loop_follower.hpp"

#include <Eigen/QR>
#include <algorithm>

#include "dynamics/mass_matrix.hpp"
#include "dynamics/rigid_inertia.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr int kMostMoves = 30;
constexpr double kClosed_m = 1e-14;
// A rod between two balls spins freely, and a planar loop holds one direction twice: both are
// directions that the gaps do not feel, but for roundings.
constexpr double kUnfelt = 1e-9;

Eigen::CompleteOrthogonalDecomposition<MatrixXd> factors_of(const MatrixXd& jacobian) {
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> factors;
  factors.setThreshold(kUnfelt);
  factors.compute(jacobian);
  return factors;
}

}  // namespace

double base_kg_of(const std::vector<DraftBody>& draft) {
  if (draft.front().body.inertia.mass_kg > 0) return 0;
  double sum_kg = 0;
  for (const DraftBody& next : draft) sum_kg += next.body.inertia.mass_kg;
  return sum_kg;
}

dynamics::Tree floating_tree(const std::vector<DraftBody>& draft, double base_kg) {
  dynamics::Tree tree;
  tree.base = dynamics::BaseKind::kSpatial;
  for (const DraftBody& next : draft) tree.bodies.push_back(next.body);
  if (base_kg > 0) {
    dynamics::RigidInertia& base = tree.bodies.front().inertia;
    const dynamics::RigidInertia more{base_kg, Eigen::Vector3d::Zero(),
                                      base_kg * Eigen::Matrix3d::Identity()};
    base = base.mass_kg > 0 ? dynamics::welded(base, more) : more;
  }
  return tree;
}

LoopFollower::LoopFollower(const std::vector<DraftBody>& draft, std::vector<RodLoop> loops)
    : loops_(std::move(loops)),
      state_(floating_tree(draft, base_kg_of(draft))),
      q_(dynamics::zero_position(state_.tree())) {
  for (const RodLoop& loop : loops_) {
    links_.push_back(loop.crank);
    links_.insert(links_.end(), loop.rod.begin(), loop.rod.end());
  }
  for (Index row = 0; row < 6; ++row) own_rows_.push_back(row);
  for (std::size_t i = 1; i < draft.size(); ++i) {
    q_[row_of_position(i)] = draft[i].reference;
    (is_link(i) ? link_rows_ : own_rows_).push_back(state_.joint_row(i));
  }
  set();
}

bool LoopFollower::is_link(std::size_t body) const {
  return std::find(links_.begin(), links_.end(), body) != links_.end();
}

void LoopFollower::set() { state_.set(q_, VectorXd::Zero(state_.tree().velocity_size())); }

Vector3d LoopFollower::seen_from(const dynamics::BodyPoint& point, std::size_t body) const {
  const dynamics::BodyMotion& seen = state_.motion(point.body);
  const dynamics::BodyMotion& from = state_.motion(body);
  return from.R_WB.transpose() * (seen.origin_m + seen.R_WB * point.p_B_m - from.origin_m);
}

VectorXd LoopFollower::gaps_m() const {
  VectorXd gaps(3 * static_cast<Index>(loops_.size()));
  for (std::size_t i = 0; i < loops_.size(); ++i) {
    const auto& ends = loops_[i].connect.ends;
    gaps.segment<3>(3 * static_cast<Index>(i)) =
        dynamics::point_position_m(state_, ends[0]) - dynamics::point_position_m(state_, ends[1]);
  }
  return gaps;
}

MatrixXd LoopFollower::gap_jacobian() const {
  const Index columns = state_.tree().velocity_size();
  MatrixXd jacobian(3 * static_cast<Index>(loops_.size()), columns);
  Eigen::Matrix<double, 3, Eigen::Dynamic> one(3, columns);
  Eigen::Matrix<double, 3, Eigen::Dynamic> other(3, columns);
  for (std::size_t i = 0; i < loops_.size(); ++i) {
    dynamics::point_jacobian(state_, loops_[i].connect.ends[0], one);
    dynamics::point_jacobian(state_, loops_[i].connect.ends[1], other);
    jacobian.middleRows<3>(3 * static_cast<Index>(i)) = one - other;
  }
  return jacobian;
}

double LoopFollower::close() {
  set();
  VectorXd gaps = gaps_m();
  for (int step = 0; step < kMostMoves && gaps.cwiseAbs().maxCoeff() > kClosed_m; ++step) {
    const VectorXd move = factors_of(gap_jacobian()(Eigen::all, link_rows_)).solve(gaps);
    for (std::size_t i = 0; i < link_rows_.size(); ++i) {
      q_[link_rows_[i] + 1] -= move[static_cast<Index>(i)];  // positions have one more, before
    }
    set();
    const VectorXd left = gaps_m();
    if (step > 3 && left.norm() >= gaps.norm()) return left.cwiseAbs().maxCoeff();
    gaps = left;
  }
  return gaps.cwiseAbs().maxCoeff();
}

MatrixXd LoopFollower::mass_matrix() {
  const MatrixXd G = gap_jacobian();
  const Index size = state_.tree().velocity_size();
  MatrixXd N = MatrixXd::Zero(size, static_cast<Index>(own_rows_.size()));
  for (std::size_t i = 0; i < own_rows_.size(); ++i) N(own_rows_[i], static_cast<Index>(i)) = 1;
  const MatrixXd moved =
      -factors_of(G(Eigen::all, link_rows_)).solve(MatrixXd(G(Eigen::all, own_rows_)));
  for (std::size_t i = 0; i < link_rows_.size(); ++i) {
    N.row(link_rows_[i]) = moved.row(static_cast<Index>(i));
  }
  MatrixXd mass(size, size);
  dynamics::mass_matrix(state_, mass);
  return N.transpose() * mass * N;
}

}  // namespace torquewright::hopper
