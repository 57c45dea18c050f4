// SPDX-License-Identifier: Apache-2.0
#include "robot/loops/kept_loop.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace torquewright::hopper {
namespace {

constexpr int kRangeSteps = 20;

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

std::string drive_of(const std::vector<DraftBody>& draft, const DrivenJoints& driven,
                     std::size_t turned) {
  const std::string& joint = draft[turned].body.joint.name;
  const auto drive = driven.find(joint);
  return drive == driven.end() || drive->second.empty() ? joint : drive->second;
}

std::shared_ptr<const Loop> KeptLoop::mechanism() const {
  if (!drops_mass) return loop.mechanism;
  LoopGeometry geometry = loop.mechanism->geometry();
  for (dynamics::Body& body : geometry.tree.bodies) body.inertia = {};
  return std::make_shared<Loop>(std::move(geometry));
}

Drivetrain KeptLoop::drivetrain(const std::vector<std::size_t>& index) const {
  Drivetrain drivetrain;
  drivetrain.mechanism = mechanism();
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
  std::vector<std::string> own, drives, dry, limited;
  for (const std::size_t joint : loop.joints) {
    own.push_back(fmt::format("\"{}\"", draft[joint].body.joint.name));
  }
  for (const std::size_t turned : loop.turned) drives.push_back(drive_of(draft, driven, turned));
  for (const std::size_t link : loop.links) {
    const dynamics::Joint& joint = draft[link].body.joint;
    links_kg += draft[link].body.inertia.mass_kg;
    if (joint.passive.dry_friction != 0) dry.push_back(fmt::format("\"{}\"", joint.name));
    if (std::isfinite(joint.limits.effort_max)) {
      limited.push_back(fmt::format("\"{}\"", joint.name));
    }
  }
  notes.push_back(fmt::format(
      "what moves {} is kept as a loop of its own bodies, driven at {}, {} links of {:.4g} kg{}: "
      "closed by numbers, its links' weight counted; no mechanism of closed form is it: {}",
      fmt::join(own, " and "), fmt::join(drives, " and "), loop.links.size(), links_kg,
      drops_mass ? ", left out" : "", why_kept));
  if (!dry.empty()) {
    notes.push_back(fmt::format(
        "dry friction of {}, joints within a loop, acts in no computation; state it in the drive's "
        "document",
        fmt::join(dry, ", ")));
  }
  if (!limited.empty()) {
    notes.push_back(fmt::format(
        "limits of effort of {}, joints within a loop, bind nothing: its drive's document does",
        fmt::join(limited, ", ")));
  }
}

}  // namespace torquewright::hopper
