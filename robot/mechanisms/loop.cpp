// SPDX-License-Identifier: Apache-2.0
// Equations: docs/derivations/mechanisms.md, "Loop".
#include "robot/mechanisms/loop.hpp"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>

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
template <typename T>
using MatrixX = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>;

constexpr double kMostGap_m = 1e-6;  // what hinges that are not quite parallel may leave
constexpr double kSingular = 1e-7;   // of levers, as of the closed forms
// Between the postures that are closed once for all; Newton's method goes half the way at a time,
// and converges where links are not in line.
constexpr double kNode_rad = 0.2;
constexpr double kNode_m = 0.02;
constexpr Index kMostNodes = 51;  // of a joint
constexpr double kReach_rad = std::numbers::pi;
constexpr double kReach_m = 0.5;       // of a slide without a range
constexpr double kMostDivisions = 32;  // of a step, before a loop is said to end there
constexpr double kMostJump = 0.5;      // rad or m of a link in one step: beyond, it is another way
constexpr double kStays_m = 1e-6;      // of a pin, per rad of a rod that spins between balls
constexpr int kMostMoves = 25;
constexpr double kMoved = 1e-14;

/// Derivatives of what Newton's method finds: each step with the inverse of the values alone makes
/// one order more right.
template <typename T>
constexpr int kOrder = std::is_same_v<T, double>          ? 0
                       : std::is_same_v<T, dynamics::Jet> ? 1
                                                          : 2;

/// What keeps no names, to be copied often.
dynamics::Tree bare(const dynamics::Tree& tree) {
  dynamics::Tree out = tree;
  for (dynamics::Body& body : out.bodies) body.name = body.joint.name = "";
  return out;
}

template <typename T>
VectorX<T> gaps_m(const TreeStateOf<T>& state, const std::vector<LoopClosure>& closures) {
  VectorX<T> gaps(3 * static_cast<Index>(closures.size()));
  for (std::size_t i = 0; i < closures.size(); ++i) {
    gaps.template segment<3>(3 * static_cast<Index>(i)) =
        dynamics::point_position_m(state, closures[i][0]) -
        dynamics::point_position_m(state, closures[i][1]);
  }
  return gaps;
}

template <typename T>
MatrixX<T> gap_jacobian(const TreeStateOf<T>& state, const std::vector<LoopClosure>& closures) {
  const Index columns = state.tree().velocity_size();
  MatrixX<T> jacobian(3 * static_cast<Index>(closures.size()), columns);
  Eigen::Matrix<T, 3, Eigen::Dynamic> one(3, columns), other(3, columns);
  for (std::size_t i = 0; i < closures.size(); ++i) {
    dynamics::point_jacobian(state, closures[i][0], one);
    dynamics::point_jacobian(state, closures[i][1], other);
    jacobian.template middleRows<3>(3 * static_cast<Index>(i)) = one - other;
  }
  return jacobian;
}

/// d/dt of the gaps' Jacobian times this velocity, while the tree moves with it.
template <typename T>
VectorX<T> gap_bias_m_s2(const TreeStateOf<T>& state, const std::vector<LoopClosure>& closures) {
  VectorX<T> bias(3 * static_cast<Index>(closures.size()));
  for (std::size_t i = 0; i < closures.size(); ++i) {
    bias.template segment<3>(3 * static_cast<Index>(i)) =
        dynamics::point_bias_acceleration_m_s2(state, closures[i][0]) -
        dynamics::point_bias_acceleration_m_s2(state, closures[i][1]);
  }
  return bias;
}

/// Of the links' columns those that the closures hold, the turned ones first.
std::vector<Index> felt_columns(const LoopGeometry& loop, const MatrixXd& jacobian) {
  MatrixXd left = jacobian;
  const double scale = left.rightCols(loop.links()).colwise().norm().maxCoeff();
  std::vector<Index> open;
  for (Index i = loop.joints; i < left.cols(); ++i) open.push_back(i);
  std::vector<Index> felt;
  const auto take = [&](Index column) {
    const VectorXd direction = left.col(column).normalized();
    left -= direction * (direction.transpose() * left);
    left.col(column).setZero();
    felt.push_back(column);
    open.erase(std::find(open.begin(), open.end(), column));
  };
  for (const std::size_t body : loop.turned) {
    const auto column = static_cast<Index>(body) - 1;
    const bool is_open = std::find(open.begin(), open.end(), column) != open.end();
    if (is_open && left.col(column).norm() > kSingular * scale) take(column);
  }
  while (!open.empty()) {
    const auto best = *std::max_element(open.begin(), open.end(), [&](Index one, Index other) {
      return left.col(one).norm() < left.col(other).norm();
    });
    if (!(left.col(best).norm() > kSingular * scale)) break;
    take(best);
  }
  std::sort(felt.begin(), felt.end());
  return felt;
}

/// Moves the felt links until the loop is closed. False where that does not come about.
class Closer {
 public:
  Closer(const LoopGeometry& loop, const std::vector<Index>& felt)
      : loop_(loop), felt_(felt), state_(bare(loop.tree)) {}

  bool close(VectorXd& position) {
    for (int move = 0; move < kMostMoves; ++move) {
      const VectorXd gaps = set(position);
      if (!factor()) return false;
      const VectorXd step = factors_.solve(gaps);
      if (!step.allFinite()) return false;
      position(felt_) -= step;
      if (step.cwiseAbs().maxCoeff() <= kMoved) break;
    }
    return set(position).cwiseAbs().maxCoeff() <= kMostGap_m && factor();
  }

  /// From a closed posture to one where the robot's joints stand elsewhere, by halves of `most`;
  /// by shorter steps where links move fast.
  bool walk(VectorXd& position, const SmallVector& joints, const std::array<double, 2>& most) {
    double longest = 0;  // of the way, in steps
    for (Index k = 0; k < joints.size(); ++k) {
      longest = std::max(longest,
                         2 * std::abs(joints[k] - position[k]) / most[static_cast<std::size_t>(k)]);
    }
    const SmallVector from = position.head(joints.size());
    const SmallVector way = joints - from;
    double done = 0, step = 1 / std::max(1.0, std::ceil(longest));
    const double shortest = step / kMostDivisions;
    while (done < 1) {
      const double next = done + step >= 1 - 1e-12 ? 1 : done + step;
      VectorXd there = position;
      there.head(joints.size()) = next == 1 ? joints : SmallVector(from + way * next);
      const bool is_closed = close(there) && (there - position).cwiseAbs().maxCoeff() <= kMostJump;
      if (is_closed) {
        position = there;
        done = next;
        continue;
      }
      step /= 2;
      if (step < shortest) return false;
    }
    // Where nothing was to go, the factors are still to be found.
    return longest > 0 || close(position);
  }

  /// Where it was closed last: what moves the felt columns by gaps.
  MatrixXd inverse() const {
    const Index rows = 3 * static_cast<Index>(loop_.closures.size());
    return factors_.solve(MatrixXd::Identity(rows, rows));
  }
  const TreeState& state() const { return state_; }

 private:
  VectorXd set(const VectorXd& position) {
    state_.set(position, VectorXd::Zero(position.size()));
    return gaps_m(state_, loop_.closures);
  }
  bool factor() {
    factors_.compute(gap_jacobian(state_, loop_.closures)(Eigen::all, felt_));
    const auto diagonal = factors_.matrixR().diagonal().cwiseAbs();
    const auto count = static_cast<Index>(felt_.size());
    return diagonal.size() >= count && diagonal[count - 1] > kSingular * diagonal[0];
  }

  const LoopGeometry& loop_;
  const std::vector<Index>& felt_;
  TreeState state_;
  Eigen::ColPivHouseholderQR<MatrixXd> factors_;
};

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

std::vector<Index> felt_at_start(const LoopGeometry& loop) {
  TreeState state(bare(loop.tree));
  state.set(loop.start, VectorXd::Zero(loop.start.size()));
  return felt_columns(loop, gap_jacobian(state, loop.closures));
}

double node_of(JointKind kind) { return kind == JointKind::kRevolute ? kNode_rad : kNode_m; }
double reach_of(JointKind kind) { return kind == JointKind::kRevolute ? kReach_rad : kReach_m; }

}  // namespace

std::string Loop::objection(const LoopGeometry& loop) {
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
  Closer closer(loop, felt);
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

Loop::Loop(LoopGeometry geometry)
    : geometry_(std::move(geometry)), felt_(felt_at_start(geometry_)) {
  for (Index k = 0; k < geometry_.joints; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const dynamics::Joint& joint = geometry_.tree.bodies[i + 1].joint;
    const double home = geometry_.start[k], reach = reach_of(joint.kind);
    least_[i] = std::max(home - reach, joint.limits.position_min);
    const double most = std::max(least_[i], std::min(home + reach, joint.limits.position_max));
    const double steps = std::ceil((most - least_[i]) / node_of(joint.kind));
    count_[i] = std::clamp<Index>(static_cast<Index>(steps) + 1, 1, kMostNodes);
    step_[i] = count_[i] > 1 ? (most - least_[i]) / static_cast<double>(count_[i] - 1)
                             : node_of(joint.kind);
  }
  fill_nodes();
}

Index Loop::node_count() const { return count_[0] * count_[1]; }

SmallVector Loop::joints_at(Index node) const {
  SmallVector joints(geometry_.joints);
  for (Index k = 0; k < joints.size(); ++k, node /= count_[0]) {
    const auto i = static_cast<std::size_t>(k);
    joints[k] = least_[i] + step_[i] * static_cast<double>(k == 0 ? node % count_[0] : node);
  }
  return joints;
}

/// From the start outwards, so that all nodes are on the start's branch.
void Loop::fill_nodes() {
  nodes_.assign(static_cast<std::size_t>(node_count()), {});
  Closer closer(geometry_, felt_);
  VectorXd start = geometry_.start;
  if (!closer.close(start)) return;
  Index first = 0;
  for (Index k = geometry_.joints; k-- > 0;) {
    const auto i = static_cast<std::size_t>(k);
    const double place = std::round((start[k] - least_[i]) / step_[i]);
    first = first * (k == 0 ? count_[0] : 1) +
            std::clamp<Index>(static_cast<Index>(place), 0, count_[i] - 1);
  }
  std::deque<Index> open;
  const auto try_node = [&](Index node, VectorXd position) {
    Node& found = nodes_[static_cast<std::size_t>(node)];
    if (found.is_reached || !closer.walk(position, joints_at(node), step_)) return;
    found = {true, std::move(position)};
    open.push_back(node);
  };
  try_node(first, start);
  while (!open.empty()) {
    const Index node = open.front();
    open.pop_front();
    const VectorXd from = nodes_[static_cast<std::size_t>(node)].position;
    const Index column = node % count_[0], row = node / count_[0];
    if (column > 0) try_node(node - 1, from);
    if (column + 1 < count_[0]) try_node(node + 1, from);
    if (row > 0) try_node(node - count_[0], from);
    if (row + 1 < count_[1]) try_node(node + count_[0], from);
  }
}

const Loop::Node* Loop::nearest(const SmallVector& joint_rad) const {
  std::array<Index, kMostJoints> at{0, 0};
  for (Index k = 0; k < joint_rad.size(); ++k) {
    const auto i = static_cast<std::size_t>(k);
    const double place = std::round((joint_rad[k] - least_[i]) / step_[i]);
    at[i] = static_cast<Index>(std::clamp(place, 0.0, static_cast<double>(count_[i] - 1)));
  }
  const Node* best = nullptr;
  double least = 0;
  for (Index row = std::max<Index>(at[1] - 1, 0); row <= std::min(at[1] + 1, count_[1] - 1);
       ++row) {
    for (Index column = std::max<Index>(at[0] - 1, 0); column <= std::min(at[0] + 1, count_[0] - 1);
         ++column) {
      const Node& node = nodes_[static_cast<std::size_t>(row * count_[0] + column)];
      if (!node.is_reached) continue;
      const double away = (node.position.head(joint_rad.size()) - joint_rad).norm();
      if (best != nullptr && away >= least) continue;
      best = &node;
      least = away;
    }
  }
  return best;
}

template <typename T>
std::optional<FollowedOf<T>> Loop::follow(const SmallVectorOf<T>& joint_rad,
                                          const SmallVectorOf<T>& joint_rad_s) const {
  SmallVector joints(joint_rad.size());
  for (Index k = 0; k < joints.size(); ++k) joints[k] = value_of(joint_rad[k]);
  if (!joints.allFinite()) return std::nullopt;
  const Node* node = nearest(joints);
  if (node == nullptr) return std::nullopt;
  VectorXd closed = node->position;
  Closer closer(geometry_, felt_);
  if (!closer.walk(closed, joints, step_)) return std::nullopt;
  const MatrixX<T> P = closer.inverse().cast<T>();

  const Index size = closed.size(), own = geometry_.joints;
  const VectorX<T> rest = VectorX<T>::Zero(size);
  FollowedOf<T> out;
  out.position = closed.cast<T>();
  out.position.head(own) = joint_rad;
  TreeStateOf<T> state(bare(geometry_.tree));
  state.set(out.position, rest);
  for (int order = 0; order < kOrder<T>; ++order) {
    out.position(felt_) -= P * gaps_m(state, geometry_.closures);
    state.set(out.position, rest);
  }
  // G_felt X + G_own = 0.
  const MatrixX<T> G = gap_jacobian(state, geometry_.closures);
  const MatrixX<T> G_felt = G(Eigen::all, felt_);
  const auto solved = [&](const MatrixX<T>& right) {
    MatrixX<T> x = MatrixX<T>::Zero(G_felt.cols(), right.cols());
    for (int order = 0; order <= kOrder<T>; ++order) x -= P * MatrixX<T>(G_felt * x + right);
    return x;
  };
  out.motions = MatrixX<T>::Zero(size, own);
  out.motions.topRows(own).setIdentity();
  out.motions(felt_, Eigen::all) = solved(G.leftCols(own));
  out.motions_rate_1_s = MatrixX<T>::Zero(size, own);
  // Second derivatives of the gaps are symmetric: along v and w they are a fourth of the difference
  // of those along v + w twice and along v - w twice.
  const VectorX<T> v = out.motions * joint_rad_s;
  MatrixX<T> bent(G.rows(), own);
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

template <typename T>
std::optional<TransferOf<T>> Loop::transfer_of_followed(const FollowedOf<T>& followed) const {
  const Index count = geometry_.joints;
  TransferOf<T> out{SmallVectorOf<T>(count), SmallMatrixOf<T>(count, count),
                    SmallMatrixOf<T>(count, count)};
  SmallMatrix values(count, count);
  for (Index k = 0; k < count; ++k) {
    const Index row = static_cast<Index>(geometry_.turned[static_cast<std::size_t>(k)]) - 1;
    out.actuator_position_rad[k] = followed.position[row];
    out.jacobian.row(k) = followed.motions.row(row);
    out.jacobian_rate_1_s.row(k) = followed.motions_rate_1_s.row(row);
    for (Index j = 0; j < count; ++j) values(k, j) = value_of(out.jacobian(k, j));
  }
  double fastest = 0;
  for (Index i = 0; i < followed.motions.rows(); ++i) {
    for (Index j = 0; j < count; ++j) {
      fastest = std::max(fastest, std::abs(value_of(followed.motions(i, j))));
    }
  }
  const double least = values.rowwise().norm().minCoeff();
  if (!(least > kSingular * fastest)) return std::nullopt;
  if (count == 2) {
    const SmallMatrix rows = values.rowwise().normalized();
    if (!(std::abs(rows(0, 0) * rows(1, 1) - rows(0, 1) * rows(1, 0)) > kSingular)) {
      return std::nullopt;
    }
  }
  return out;
}

template <typename T>
std::optional<TransferOf<T>> Loop::any_transfer(const SmallVectorOf<T>& joint_rad,
                                                const SmallVectorOf<T>& joint_rad_s) const {
  const auto followed = follow<T>(joint_rad, joint_rad_s);
  if (!followed) return std::nullopt;
  return transfer_of_followed<T>(*followed);
}

std::optional<Transfer> Loop::transfer(const SmallVector& joint_rad,
                                       const SmallVector& joint_rad_s) const {
  return any_transfer<double>(joint_rad, joint_rad_s);
}

std::optional<TransferOf<dynamics::Jet>> Loop::transfer_with_slopes(
    const SmallVectorOf<dynamics::Jet>& joint_rad,
    const SmallVectorOf<dynamics::Jet>& joint_rad_s) const {
  return any_transfer<dynamics::Jet>(joint_rad, joint_rad_s);
}

std::optional<TransferOf<dynamics::Jet2>> Loop::transfer_with_curvatures(
    const SmallVectorOf<dynamics::Jet2>& joint_rad,
    const SmallVectorOf<dynamics::Jet2>& joint_rad_s) const {
  return any_transfer<dynamics::Jet2>(joint_rad, joint_rad_s);
}

std::vector<MechanismMargin> Loop::margins(const SmallVector& joint_rad) const {
  std::vector<MechanismMargin> margins;
  const auto followed = follow<double>(joint_rad, SmallVector::Zero(joint_rad.size()));
  if (!followed) return margins;
  for (Index i = geometry_.joints; i < followed->position.size(); ++i) {
    const dynamics::Joint& joint = geometry_.tree.bodies[static_cast<std::size_t>(i) + 1].joint;
    const double least = joint.limits.position_min, most = joint.limits.position_max;
    if (!std::isfinite(least) && !std::isfinite(most)) continue;
    const double at = followed->position[i];
    const bool is_low = at - least < most - at;
    margins.push_back({joint.name + "_range", at, is_low ? least : most,
                       is_low ? at - least : most - at,
                       joint.kind == JointKind::kRevolute ? "rad" : "m"});
  }
  return margins;
}

double Loop::gap_m(const SmallVector& joint_rad) const {
  const auto followed = follow<double>(joint_rad, SmallVector::Zero(joint_rad.size()));
  if (!followed) return std::numeric_limits<double>::infinity();
  TreeState state(bare(geometry_.tree));
  state.set(followed->position, VectorXd::Zero(followed->position.size()));
  return gaps_m(state, geometry_.closures).cwiseAbs().maxCoeff();
}

#define TORQUEWRIGHT_LOOP_OF(T)                                                                  \
  template std::optional<FollowedOf<T>> Loop::follow(const SmallVectorOf<T>& joint_rad,          \
                                                     const SmallVectorOf<T>& joint_rad_s) const; \
  template std::optional<TransferOf<T>> Loop::transfer_of_followed(const FollowedOf<T>&) const;
TORQUEWRIGHT_LOOP_OF(double)
TORQUEWRIGHT_LOOP_OF(dynamics::Jet)
TORQUEWRIGHT_LOOP_OF(dynamics::Jet2)
#undef TORQUEWRIGHT_LOOP_OF

}  // namespace torquewright::hopper
