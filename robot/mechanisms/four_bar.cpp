// SPDX-License-Identifier: Apache-2.0
// Equations: docs/derivations/mechanisms.md, "Four-bar".
#include "robot/mechanisms/four_bar.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "robot/mechanisms/crank_closure.hpp"

namespace torquewright::hopper {
namespace {

using dynamics::value_of;
template <typename T>
using Vector2 = Eigen::Matrix<T, 2, 1>;

constexpr double kInLine = 1e-7;  // sine of the angle between links: roundings of acos() near 1
constexpr double kTurn = 2 * std::numbers::pi;

template <typename T>
Vector2<T> direction(const T& angle_rad) {
  using std::cos, std::sin;
  return {cos(angle_rad), sin(angle_rad)};
}
template <typename T>
Vector2<T> turned(const Vector2<T>& v) {
  return {-v.y(), v.x()};
}
double crossed(const Vector2<double>& a, const Vector2<double>& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// The linkage as it stands: links as vectors.
template <typename T>
struct Links {
  Vector2<T> crank_m;
  Vector2<T> rocker_m;
  Vector2<T> coupler_m;  ///< From the crank's pin to the rocker's.
};

template <typename T>
Links<T> links_of(const FourBarGeometry& four_bar, const T& crank_rad, const T& rocker_rad) {
  Links<T> links;
  links.crank_m = four_bar.crank_m * direction(crank_rad);
  links.rocker_m = four_bar.rocker_m * direction(rocker_rad);
  links.coupler_m = Vector2<T>(T(four_bar.ground_m), T(0)) + links.rocker_m - links.crank_m;
  return links;
}

/// Angle between two links from being in line, 0 to a right one.
double from_line_rad(const Vector2<double>& a, const Vector2<double>& b) {
  return std::atan2(std::abs(crossed(a, b)), std::abs(a.dot(b)));
}

/// The rocker's angle where its pin stands this far from the crank's pivot: eq. (9), as a cosine.
double reach_cosine(const FourBarGeometry& four_bar, double distance_m) {
  const double d = four_bar.ground_m, c = four_bar.rocker_m;
  return (distance_m * distance_m - d * d - c * c) / (2 * d * c);
}

MechanismMargin in_rad(std::string name, double value, double limit) {
  return {std::move(name), value, limit, value - limit, "rad"};
}

}  // namespace

std::optional<std::string> four_bar_objection(const FourBarGeometry& geometry) {
  const std::array<std::pair<const char*, double>, 4> links{{{"crank", geometry.crank_m},
                                                             {"coupler", geometry.coupler_m},
                                                             {"rocker", geometry.rocker_m},
                                                             {"ground", geometry.ground_m}}};
  double sum_m = 0;
  for (const auto& [name, length_m] : links) sum_m += length_m;
  for (const auto& [name, length_m] : links) {
    if (length_m < sum_m - length_m) continue;
    return fmt::format(
        "the loop cannot close: the {} of {} m is not shorter than the other three "
        "links together, {} m",
        name, length_m, sum_m - length_m);
  }
  return std::nullopt;
}

bool FourBar::has_change_points() const {
  return geometry_.crank_m == geometry_.rocker_m && geometry_.coupler_m == geometry_.ground_m;
}

bool FourBar::is_parallelogram() const { return has_change_points() && geometry_.branch == 1; }

template <typename T>
T FourBar::rocker_rad(const SmallVectorOf<T>& joint_rad) const {
  return geometry_.rocker_zero_rad + geometry_.rocker_direction * joint_rad[0];
}

template <typename T>
std::optional<T> FourBar::crank_rad(const T& rocker_rad) const {
  if (is_parallelogram()) return rocker_rad;
  const Vector2<T> pin =
      Vector2<T>(T(geometry_.ground_m), T(0)) + geometry_.rocker_m * direction(rocker_rad);
  const double a = geometry_.crank_m, b = geometry_.coupler_m;
  // The side of the crossed linkage changes where the parallelogram's does.
  const int side = has_change_points() && std::sin(value_of(rocker_rad)) < 0 ? -1 : 1;
  return closing_angle_rad<T>(2 * a * pin.x(), 2 * a * pin.y(), pin.squaredNorm() + a * a - b * b,
                              side * geometry_.branch);
}

template <typename T>
std::optional<TransferOf<T>> FourBar::closed_form(const SmallVectorOf<T>& joint_rad,
                                                  const SmallVectorOf<T>& joint_rad_s) const {
  using std::abs, std::remainder;
  const T rocker = rocker_rad<T>(joint_rad);
  const std::optional<T> crank = crank_rad<T>(rocker);
  if (!crank) return std::nullopt;
  const Links<T> links = links_of<T>(geometry_, *crank, rocker);
  const Vector2<T> crank_rate = turned<T>(links.crank_m), rocker_rate = turned<T>(links.rocker_m);
  const T n = links.coupler_m.dot(rocker_rate), m = links.coupler_m.dot(crank_rate);  // (8)
  const double b = geometry_.coupler_m;
  if (!(abs(m) > kInLine * b * geometry_.crank_m)) return std::nullopt;
  if (!(abs(n) > kInLine * b * geometry_.rocker_m)) return std::nullopt;

  const T ratio = is_parallelogram() ? T(1.0) : T(n / m);
  const T rocker_speed = geometry_.rocker_direction * joint_rad_s[0];
  const T crank_speed = ratio * rocker_speed;
  const Vector2<T> stretch = rocker_rate * rocker_speed - crank_rate * crank_speed;
  const T n_rate = stretch.dot(rocker_rate) - links.coupler_m.dot(links.rocker_m) * rocker_speed;
  const T m_rate = stretch.dot(crank_rate) - links.coupler_m.dot(links.crank_m) * crank_speed;
  const T ratio_rate = is_parallelogram() ? T(0.0) : T((n_rate - ratio * m_rate) / m);  // (10)

  const int sign = geometry_.crank_direction * geometry_.rocker_direction;
  TransferOf<T> transfer{SmallVectorOf<T>(1), SmallMatrixOf<T>(1, 1), SmallMatrixOf<T>(1, 1)};
  // Zeros first: the parallelogram's actuator then stands exactly where its joint does.
  const T turn = is_parallelogram() ? geometry_.rocker_zero_rad - geometry_.crank_zero_rad +
                                          geometry_.rocker_direction * joint_rad[0]
                                    : remainder(T(*crank - geometry_.crank_zero_rad), kTurn);
  transfer.actuator_position_rad[0] = geometry_.crank_direction * turn;
  transfer.jacobian(0, 0) = sign * ratio;
  transfer.jacobian_rate_1_s(0, 0) = sign * ratio_rate;
  return transfer;
}

std::optional<Transfer> FourBar::transfer(const SmallVector& joint_rad,
                                          const SmallVector& joint_rad_s) const {
  return closed_form<double>(joint_rad, joint_rad_s);
}

std::optional<TransferOf<dynamics::Jet>> FourBar::transfer_with_slopes(
    const SmallVectorOf<dynamics::Jet>& joint_rad,
    const SmallVectorOf<dynamics::Jet>& joint_rad_s) const {
  return closed_form<dynamics::Jet>(joint_rad, joint_rad_s);
}

std::optional<TransferOf<dynamics::Jet2>> FourBar::transfer_with_curvatures(
    const SmallVectorOf<dynamics::Jet2>& joint_rad,
    const SmallVectorOf<dynamics::Jet2>& joint_rad_s) const {
  return closed_form<dynamics::Jet2>(joint_rad, joint_rad_s);
}

std::vector<MechanismMargin> FourBar::margins(const SmallVector& joint_rad) const {
  const double a = geometry_.crank_m, b = geometry_.coupler_m;
  const double rocker = rocker_rad<double>(joint_rad);
  const double from_ground = std::abs(std::remainder(rocker, kTurn));
  const bool changes = has_change_points();
  std::vector<MechanismMargin> margins;
  // With opposite sides alike exactly 1 and -1: rounding may not lose them.
  const double stretched = changes ? 1 : reach_cosine(geometry_, a + b);
  const double folded = changes ? -1 : reach_cosine(geometry_, a - b);
  if (stretched <= 1) {
    margins.push_back(in_rad(changes ? "change_point_stretched" : "reach_stretched", from_ground,
                             std::acos(stretched)));
  }
  if (folded >= -1) {
    const double limit = std::acos(folded);
    margins.push_back({changes ? "change_point_folded" : "reach_folded", from_ground, limit,
                       limit - from_ground, "rad"});
  }
  const auto crank = crank_rad<double>(rocker);
  if (!crank) return margins;
  const Links<double> links = links_of<double>(geometry_, *crank, rocker);
  const double at_rocker = from_line_rad(links.coupler_m, links.rocker_m);
  margins.push_back(in_rad("crank_dead_centre", from_line_rad(links.coupler_m, links.crank_m), 0));
  margins.push_back(in_rad("rocker_dead_centre", at_rocker, 0));
  margins.push_back(in_rad("transmission_angle", at_rocker, geometry_.transmission_limit_rad));
  return margins;
}

std::optional<SmallMatrix> FourBar::constant_jacobian() const {
  if (!is_parallelogram()) return std::nullopt;
  return SmallMatrix::Constant(1, 1, geometry_.crank_direction * geometry_.rocker_direction);
}

}  // namespace torquewright::hopper
