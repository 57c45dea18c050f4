// SPDX-License-Identifier: Apache-2.0
#include "robot/loops/kept_loop.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace torquewright::hopper {
namespace {

constexpr int kRangeSteps = 20;
constexpr double kLittle = 0.01;  // rad or m, by which every joint must be able to move

}  // namespace

std::string end_within_range(const Loop& loop, const std::vector<dynamics::Joint>& joints) {
  const auto count = static_cast<Eigen::Index>(joints.size());
  SmallVector home(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const auto& limits = joints[static_cast<std::size_t>(k)].limits;
    home[k] = std::clamp(0.0, limits.position_min, limits.position_max);
  }
  for (Eigen::Index k = 0; k < count; ++k) {
    const dynamics::Joint& joint = joints[static_cast<std::size_t>(k)];
    const double least = joint.limits.position_min, most = joint.limits.position_max;
    if (!std::isfinite(least) || !std::isfinite(most)) continue;
    for (int step = 0; step <= kRangeSteps; ++step) {
      SmallVector at = home;
      at[k] = least + (most - least) * step / kRangeSteps;
      if (loop.transfer(at, SmallVector::Zero(count))) continue;
      return fmt::format(
          "it opens, or its links are in line, at \"{}\" = {:.4g}, within the joint's range of "
          "{:.4g} to {:.4g}",
          joint.name, at[k], least, most);
    }
  }
  return "";
}

std::string stuck_joint(const ClosedLinks& links, const std::vector<dynamics::Joint>& joints) {
  const Eigen::VectorXd home = links.geometry().start.head(links.geometry().joints);
  for (Eigen::Index k = 0; k < home.size(); ++k) {
    const dynamics::Joint& joint = joints[static_cast<std::size_t>(k)];
    const double least = joint.limits.position_min, most = joint.limits.position_max;
    const double little = std::min(kLittle, (most - least) / kRangeSteps);
    Eigen::VectorXd at = home;
    at[k] += home[k] + little <= most ? little : -little;
    if (links.follow<double>(at, Eigen::VectorXd::Zero(home.size()))) continue;
    return fmt::format("it holds \"{}\" where it stands, at {:.4g}: the loop opens at {:.4g}",
                       joint.name, home[k], at[k]);
  }
  return "";
}

std::string drive_of(const std::vector<DraftBody>& draft, const DrivenJoints& driven,
                     std::size_t turned) {
  const std::string& joint = draft[turned].body.joint.name;
  const auto drive = driven.find(joint);
  return drive == driven.end() || drive->second.empty() ? joint : drive->second;
}

/// Of its links without mass, where that is dropped.
LoopGeometry KeptLoop::geometry() const {
  LoopGeometry geometry = loop.geometry();
  for (dynamics::Body& body : geometry.tree.bodies) {
    if (drops_mass) body.inertia = {};
  }
  return geometry;
}

Follower KeptLoop::follower(const std::vector<std::size_t>& index) const {
  Follower follower;
  follower.links = std::make_shared<ClosedLinks>(geometry());
  for (const std::size_t joint : loop.joints) follower.joints.push_back(index[joint]);
  return follower;
}

Drivetrain KeptLoop::drivetrain(const std::vector<std::size_t>& index) const {
  Drivetrain drivetrain;
  drivetrain.mechanism = drops_mass ? std::make_shared<Loop>(geometry()) : loop.mechanism;
  for (const std::size_t joint : loop.joints) drivetrain.joints.push_back(index[joint]);
  drivetrain.rotors_in_tree = false;
  const auto states = [&](std::size_t joint) { return draft[joint].states_rotor; };
  const bool states_rotor = std::any_of(loop.turned.begin(), loop.turned.end(), states) ||
                            std::any_of(loop.joints.begin(), loop.joints.end(), states);
  for (const std::size_t turned : loop.turned) {
    drivetrain.actuator_names.push_back(drive_of(draft, driven, turned));
    if (!states_rotor) continue;
    // Of one of the robot's own that a drive turns itself, the joint has it already.
    drivetrain.stated_rotors_kg_m2.push_back(
        loop.has_link(turned) ? draft[turned].body.joint.reflected_inertia : 0);
  }
  return drivetrain;
}

void KeptLoop::add_notes(const std::string& why_kept, std::vector<std::string>& notes) const {
  double links_kg = 0;
  std::vector<std::string> own, drives, limited;
  for (const std::size_t joint : loop.joints) {
    own.push_back(fmt::format("\"{}\"", draft[joint].body.joint.name));
  }
  for (const std::size_t turned : loop.turned) drives.push_back(drive_of(draft, driven, turned));
  for (const std::size_t link : loop.links) {
    const dynamics::Joint& joint = draft[link].body.joint;
    links_kg += draft[link].body.inertia.mass_kg;
    if (std::isfinite(joint.limits.effort_max)) {
      limited.push_back(fmt::format("\"{}\"", joint.name));
    }
  }
  const std::string links = fmt::format("{} links of {:.4g} kg{}", loop.links.size(), links_kg,
                                        drops_mass ? ", left out" : "");
  notes.push_back(
      loop.mechanism
          ? fmt::format("what moves {} is kept as a loop of its own bodies, driven at {}, {}: "
                        "it is closed numerically, with its links' weight and friction; it is no "
                        "mechanism of closed form: {}",
                        fmt::join(own, " and "), fmt::join(drives, " and "), links, why_kept)
          : fmt::format(
                "{} follow {} (key followers): they are closed numerically, with their weight, "
                "springs and friction; they are no mechanism: {}",
                links, fmt::join(own, ", "), why_kept));
  if (loop.follower) add_note_of_ends(notes);
  if (!limited.empty()) {
    notes.push_back(fmt::format(
        "limits of effort of {}, joints within a loop, are not held: the document of its drive "
        "limits it",
        fmt::join(limited, ", ")));
  }
}

/// Several joints reach only part of what each one's range would let them.
void KeptLoop::add_note_of_ends(std::vector<std::string>& notes) const {
  const Eigen::VectorXd home = loop.geometry().start.head(loop.geometry().joints);
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(home.size());
  for (Eigen::Index k = 0; k < home.size(); ++k) {
    const dynamics::Joint& joint = draft[loop.joints[static_cast<std::size_t>(k)]].body.joint;
    for (const double end : {joint.limits.position_min, joint.limits.position_max}) {
      if (!std::isfinite(end)) continue;
      Eigen::VectorXd at = home;
      at[k] = end;
      if (loop.follower->follow<double>(at, rest)) continue;
      notes.push_back(fmt::format(
          "with the others at their starts \"{}\" does not reach {:.4g}, the end of its range: the "
          "links that follow it open before, and a check or replay that goes there says so",
          joint.name, end));
    }
  }
}

}  // namespace torquewright::hopper
