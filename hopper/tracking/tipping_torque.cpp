// SPDX-License-Identifier: Apache-2.0
#include "hopper/tracking/tipping_torque.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "dynamics/point.hpp"
#include "hopper/contact/support_polygon.hpp"
#include "robot/model/touching_point.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

/// Moments per torque: less is rounding.
constexpr double kNoMoment = 1e-9;

std::vector<Vector2d> corners_m(WholeBody& body) {
  std::vector<Vector2d> corners;
  for (const ContactPoint& contact : body.robot().contacts) {
    const dynamics::BodyPoint point = touching_point(contact, body.state());
    corners.push_back(dynamics::point_position_m(body.state(), point).head<2>());
  }
  return corners;
}

/// How far each point is inside of each edge of the touching ones (edges x points), in m. No edges
/// where these span nothing.
MatrixXd distances_inside_m(const Robot& robot, const std::vector<Vector2d>& corners,
                            const TouchingPoints& touches) {
  std::vector<Vector2d> touching;
  for (Index i = 0; i < touches.size(); ++i) {
    if (touches[i]) touching.push_back(corners[static_cast<std::size_t>(i)]);
  }
  std::vector<Vector2d> inwards, on_edge;
  const std::vector<Vector2d> polygon = support_polygon(touching);
  if (robot.tree.base == dynamics::BaseKind::kPlanar) {
    const auto [back, front] =
        std::minmax_element(touching.begin(), touching.end(),
                            [](const Vector2d& a, const Vector2d& b) { return a.x() < b.x(); });
    if (touching.size() >= 2 && back->x() < front->x()) {
      inwards = {Vector2d::UnitX(), -Vector2d::UnitX()};
      on_edge = {*back, *front};
    }
  } else if (polygon.size() == 2) {  // over a line: its ends
    const Vector2d way = (polygon[1] - polygon[0]).normalized();
    inwards = {way, -way};
    on_edge = {polygon[0], polygon[1]};
  } else if (polygon.size() >= 3) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vector2d way = (polygon[(i + 1) % polygon.size()] - polygon[i]).normalized();
      inwards.emplace_back(-way.y(), way.x());  // they run counter-clockwise
      on_edge.push_back(polygon[i]);
    }
  }
  MatrixXd inside(static_cast<Index>(inwards.size()), static_cast<Index>(corners.size()));
  for (Index edge = 0; edge < inside.rows(); ++edge) {
    for (Index point = 0; point < inside.cols(); ++point) {
      const auto e = static_cast<std::size_t>(edge), p = static_cast<std::size_t>(point);
      inside(edge, point) = inwards[e].dot(corners[p] - on_edge[e]);
    }
  }
  return inside;
}

/// From each edge to the touching point that is farthest inside.
VectorXd widths_of(const MatrixXd& inside_m, const TouchingPoints& touches) {
  VectorXd widths_m = VectorXd::Zero(inside_m.rows());
  for (Index point = 0; point < touches.size(); ++point) {
    if (touches[point]) widths_m = widths_m.cwiseMax(inside_m.col(point)).eval();
  }
  return widths_m;
}

}  // namespace

std::optional<VectorXd> tipping_torques_Nm(WholeBody& body, const DrivenState& at,
                                           const TouchingPoints& touches) {
  const Index drives = at.drive_Nm.size();
  VectorXd tipping_Nm = VectorXd::Constant(drives, std::numeric_limits<double>::infinity());
  const auto now_N = ground_forces_N(body, at, touches);
  if (!now_N) return std::nullopt;
  const MatrixXd inside_m = distances_inside_m(body.robot(), corners_m(body), touches);
  const double weight_N = now_N->row(2).sum();
  if (inside_m.rows() == 0 || weight_N <= 0.0) return tipping_Nm;
  const VectorXd widths_m = widths_of(inside_m, touches);
  for (Index drive = 0; drive < drives; ++drive) {
    DrivenState more = at;
    more.drive_Nm[drive] += 1.0;
    const auto then_N = ground_forces_N(body, more, touches);
    if (!then_N) return std::nullopt;
    // Moments about the edges, zero where the centre of pressure is on one: linear in the torques.
    const VectorXd slope = inside_m * (*then_N - *now_N).row(2).transpose();
    for (Index edge = 0; edge < slope.size(); ++edge) {
      if (std::abs(slope[edge]) < kNoMoment) continue;
      const double half_way_Nm = 0.5 * weight_N * widths_m[edge];
      tipping_Nm[drive] = std::min(tipping_Nm[drive], half_way_Nm / std::abs(slope[edge]));
    }
  }
  return tipping_Nm;
}

}  // namespace torquewright::hopper
