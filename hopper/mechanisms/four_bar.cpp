// SPDX-License-Identifier: Apache-2.0
// Equations: docs/derivations/mechanisms.md, "Four-bar".
#include "hopper/mechanisms/four_bar.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "hopper/mechanisms/crank_closure.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Vector2d;

constexpr double kInLine = 1e-7;  // sine of the angle between links: roundings of acos() near 1
constexpr double kTurn = 2 * std::numbers::pi;

Vector2d direction(double angle_rad) { return {std::cos(angle_rad), std::sin(angle_rad)}; }
Vector2d turned(const Vector2d& v) { return {-v.y(), v.x()}; }
double crossed(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The linkage as it stands: links as vectors.
struct Links {
  Vector2d crank_m;
  Vector2d rocker_m;
  Vector2d coupler_m;  ///< From the crank's pin to the rocker's.
};

Links links_of(const FourBarGeometry& four_bar, double crank_rad, double rocker_rad) {
  Links links;
  links.crank_m = four_bar.crank_m * direction(crank_rad);
  links.rocker_m = four_bar.rocker_m * direction(rocker_rad);
  links.coupler_m = Vector2d(four_bar.ground_m, 0) + links.rocker_m - links.crank_m;
  return links;
}

/// Angle between two links from being in line, 0 to a right one.
double from_line_rad(const Vector2d& a, const Vector2d& b) {
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

double FourBar::rocker_rad(const SmallVector& joint_rad) const {
  return geometry_.rocker_zero_rad + geometry_.rocker_direction * joint_rad[0];
}

std::optional<double> FourBar::crank_rad(double rocker_rad) const {
  if (is_parallelogram()) return rocker_rad;
  const Vector2d pin = Vector2d(geometry_.ground_m, 0) + geometry_.rocker_m * direction(rocker_rad);
  const double a = geometry_.crank_m, b = geometry_.coupler_m;
  // The side of the crossed linkage changes where the parallelogram's does.
  const int side = has_change_points() && std::sin(rocker_rad) < 0 ? -1 : 1;
  return closing_angle_rad(2 * a * pin.x(), 2 * a * pin.y(), pin.squaredNorm() + a * a - b * b,
                           side * geometry_.branch);
}

std::optional<Transfer> FourBar::transfer(const SmallVector& joint_rad,
                                          const SmallVector& joint_rad_s) const {
  const double rocker = rocker_rad(joint_rad);
  const auto crank = crank_rad(rocker);
  if (!crank) return std::nullopt;
  const Links links = links_of(geometry_, *crank, rocker);
  const Vector2d crank_rate = turned(links.crank_m), rocker_rate = turned(links.rocker_m);
  const double n = links.coupler_m.dot(rocker_rate), m = links.coupler_m.dot(crank_rate);  // (8)
  const double b = geometry_.coupler_m;
  if (!(std::abs(m) > kInLine * b * geometry_.crank_m)) return std::nullopt;
  if (!(std::abs(n) > kInLine * b * geometry_.rocker_m)) return std::nullopt;

  const double ratio = is_parallelogram() ? 1.0 : n / m;
  const double rocker_speed = geometry_.rocker_direction * joint_rad_s[0];
  const double crank_speed = ratio * rocker_speed;
  const Vector2d stretch = rocker_rate * rocker_speed - crank_rate * crank_speed;
  const double n_rate =
      stretch.dot(rocker_rate) - links.coupler_m.dot(links.rocker_m) * rocker_speed;
  const double m_rate = stretch.dot(crank_rate) - links.coupler_m.dot(links.crank_m) * crank_speed;
  const double ratio_rate = is_parallelogram() ? 0.0 : (n_rate - ratio * m_rate) / m;  // (10)

  const int sign = geometry_.crank_direction * geometry_.rocker_direction;
  Transfer transfer{SmallVector(1), SmallMatrix(1, 1), SmallMatrix(1, 1)};
  // Zeros first: the parallelogram's actuator then stands exactly where its joint does.
  const double turn = is_parallelogram() ? geometry_.rocker_zero_rad - geometry_.crank_zero_rad +
                                               geometry_.rocker_direction * joint_rad[0]
                                         : std::remainder(*crank - geometry_.crank_zero_rad, kTurn);
  transfer.actuator_position_rad[0] = geometry_.crank_direction * turn;
  transfer.jacobian(0, 0) = sign * ratio;
  transfer.jacobian_rate_1_s(0, 0) = sign * ratio_rate;
  return transfer;
}

std::vector<MechanismMargin> FourBar::margins(const SmallVector& joint_rad) const {
  const double a = geometry_.crank_m, b = geometry_.coupler_m;
  const double rocker = rocker_rad(joint_rad);
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
  const auto crank = crank_rad(rocker);
  if (!crank) return margins;
  const Links links = links_of(geometry_, *crank, rocker);
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
