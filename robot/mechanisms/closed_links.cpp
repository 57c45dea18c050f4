// SPDX-License-Identifier: Apache-2.0
// Equations: docs/derivations/mechanisms.md, "Loop".
#include "robot/mechanisms/closed_links.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>

#include "robot/mechanisms/gap_closer.hpp"
#include "robot/mechanisms/loop_gaps.hpp"

namespace torquewright::hopper {
namespace {

using dynamics::BodyPoint;
using dynamics::JointKind;
using dynamics::TreeState;
using dynamics::TreeStateOf;
using dynamics::value_of;
using dynamics::VectorX;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Between the postures that are closed once for all; Newton's method goes half the way at a time,
// and converges where links are not in line.
constexpr double kNode_rad = 0.2;
constexpr double kNode_m = 0.02;
constexpr Index kMostNodes = 51;           // of a joint
constexpr Index kMostNodesOfSeveral = 13;  // of a joint of three and more, whose nodes multiply
constexpr double kReach_rad = std::numbers::pi;
constexpr double kReach_m = 0.5;   // of a slide without a range
constexpr double kStays_m = 1e-6;  // of a pin, per rad of a rod that spins between balls

/// Derivatives of what Newton's method finds: each step with the inverse of the values alone makes
/// one order more right.
template <typename T>
constexpr int kOrder = std::is_same_v<T, double>          ? 0
                       : std::is_same_v<T, dynamics::Jet> ? 1
                                                          : 2;

/// The motion of an unfelt column and of the felt ones that leaves the gaps as they are.
VectorXd spin_of(const MatrixXd& jacobian, const MatrixXd& inverse, const std::vector<Index>& felt,
                 Index column) {
  VectorXd spin = VectorXd::Zero(jacobian.cols());
  spin(felt) = -inverse * jacobian.col(column);
  spin[column] = 1;
  return spin;
}

/// Whether a pin or a link's joint moves in that motion: a rod's spin moves neither.
bool moves_pins(const LoopGeometry& loop, const TreeState& state, const VectorXd& motion) {
  std::vector<BodyPoint> points;
  for (const LoopClosure& closure : loop.closures) points.push_back(closure[0]);
  for (std::size_t body = 1; body < loop.tree.bodies.size(); ++body)
    points.push_back({body, {0, 0, 0}});
  Eigen::Matrix<double, 3, Eigen::Dynamic> jacobian(3, motion.size());
  return std::any_of(points.begin(), points.end(), [&](const BodyPoint& point) {
    dynamics::point_jacobian(state, point, jacobian);
    return (jacobian * motion).norm() > kStays_m;
  });
}

double node_of(JointKind kind) { return kind == JointKind::kRevolute ? kNode_rad : kNode_m; }
double reach_of(JointKind kind) { return kind == JointKind::kRevolute ? kReach_rad : kReach_m; }

}  // namespace

std::string ClosedLinks::objection(const LoopGeometry& loop) {
  if (loop.links() == 0 || loop.closures.empty()) return "has no links, or nothing closes it";
  const std::vector<Index> felt = felt_at_start(loop);
  const auto name = [&](Index column) {
    return loop.tree.bodies[static_cast<std::size_t>(column) + 1].joint.name;
  };
  const auto is_felt = [&](Index column) {
    return std::find(felt.begin(), felt.end(), column) != felt.end();
  };
  for (const std::size_t body : loop.turned) {
    const auto column = static_cast<Index>(body) - 1;
    if (column < loop.joints || is_felt(column)) continue;
    return fmt::format("\"{}\" moves nothing where the loop starts, or turns as another does",
                       name(column));
  }
  GapCloser closer(loop, felt);
  VectorXd position = loop.start;
  if (!closer.close(position)) {
    return "does not close where its joints are nearest to zero, or its links are in line there";
  }
  const MatrixXd jacobian = gap_jacobian(closer.state(), loop.closures);
  for (Index column = loop.joints; column < jacobian.cols(); ++column) {
    if (is_felt(column)) continue;
    const VectorXd spin = spin_of(jacobian, closer.inverse(), felt, column);
    if (!moves_pins(loop, closer.state(), spin)) continue;
    return fmt::format("leaves \"{}\" free: the robot's joints alone do not say where it stands",
                       name(column));
  }
  return "";
}

ClosedLinks::ClosedLinks(LoopGeometry geometry)
    : geometry_(std::move(geometry)), felt_(felt_at_start(geometry_)) {
  Index stride = 1;
  for (Index k = 0; k < geometry_.joints; ++k) {
    axes_.push_back(axis_of(k, stride));
    steps_.push_back(axes_.back().step);
    stride *= axes_.back().count;
  }
  nodes_.resize(static_cast<std::size_t>(stride));
  fill_nodes();
}

ClosedLinks::Axis ClosedLinks::axis_of(Index joint, Index stride) const {
  const dynamics::Joint& own = geometry_.tree.bodies[static_cast<std::size_t>(joint) + 1].joint;
  const double home = geometry_.start[joint], reach = reach_of(own.kind);
  Axis axis;
  axis.stride = stride;
  axis.least = std::max(home - reach, own.limits.position_min);
  const double most = std::max(axis.least, std::min(home + reach, own.limits.position_max));
  const double steps = std::ceil((most - axis.least) / node_of(own.kind));
  axis.count = std::clamp<Index>(static_cast<Index>(steps) + 1, 1,
                                 geometry_.joints > 2 ? kMostNodesOfSeveral : kMostNodes);
  axis.step = axis.count > 1 ? (most - axis.least) / static_cast<double>(axis.count - 1)
                             : node_of(own.kind);
  return axis;
}

Index ClosedLinks::Axis::place_of(double position) const {
  const double place = std::round((position - least) / step);
  return static_cast<Index>(std::clamp(place, 0.0, static_cast<double>(count - 1)));
}

Index ClosedLinks::column_of(Index node, std::size_t axis) const {
  return node / axes_[axis].stride % axes_[axis].count;
}

VectorXd ClosedLinks::joints_at(Index node) const {
  VectorXd joints(geometry_.joints);
  for (std::size_t k = 0; k < axes_.size(); ++k) {
    joints[static_cast<Index>(k)] =
        axes_[k].least + axes_[k].step * static_cast<double>(column_of(node, k));
  }
  return joints;
}

/// From the start outwards, so that all nodes are on the start's branch.
void ClosedLinks::fill_nodes() {
  GapCloser closer(geometry_, felt_);
  VectorXd start = geometry_.start;
  if (!closer.close(start)) return;
  Index first = 0;
  for (std::size_t k = 0; k < axes_.size(); ++k) {
    first += axes_[k].stride * axes_[k].place_of(start[static_cast<Index>(k)]);
  }
  std::deque<Index> open;
  const auto try_node = [&](Index node, VectorXd position) {
    Node& found = nodes_[static_cast<std::size_t>(node)];
    if (found.is_reached || !closer.walk(position, joints_at(node), steps_)) return;
    found = {true, std::move(position)};
    open.push_back(node);
  };
  try_node(first, start);
  while (!open.empty()) {
    const Index node = open.front();
    open.pop_front();
    const VectorXd from = nodes_[static_cast<std::size_t>(node)].position;
    for (std::size_t k = 0; k < axes_.size(); ++k) {
      const Index column = column_of(node, k);
      if (column > 0) try_node(node - axes_[k].stride, from);
      if (column + 1 < axes_[k].count) try_node(node + axes_[k].stride, from);
    }
  }
}

const ClosedLinks::Node* ClosedLinks::nearest(const VectorXd& joint_rad) const {
  std::vector<Index> at, least, most;
  for (std::size_t k = 0; k < axes_.size(); ++k) {
    const Index place = axes_[k].place_of(joint_rad[static_cast<Index>(k)]);
    least.push_back(std::max<Index>(place - 1, 0));
    most.push_back(std::min(place + 1, axes_[k].count - 1));
  }
  at = least;
  const Node* best = nullptr;
  double nearest = 0;
  for (bool is_done = false; !is_done;) {
    Index place = 0;
    for (std::size_t k = 0; k < at.size(); ++k) place += at[k] * axes_[k].stride;
    const Node& node = nodes_[static_cast<std::size_t>(place)];
    if (node.is_reached) {
      const double away = (node.position.head(joint_rad.size()) - joint_rad).norm();
      if (best == nullptr || away < nearest) {
        best = &node;
        nearest = away;
      }
    }
    std::size_t k = 0;
    while (k < at.size() && at[k] == most[k]) {
      at[k] = least[k];
      ++k;
    }
    is_done = k == at.size();
    if (!is_done) ++at[k];
  }
  return best;
}

template <typename T>
std::optional<FollowedOf<T>> ClosedLinks::follow(const VectorX<T>& joint_rad,
                                                 const VectorX<T>& joint_rad_s) const {
  VectorXd joints(joint_rad.size());
  for (Index k = 0; k < joints.size(); ++k) joints[k] = value_of(joint_rad[k]);
  if (!joints.allFinite()) return std::nullopt;
  const Node* node = nearest(joints);
  if (node == nullptr) return std::nullopt;
  VectorXd closed = node->position;
  GapCloser closer(geometry_, felt_);
  if (!closer.walk(closed, joints, steps_)) return std::nullopt;
  const LoopMatrixOf<T> P = closer.inverse().cast<T>();

  const Index size = closed.size(), own = geometry_.joints;
  const VectorX<T> rest = VectorX<T>::Zero(size);
  FollowedOf<T> out;
  out.position = closed.cast<T>();
  out.position.head(own) = joint_rad;
  TreeStateOf<T> state(without_names(geometry_.tree));
  state.set(out.position, rest);
  for (int order = 0; order < kOrder<T>; ++order) {
    out.position(felt_) -= P * gaps_m(state, geometry_.closures);
    state.set(out.position, rest);
  }
  // G_felt X + G_own = 0.
  const LoopMatrixOf<T> G = gap_jacobian(state, geometry_.closures);
  const LoopMatrixOf<T> G_felt = G(Eigen::all, felt_);
  const auto solved = [&](const LoopMatrixOf<T>& right) {
    LoopMatrixOf<T> x = LoopMatrixOf<T>::Zero(G_felt.cols(), right.cols());
    for (int order = 0; order <= kOrder<T>; ++order) x -= P * LoopMatrixOf<T>(G_felt * x + right);
    return x;
  };
  out.motions = LoopMatrixOf<T>::Zero(size, own);
  out.motions.topRows(own).setIdentity();
  out.motions(felt_, Eigen::all) = solved(G.leftCols(own));
  out.motions_rate_1_s = LoopMatrixOf<T>::Zero(size, own);
  // Second derivatives of the gaps are symmetric: along v and w they are a fourth of the difference
  // of those along v + w twice and along v - w twice.
  const VectorX<T> v = out.motions * joint_rad_s;
  LoopMatrixOf<T> bent(G.rows(), own);
  for (Index k = 0; k < own; ++k) {
    const VectorX<T> w = out.motions.col(k);
    state.set(out.position, v + w);
    const VectorX<T> ahead = gap_bias_m_s2(state, geometry_.closures);
    state.set(out.position, v - w);
    bent.col(k) = (ahead - gap_bias_m_s2(state, geometry_.closures)) * T(0.25);
  }
  out.motions_rate_1_s(felt_, Eigen::all) = solved(bent);
  return out;
}

template std::optional<FollowedOf<double>> ClosedLinks::follow(const VectorX<double>&,
                                                               const VectorX<double>&) const;
template std::optional<FollowedOf<dynamics::Jet>> ClosedLinks::follow(
    const VectorX<dynamics::Jet>&, const VectorX<dynamics::Jet>&) const;
template std::optional<FollowedOf<dynamics::Jet2>> ClosedLinks::follow(
    const VectorX<dynamics::Jet2>&, const VectorX<dynamics::Jet2>&) const;

}  // namespace torquewright::hopper
