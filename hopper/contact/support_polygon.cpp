// SPDX-License-Identifier: Apache-2.0
#include "hopper/contact/support_polygon.hpp"

#include <algorithm>
#include <limits>

namespace torquewright::hopper {
namespace {

using Eigen::Vector2d;

/// Positive where c lies left of the way from a to b.
double turn(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  const Vector2d ab = b - a;
  const Vector2d ac = c - a;
  return ab.x() * ac.y() - ab.y() * ac.x();
}

template <typename Iterator>
void add_chain(Iterator first, Iterator last, std::vector<Vector2d>& hull) {
  const std::size_t start = hull.size();
  for (; first != last; ++first) {
    while (hull.size() >= start + 2 && turn(hull[hull.size() - 2], hull.back(), *first) <= 0.0) {
      hull.pop_back();
    }
    hull.push_back(*first);
  }
  hull.pop_back();  // the first of the other chain
}

}  // namespace

std::vector<Vector2d> support_polygon(std::vector<Vector2d> points) {
  std::sort(points.begin(), points.end(), [](const Vector2d& one, const Vector2d& other) {
    return one.x() != other.x() ? one.x() < other.x() : one.y() < other.y();
  });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Vector2d> hull;
  add_chain(points.begin(), points.end(), hull);
  add_chain(points.rbegin(), points.rend(), hull);
  return hull;
}

double distance_inside(const std::vector<Vector2d>& polygon, const Vector2d& point) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2d& from = polygon[i];
    const Vector2d& to = polygon[(i + 1) % polygon.size()];
    least = std::min(least, turn(from, to, point) / (to - from).norm());
  }
  return least;
}

}  // namespace torquewright::hopper
