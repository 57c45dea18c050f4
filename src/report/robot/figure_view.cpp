// SPDX-License-Identifier: Apache-2.0
#include "src/report/robot/figure_view.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/report/parts/svg.hpp"

namespace torquewright::report {
namespace {

using Eigen::Vector2d;

struct Box {
  Vector2d least;
  Vector2d most;

  void include(const Vector2d& point) {
    least = least.cwiseMin(point);
    most = most.cwiseMax(point);
  }
};

}  // namespace

double FigureView::shift_m(const Pose& pose) const {
  return placement_.follows ? -pose.center_of_mass_m.x() : 0.0;
}

FigureView::FigureView(const std::vector<Pose>& poses, const Placement& placement)
    : placement_(placement) {
  const Vector2d first(poses.front().center_of_mass_m.x() + shift_m(poses.front()),
                       placement.ground_m);
  Box box{first, first + Vector2d(1e-3, 1e-3)};
  for (const Pose& pose : poses) {
    for (const Vector2d& point : pose.points) box.include(point + Vector2d(shift_m(pose), 0.0));
  }
  const Vector2d size_m = box.most - box.least;
  scale_ = std::min((placement.most_width - 2 * placement.margin) / size_m.x(),
                    (placement.most_height - 2 * placement.margin) / size_m.y());
  least_m_ = box.least;
  most_m_ = box.most;
  width_ = size_m.x() * scale_ + 2 * placement.margin;
  height_ = size_m.y() * scale_ + 2 * placement.margin;
}

Vector2d FigureView::at(const Vector2d& point_m) const {
  return {placement_.margin + (point_m.x() - least_m_.x()) * scale_,
          height_ - placement_.margin - (point_m.y() - least_m_.y()) * scale_};
}

Pose FigureView::on_paper(const Pose& pose) const {
  const Vector2d shift(shift_m(pose), 0.0);
  Pose placed = pose;
  for (Vector2d& point : placed.points) point = at(point + shift);
  placed.center_of_mass_m = at(pose.center_of_mass_m + shift);
  return placed;
}

double FigureView::proportion(const std::vector<Pose>& poses, double ground_m) {
  Box box{poses.front().points.front(), {poses.front().points.front().x(), ground_m}};
  box.include(box.least);
  box = {box.least.cwiseMin(box.most), box.least.cwiseMax(box.most)};
  for (const Pose& pose : poses) {
    for (const Vector2d& point : pose.points) box.include(point);
  }
  const Vector2d size_m = box.most - box.least;
  return size_m.x() / std::max(size_m.y(), 1e-9);
}

std::string bone_line(const Skeleton::Bone& bone, const Pose& pose, const std::string& attributes) {
  const Vector2d& from = pose.points[bone.from];
  const Vector2d& to = pose.points[bone.to];
  return fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\"{}/>\n", decimal(from.x(), 1),
                     decimal(from.y(), 1), decimal(to.x(), 1), decimal(to.y(), 1), attributes);
}

}  // namespace torquewright::report
