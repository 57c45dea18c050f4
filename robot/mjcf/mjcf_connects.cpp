// SPDX-License-Identifier: Apache-2.0
// Fields: MuJoCo's XML reference, "equality/connect", "site".
#include "robot/mjcf/mjcf_connects.hpp"

#include <fmt/format.h>

#include "robot/loops/loop_follower.hpp"

namespace torquewright::hopper {
namespace {

using dynamics::BodyPoint;
using Eigen::Vector3d;

constexpr double kMostReach_m = 100;  // the greatest length of documents

BodyPoint in_merged(const BodyPoint& point, const std::vector<DraftPlace>& places) {
  const DraftPlace& place = places[point.body];
  return {place.draft, place.p_m + place.R * point.p_B_m};
}

/// By two sites; empty where one is not there.
std::optional<std::array<BodyPoint, 2>> by_sites(const Element& connect,
                                                 const MjcfLandmarks& landmarks,
                                                 const std::vector<DraftPlace>& places) {
  std::array<BodyPoint, 2> ends;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto found = landmarks.sites.find(attribute(connect, i == 0 ? "site1" : "site2"));
    if (found == landmarks.sites.end()) return std::nullopt;
    ends[i] = in_merged(found->second, places);
  }
  return ends;
}

}  // namespace

void MjcfLandmarks::add(const Element& body, const std::vector<Placed>& held,
                        const DraftPlace& place, const MjcfContext& context) {
  const std::string name = attribute(body, "name");
  if (!name.empty()) bodies[name] = place;
  for (const Placed& placed : held) {
    if (placed.element->name != "site") continue;
    const Element site = context.defaults.completed(*placed.element, placed.childclass);
    if (find_attribute(site, "fromto") != nullptr) continue;
    const Vector3d own_m = context.faults.vector(site, "pos", Vector3d::Zero());
    const Vector3d in_body_m = placed.p_m + placed.R * own_m;
    sites[attribute(site, "name")] = {place.draft, place.p_m + place.R * in_body_m};
  }
}

std::optional<Connect> read_connect(const Element& connect, const MjcfLandmarks& landmarks,
                                    const std::vector<DraftPlace>& merged_places,
                                    const std::vector<DraftBody>& draft,
                                    const std::vector<std::string>& opened,
                                    const MjcfContext& context) {
  const bool has_sites = find_attribute(connect, "site1") != nullptr;
  Connect read{&connect, {}, {}};
  for (std::size_t i = 0; i < 2; ++i) {
    const char* key = has_sites ? (i == 0 ? "site1" : "site2") : (i == 0 ? "body1" : "body2");
    read.names[i] = attribute(connect, key);
    if (read.names[i].empty()) read.names[i] = "world";
  }
  if (is_opened(read, opened)) return read;
  const auto refused = [&](const char* why) {
    context.faults.report(connect, fmt::format("closes a loop between \"{}\" and \"{}\": {}",
                                               read.names[0], read.names[1], why));
    return std::nullopt;
  };
  if (has_sites) {
    const auto ends = by_sites(connect, landmarks, merged_places);
    if (!ends) return refused("both must be sites of the robot's bodies, each with a pos");
    read.ends = *ends;
    return read;
  }
  const auto one = landmarks.bodies.find(read.names[0]);
  const auto other = landmarks.bodies.find(read.names[1]);
  if (one == landmarks.bodies.end() || other == landmarks.bodies.end()) {
    return refused(
        "both must be bodies of the robot; a loop over the world is no mechanism here (--open-loop "
        "NAME leaves it out)");
  }
  const auto anchor_m = context.faults.numbers(connect, "anchor", 3);
  if (!anchor_m) return refused("its anchor is missing");
  const Vector3d in_body_m((*anchor_m)[0], (*anchor_m)[1], (*anchor_m)[2]);
  const DraftPlace& place = one->second;
  read.ends[0] = in_merged({place.draft, place.p_m + place.R * in_body_m}, merged_places);
  const LoopFollower file_posture(draft, {});
  const BodyPoint origin = in_merged({other->second.draft, Vector3d::Zero()}, merged_places);
  read.ends[1] = {origin.body, file_posture.seen_from(read.ends[0], origin.body)};
  for (const BodyPoint& end : read.ends) {
    if (!(end.p_B_m.norm() < kMostReach_m)) return refused("its anchor is beyond 100 m of a body");
  }
  return read;
}

}  // namespace torquewright::hopper
