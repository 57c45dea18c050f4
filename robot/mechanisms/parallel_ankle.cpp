// SPDX-License-Identifier: Apache-2.0
// Equations: docs/derivations/mechanisms.md, "Parallel ankle". All vectors in the calf's axes.
#include "robot/mechanisms/parallel_ankle.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "dynamics/tree_state.hpp"
#include "robot/mechanisms/crank_closure.hpp"

namespace torquewright::hopper {
namespace {

using dynamics::Matrix3;
using dynamics::value_of;
using dynamics::Vector3;
using Eigen::Matrix2d;
using Eigen::Vector3d;

constexpr double kInLine = 1e-7;  // sine of the angle between rod and crank, and of both levers:
                                  // roundings of acos() near 1
constexpr double kTurn = 2 * std::numbers::pi;

template <typename T>
Matrix3<T> turn(const Vector3d& axis, const T& angle_rad) {
  return Eigen::AngleAxis<T>(angle_rad, axis).toRotationMatrix();
}

/// The universal joint as it stands.
template <typename T>
struct Universal {
  std::array<Vector3<T>, 2> axis;
  std::array<Vector3<T>, 2> origin_m;
  Matrix3<T> R_CF;  ///< Foot to calf.
};

template <typename T>
Universal<T> universal_of(const ParallelAnkleGeometry& ankle, const SmallVectorOf<T>& joint_rad) {
  Universal<T> at;
  at.axis[0] = ankle.first.R_PB * ankle.first.axis;
  at.origin_m[0] = ankle.first.p_PB_m;
  const Matrix3<T> cross = ankle.first.R_PB * turn<T>(ankle.first.axis, joint_rad[0]);
  at.axis[1] = cross * ankle.second.R_PB * ankle.second.axis;
  at.origin_m[1] = at.origin_m[0] + cross * ankle.second.p_PB_m;
  at.R_CF = cross * ankle.second.R_PB * turn<T>(ankle.second.axis, joint_rad[1]);
  return at;
}

template <typename T>
Vector3<T> foot_pin_m(const AnkleRod& rod, const Universal<T>& at) {
  return at.origin_m[1] + at.R_CF * rod.foot_attachment_m;
}

/// A cos x + B sin x = C at the actuator's position x: eq. (12). Distances of the pins lie between
/// the roots of nearest and farthest, squared.
template <typename T>
struct Closure {
  T A, B, C;
  T nearest_m2, farthest_m2;
};

template <typename T>
Closure<T> closure_of(const AnkleRod& rod, const Vector3<T>& pin_m) {
  using std::hypot;
  const Vector3<T> to_pin = pin_m - rod.actuator_center_m;
  const Vector3d along = rod.actuator_axis * rod.actuator_axis.dot(rod.crank_m);
  const Vector3d across = rod.crank_m - along;
  const T squares = to_pin.squaredNorm() + rod.crank_m.squaredNorm() - 2 * to_pin.dot(along);
  Closure<T> closure{};
  closure.A = 2 * to_pin.dot(across);
  closure.B = 2 * to_pin.dot(rod.actuator_axis.cross(across));
  closure.C = squares - rod.rod_length_m * rod.rod_length_m;
  const T swing = hypot(closure.A, closure.B);
  closure.nearest_m2 = squares - swing;
  closure.farthest_m2 = squares + swing;
  return closure;
}

/// One rod as it stands.
template <typename T>
struct RodPosture {
  T actuator_rad = 0;
  Vector3<T> pin_m;         ///< On the foot.
  Vector3<T> crank_m;       ///< From the actuator's centre to the crank's pin.
  Vector3<T> crank_rate_m;  ///< Of that pin over the actuator's speed.
  Vector3<T> rod_m;         ///< From the crank's pin to the foot's.
};

template <typename T>
std::optional<RodPosture<T>> posture_of(const AnkleRod& rod, const Universal<T>& at) {
  using std::remainder;
  RodPosture<T> posture;
  posture.pin_m = foot_pin_m<T>(rod, at);
  const Closure<T> closure = closure_of<T>(rod, posture.pin_m);
  const std::optional<T> angle = closing_angle_rad<T>(closure.A, closure.B, closure.C, rod.branch);
  if (!angle) return std::nullopt;
  posture.actuator_rad = remainder(*angle, kTurn);
  posture.crank_m = turn<T>(rod.actuator_axis, posture.actuator_rad) * rod.crank_m;
  posture.crank_rate_m = rod.actuator_axis.cross(posture.crank_m);
  posture.rod_m = posture.pin_m - rod.actuator_center_m - posture.crank_m;
  return posture;
}

/// How the foot's pin moves with the joints, per joint.
template <typename T>
std::array<Vector3<T>, 2> pin_rates(const Universal<T>& at, const Vector3<T>& pin_m) {
  return {at.axis[0].cross(pin_m - at.origin_m[0]), at.axis[1].cross(pin_m - at.origin_m[1])};
}

/// One row of the Jacobian and of its rate: eqs. (13), (14). False where crank and rod are in line.
template <typename T>
bool fill_row(const AnkleRod& rod, const Universal<T>& at, const RodPosture<T>& posture,
              const SmallVectorOf<T>& joint_rad_s, Eigen::Index row, TransferOf<T>& transfer) {
  using std::abs;
  const Vector3<T>& l = posture.rod_m;
  const T m = l.dot(posture.crank_rate_m);
  if (!(abs(m) > kInLine * rod.rod_length_m * posture.crank_m.norm())) return false;
  const auto rates = pin_rates(at, posture.pin_m);
  const Eigen::Matrix<T, 2, 1> g(l.dot(rates[0]), l.dot(rates[1]));
  transfer.actuator_position_rad[row] = posture.actuator_rad;
  transfer.jacobian.row(row) = g.transpose() / m;

  const T actuator_rad_s = transfer.jacobian.row(row).dot(joint_rad_s);
  const Vector3<T> pin_speed = rates[0] * joint_rad_s[0] + rates[1] * joint_rad_s[1];
  const Vector3<T> l_rate = pin_speed - posture.crank_rate_m * actuator_rad_s;
  const Vector3<T> spin =
      at.axis[0] * joint_rad_s[0];  // of the cross, which carries the second axis
  const Vector3<T> second_origin = spin.cross(at.origin_m[1] - at.origin_m[0]);
  const std::array<Vector3<T>, 2> rate_rates{
      at.axis[0].cross(pin_speed), spin.cross(at.axis[1]).cross(posture.pin_m - at.origin_m[1]) +
                                       at.axis[1].cross(pin_speed - second_origin)};
  const T m_rate = l_rate.dot(posture.crank_rate_m) +
                   l.dot(rod.actuator_axis.cross(posture.crank_rate_m)) * actuator_rad_s;
  for (Eigen::Index j = 0; j < 2; ++j) {
    const auto k = static_cast<std::size_t>(j);
    const T g_rate = l_rate.dot(rates[k]) + l.dot(rate_rates[k]);
    transfer.jacobian_rate_1_s(row, j) = (g_rate - transfer.jacobian(row, j) * m_rate) / m;
  }
  return true;
}

/// Levers of the rods about the joints, m: torques at the joints per unit of force in the rods.
template <typename T>
Matrix2d levers_m(const std::array<AnkleRod, 2>& rods, const Universal<T>& at,
                  const std::array<RodPosture<T>, 2>& postures) {
  Matrix2d levers;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto rates = pin_rates(at, postures[i].pin_m);
    for (std::size_t j = 0; j < 2; ++j) {
      levers(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
          value_of(postures[i].rod_m.dot(rates[j])) / rods[i].rod_length_m;
    }
  }
  return levers;
}

/// Torque of the rods on the foot per unit of force in them, in the direction that has least.
double least_lever_m(const Matrix2d& levers) {
  const double squares = levers.squaredNorm(), determinant = std::abs(levers.determinant());
  const double greatest = std::sqrt(
      (squares + std::sqrt(std::max(0.0, squares * squares - 4 * determinant * determinant))) / 2);
  return greatest > 0 ? determinant / greatest : 0.0;
}

/// Angle of the rod against the plane across the pin.
double tilt_rad(const Vector3d& rod_m, const Vector3d& pin_axis) {
  return std::atan2(std::abs(rod_m.dot(pin_axis)), rod_m.cross(pin_axis).norm());
}

void add_rod_margins(const ParallelAnkleGeometry& ankle, std::size_t index,
                     const Universal<double>& at, std::vector<MechanismMargin>& margins) {
  const AnkleRod& rod = ankle.rods[index];
  const std::string name = fmt::format("rod_{}", index + 1);
  const Closure<double> closure = closure_of<double>(rod, foot_pin_m<double>(rod, at));
  const double shortest = std::sqrt(std::max(0.0, closure.nearest_m2));
  const double longest = std::sqrt(closure.farthest_m2);
  const double length = rod.rod_length_m;
  margins.push_back({name + "_reach_folded", length, shortest, length - shortest, "m"});
  margins.push_back({name + "_reach_stretched", length, longest, longest - length, "m"});
  const auto posture = posture_of(rod, at);
  if (!posture) return;
  const double sine =
      posture->rod_m.dot(posture->crank_rate_m) / length / posture->crank_rate_m.norm();
  const double angle = std::asin(std::min(1.0, std::abs(sine)));
  margins.push_back({fmt::format("crank_{}_dead_centre", index + 1), angle,
                     ankle.transmission_limit_rad, angle - ankle.transmission_limit_rad, "rad"});
  const double at_crank = tilt_rad(posture->rod_m, rod.actuator_axis);
  const double at_foot = tilt_rad(posture->rod_m, at.R_CF * rod.foot_pin_axis);
  const double limit = ankle.rod_tilt_limit_rad;
  margins.push_back({name + "_tilt_at_crank", at_crank, limit, limit - at_crank, "rad"});
  margins.push_back({name + "_tilt_at_foot", at_foot, limit, limit - at_foot, "rad"});
}

}  // namespace

template <typename T>
std::optional<TransferOf<T>> ParallelAnkle::closed_form(const SmallVectorOf<T>& joint_rad,
                                                        const SmallVectorOf<T>& joint_rad_s) const {
  const Universal<T> at = universal_of<T>(geometry_, joint_rad);
  TransferOf<T> transfer{SmallVectorOf<T>(2), SmallMatrixOf<T>(2, 2), SmallMatrixOf<T>(2, 2)};
  std::array<RodPosture<T>, 2> postures;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto posture = posture_of<T>(geometry_.rods[i], at);
    if (!posture) return std::nullopt;
    postures[i] = *posture;
    const auto row = static_cast<Eigen::Index>(i);
    if (!fill_row<T>(geometry_.rods[i], at, *posture, joint_rad_s, row, transfer)) {
      return std::nullopt;
    }
  }
  const Matrix2d levers = levers_m(geometry_.rods, at, postures);
  if (!(least_lever_m(levers) > kInLine * levers.norm())) return std::nullopt;
  return transfer;
}

std::optional<Transfer> ParallelAnkle::transfer(const SmallVector& joint_rad,
                                                const SmallVector& joint_rad_s) const {
  return closed_form<double>(joint_rad, joint_rad_s);
}

std::optional<TransferOf<dynamics::Jet>> ParallelAnkle::transfer_with_slopes(
    const SmallVectorOf<dynamics::Jet>& joint_rad,
    const SmallVectorOf<dynamics::Jet>& joint_rad_s) const {
  return closed_form<dynamics::Jet>(joint_rad, joint_rad_s);
}

std::optional<TransferOf<dynamics::Jet2>> ParallelAnkle::transfer_with_curvatures(
    const SmallVectorOf<dynamics::Jet2>& joint_rad,
    const SmallVectorOf<dynamics::Jet2>& joint_rad_s) const {
  return closed_form<dynamics::Jet2>(joint_rad, joint_rad_s);
}

std::vector<MechanismMargin> ParallelAnkle::margins(const SmallVector& joint_rad) const {
  const Universal<double> at = universal_of<double>(geometry_, joint_rad);
  std::vector<MechanismMargin> margins;
  std::array<RodPosture<double>, 2> postures;
  bool is_reached = true;
  for (std::size_t i = 0; i < 2; ++i) {
    add_rod_margins(geometry_, i, at, margins);
    const auto posture = posture_of(geometry_.rods[i], at);
    if (posture) postures[i] = *posture;
    is_reached = is_reached && posture;
  }
  if (!is_reached) return margins;
  const double lever = least_lever_m(levers_m(geometry_.rods, at, postures));
  margins.push_back(
      {"least_lever", lever, geometry_.lever_limit_m, lever - geometry_.lever_limit_m, "m"});
  return margins;
}

}  // namespace torquewright::hopper
