// SPDX-License-Identifier: Apache-2.0
// Equations: docs/derivations/impact.md.
#include "tests/dynamics/contact_law.hpp"

#include <Eigen/LU>
#include <cmath>
#include <numbers>
#include <optional>

namespace torquewright::test {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kDirections = 64;  // scanned for a change of sign before it is halved
constexpr int kHalvings = 60;    // an angle to the last bit

/// Sliding into the direction d: impulse, and the velocity after it.
struct Slide {
  bool possible = false;  // a positive normal impulse stops the approach
  Vector3d impulse_N_s;
  Vector2d slip_m_s;
};

// eq. (5)
Slide slide(const LocalContact& contact, double angle_rad) {
  const Vector2d d(std::cos(angle_rad), std::sin(angle_rad));
  Vector3d pull;
  pull << -contact.friction_coefficient * d, 1;
  const double mobility = contact.mobility.row(2).dot(pull);
  if (!(mobility > 0)) return {};
  const Vector3d impulse = -contact.velocity.z() / mobility * pull;
  return {true, impulse, (contact.velocity + contact.mobility * impulse).head<2>()};
}

/// Zero where the slip goes along the direction (or against it).
double aside(const Slide& slide, double angle_rad) {
  return slide.slip_m_s.y() * std::cos(angle_rad) - slide.slip_m_s.x() * std::sin(angle_rad);
}

double ahead(const Slide& slide, double angle_rad) {
  return slide.slip_m_s.x() * std::cos(angle_rad) + slide.slip_m_s.y() * std::sin(angle_rad);
}

/// Between two angles at which `aside` changes its sign; eq. (6).
std::optional<Vector3d> slide_between(const LocalContact& contact, double left_rad,
                                      double right_rad) {
  const bool left_sign = aside(slide(contact, left_rad), left_rad) > 0;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle_rad = 0.5 * (left_rad + right_rad);
    const Slide middle = slide(contact, middle_rad);
    if (!middle.possible) return std::nullopt;
    ((aside(middle, middle_rad) > 0) == left_sign ? left_rad : right_rad) = middle_rad;
  }
  const Slide found = slide(contact, left_rad);
  if (!(ahead(found, left_rad) >= 0)) return std::nullopt;
  return found.impulse_N_s;
}

std::optional<Vector3d> sliding(const LocalContact& contact) {
  constexpr double kWidth = 2 * std::numbers::pi / kDirections;
  // From the direction of the slip without friction, where most slides are found at once.
  const double start_rad = std::atan2(contact.velocity.y(), contact.velocity.x());
  for (int i = 0; i < kDirections; ++i) {
    // 0, -1, 1, -2, 2, ...
    const int step = i % 2 == 0 ? i / 2 : -(i + 1) / 2;
    const double left_rad = start_rad + (step - 0.5) * kWidth;
    const double right_rad = left_rad + kWidth;
    const Slide left = slide(contact, left_rad);
    const Slide right = slide(contact, right_rad);
    if (!left.possible || !right.possible) continue;
    if ((aside(left, left_rad) > 0) == (aside(right, right_rad) > 0)) continue;
    if (const auto found = slide_between(contact, left_rad, right_rad)) return found;
  }
  return std::nullopt;
}

}  // namespace

Vector3d impulse_N_s(const LocalContact& contact) {
  if (contact.velocity.z() >= 0) return Vector3d::Zero();
  const Vector3d stick = -(contact.mobility.inverse() * contact.velocity);  // eq. (4)
  const double limit = contact.friction_coefficient * stick.z();
  if (stick.z() > 0 && stick.head<2>().norm() <= limit) return stick;
  if (const auto slid = sliding(contact)) return *slid;
  // Only at the cone's very edge, where rounding hides the slide: it sticks there.
  if (!(stick.z() > 0)) return {0, 0, -contact.velocity.z() / contact.mobility(2, 2)};
  const double share = std::min(1.0, limit / stick.head<2>().norm());
  return {share * stick.x(), share * stick.y(), stick.z()};
}

}  // namespace torquewright::test
