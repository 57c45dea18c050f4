// SPDX-License-Identifier: Apache-2.0
#include "robot/draft/named_feet.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/faults/refusal.hpp"
#include "io/text/name_pattern.hpp"
#include "io/text/wording.hpp"
#include "robot/draft/foot_points.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Vector3d;
using Shapes = std::vector<const DraftShape*>;

constexpr const char* kFeetOption = "--feet";

/// Corners of a sole, each once where it has no width or no length.
std::vector<Vector3d> corners_m(const SolePatch& sole, const DraftMark& at) {
  std::vector<Vector3d> corners;
  for (const auto& [x_m, y_m] : {std::pair{sole.x_most_m, sole.y_most_m},
                                 {sole.x_most_m, sole.y_least_m},
                                 {sole.x_least_m, sole.y_least_m},
                                 {sole.x_least_m, sole.y_most_m}}) {
    const Vector3d corner_m = at.p_m + at.R * Vector3d(x_m, y_m, sole.z_m);
    const auto is_same = [&](const Vector3d& other) { return other == corner_m; };
    if (std::none_of(corners.begin(), corners.end(), is_same)) corners.push_back(corner_m);
  }
  return corners;
}

/// Meshes where there is nothing else.
Shapes that_touch(const Shapes& shapes) {
  Shapes solids, meshes;
  for (const DraftShape* shape : shapes) {
    if (shape->mesh) {
      meshes.push_back(shape);
    } else if (shape->primitive != Primitive::kEllipsoid) {
      solids.push_back(shape);
    }
  }
  return solids.empty() ? meshes : solids;
}

class NamedSearch {
 public:
  NamedSearch(const std::vector<DraftBody>& draft, const NamedFeet& named, FootPoints& feet)
      : draft_(draft), named_(named), feet_(feet) {}

  bool find() {
    for (std::size_t body = 0; body < draft_.size(); ++body) {
      try_place(body, {draft_[body].body.name});
      for (const DraftMark& mark : draft_[body].marks) try_place(body, mark);
      if (!named_.sole) try_geoms(body);
    }
    return is_found_;
  }

 private:
  bool fits(const std::string& name) const { return io::fits_pattern(name, named_.pattern); }

  void try_place(std::size_t body, const DraftMark& mark) {
    if (!fits(mark.name)) return;
    is_found_ = true;
    if (named_.sole) {
      const std::vector<Vector3d> corners = corners_m(*named_.sole, mark);
      feet_.add_places(body, mark.name,
                       fmt::format("{} of {} (as stated)", corners.size(), mark.name), corners);
      return;
    }
    Shapes own;
    for (const DraftShape& shape : draft_[body].shapes) {
      if (shape.link == mark.name) own.push_back(&shape);
    }
    const Shapes touching = that_touch(own);
    for (const DraftShape* shape : touching) feet_.add(body, *shape);
    if (!touching.empty()) return;
    feet_.add_places(body, mark.name, fmt::format("1 of {} (its place)", mark.name), {mark.p_m});
  }

  void try_geoms(std::size_t body) {
    for (const DraftShape& shape : draft_[body].shapes) {
      if (fits(shape.link) || !fits(shape.name)) continue;
      is_found_ = true;
      feet_.add(body, shape);
    }
  }

  const std::vector<DraftBody>& draft_;
  const NamedFeet& named_;
  FootPoints& feet_;
  bool is_found_ = false;
};

}  // namespace

void add_named_feet(const std::vector<DraftBody>& draft, const std::vector<NamedFeet>& named,
                    Robot& robot, std::vector<std::string>& notes) {
  if (robot.tree.base == dynamics::BaseKind::kFixed) {
    io::refuse(kFeetOption,
               fmt::format("\"{}\" stands fixed and needs no feet; leave the option out",
                           draft.front().body.name));
  }
  FootPoints feet(draft, robot);
  for (const NamedFeet& one : named) {
    if (NamedSearch(draft, one, feet).find()) continue;
    io::refuse(kFeetOption, fmt::format("\"{}\" fits no link, geom{} or site of the file",
                                        one.pattern, one.sole ? "'s body" : ""));
  }
  if (!feet.unread().empty()) {
    io::refuse(
        kFeetOption,
        fmt::format("the meshes of {} say nothing of where they touch; state the sole in the "
                    "link's axes, in m: NAME=X0:X1,Y0:Y1,Z",
                    io::listed(feet.unread())));
  }
  notes.push_back(
      fmt::format("contact points are taken as named by --feet: {}", io::listed(feet.taken())));
}

}  // namespace torquewright::hopper
