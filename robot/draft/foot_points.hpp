// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "robot/draft/draft.hpp"

namespace torquewright::hopper {

/// Puts contact points into a robot where shapes of its bodies touch the ground: balls as they are,
/// capsules and cylinders that lie by a ball at either end, boxes, cylinders that stand and meshes'
/// bounding boxes by four points of the side that is the lower one where all joints are at zero.
/// Where no friction is stated it is assumed, and the robot says so.
class FootPoints {
 public:
  /// Of drafts of which none is welded; both must outlive it.
  FootPoints(const std::vector<DraftBody>& draft, Robot& robot);

  void add(std::size_t body, const DraftShape& shape);
  /// Points without a radius, in the body's frame.
  void add_places(std::size_t body, const std::string& name, const std::string& said,
                  const std::vector<Eigen::Vector3d>& places_m);

  /// What was taken, in words.
  const std::vector<std::string>& taken() const { return taken_; }
  /// Shapes whose meshes say nothing, and why.
  const std::vector<std::string>& unread() const { return unread_; }

 private:
  void add_points(std::size_t body, const DraftShape& shape, const std::string& said);
  void add_point(std::size_t body, const std::string& name, const Eigen::Vector3d& place_m,
                 double radius_m, std::optional<double> friction_coefficient);
  std::string free_name(const std::string& name);

  Robot* robot_;
  std::vector<Eigen::Vector3d> downs_;  ///< By body, in its frame.
  std::set<std::string> names_;
  std::map<std::string, int> counts_;
  std::vector<std::string> taken_;
  std::vector<std::string> unread_;
};

}  // namespace torquewright::hopper
