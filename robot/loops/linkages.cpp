// SPDX-License-Identifier: Apache-2.0
#include "robot/loops/linkages.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "robot/loops/linkage_check.hpp"
#include "robot/loops/linkage_geometry.hpp"
#include "robot/loops/linkage_mass.hpp"

namespace torquewright::hopper {
namespace {

class LinkageReader {
 public:
  LinkageReader(const DrivenJoints& driven, const ImportFileOptions& options,
                std::vector<DraftBody>& draft, Imported& imported, Faults& faults)
      : driven_(driven),
        options_(options),
        draft_(draft),
        imported_(imported),
        faults_(faults),
        file_posture_(draft, {}) {}

  void read(const std::vector<Connect>& connects) {
    for (const Connect& connect : connects) {
      auto found = rod_loop_of(draft_, connect, driven_);
      if (const auto* objection = std::get_if<std::string>(&found)) {
        refuse(connect, *objection);
      } else {
        loops_.push_back(std::get<RodLoop>(std::move(found)));
      }
    }
    for (const RodLoop& loop : loops_) {
      const bool is_first = &first_with(loop.held) == &loop;
      if (is_first) read_one(loop);
    }
    faults_.refuse();
    take_out_links();
    check();
    faults_.refuse();
    put_in_robot();
  }

 private:
  void refuse(const Connect& connect, const std::string& why) {
    faults_.report(*connect.element, fmt::format("closes a loop between \"{}\" and \"{}\": {}",
                                                 connect.names[0], connect.names[1], why));
  }

  const RodLoop& first_with(const std::vector<std::size_t>& held) const {
    return *std::find_if(loops_.begin(), loops_.end(),
                         [&](const RodLoop& loop) { return loop.held == held; });
  }

  /// All loops that move the same joints.
  void read_one(const RodLoop& first) {
    Linkage linkage;
    for (const RodLoop& loop : loops_) {
      if (loop.held == first.held) linkage.loops.push_back(loop);
    }
    const std::size_t needed = first.held.size();
    if (linkage.loops.size() != needed) {
      refuse(first.connect,
             fmt::format("{} rods move joint{} {}: a four_bar has one rod on one joint, a "
                         "parallel_ankle two on two",
                         linkage.loops.size(), needed > 1 ? "s" : "", joints_of(first)));
      return;
    }
    auto found = needed == 1 ? four_bar_of(draft_, first, file_posture_)
                             : parallel_ankle_of(draft_, linkage.loops, file_posture_);
    if (const auto* objection = std::get_if<std::string>(&found)) {
      refuse(first.connect, *objection);
      return;
    }
    linkage.mechanism = std::get<std::shared_ptr<const Mechanism>>(std::move(found));
    linkages_.push_back(std::move(linkage));
  }

  std::string joints_of(const RodLoop& loop) const {
    std::vector<std::string> names;
    for (const std::size_t index : loop.held) {
      names.push_back(fmt::format("\"{}\"", draft_[index].body.joint.name));
    }
    return fmt::format("{}", fmt::join(names, " and "));
  }

  /// Drafts without them, and where each one that is left was.
  void take_out_links() {
    left_ = draft_;
    is_link_.assign(draft_.size(), false);
    for (Linkage& linkage : linkages_) {
      for (const RodLoop& loop : linkage.loops) {
        is_link_[loop.crank] = true;
        for (const std::size_t part : loop.rod) is_link_[part] = true;
        mass_kg_ += draft_[loop.crank].body.inertia.mass_kg;
        for (const std::size_t part : loop.rod) mass_kg_ += draft_[part].body.inertia.mass_kg;
        linkage.rotors_kg_m2.push_back(draft_[loop.crank].body.joint.reflected_inertia);
        linkage.cranks_kg_m2.push_back(
            options_.drops_link_mass ? 0 : lump_links(loop, file_posture_, left_));
      }
    }
    index_.assign(draft_.size(), 0);
    std::vector<DraftBody> kept;
    for (std::size_t i = 0; i < left_.size(); ++i) {
      if (is_link_[i]) continue;
      index_[i] = kept.size();
      kept.push_back(left_[i]);
      kept.back().body.parent = index_[kept.back().body.parent];
    }
    left_ = std::move(kept);
  }

  void check() {
    LinkageCheck check(draft_, left_, linkages_, index_);
    for (std::size_t i = 0; i < linkages_.size(); ++i) {
      const LinkageDifference off = check.run(i);
      const Linkage& linkage = linkages_[i];
      const Connect& connect = linkage.loops.front().connect;
      if (!off.trouble.empty()) {
        refuse(connect, off.trouble);
        continue;
      }
      worst_ = std::max(worst_, off.energy_share);
      imported_.notes.push_back(
          fmt::format("what moves {} is read as a {}, driven at {}: in {} postures cranks stand "
                      "where the file's bodies do, but for {:.1g} rad",
                      joints_of(linkage.loops.front()), linkage.mechanism->type(),
                      fmt::join(names_of(linkage), " and "), off.postures, off.crank_rad));
    }
    check_mass();
  }

  void check_mass() {
    if (linkages_.empty()) return;
    const Connect& first = linkages_.front().loops.front().connect;
    if (options_.drops_link_mass) {
      imported_.notes.push_back(
          fmt::format("cranks and rods are left out with their {:.4g} kg: the kinetic energy of a "
                      "motion is off by at most {:.2g} of it",
                      mass_kg_, worst_));
      return;
    }
    if (!(worst_ <= options_.greatest_link_error)) {
      refuse(first,
             fmt::format("cranks and rods weigh {:.4g} kg, and no mechanism of ours has a rod with "
                         "mass: put to their neighbours it leaves the kinetic energy of a motion "
                         "off by up to {:.2g} of it, more than {:.2g}; --link-error allows more, "
                         "--massless-links leaves their mass out",
                         mass_kg_, worst_, options_.greatest_link_error));
      return;
    }
    imported_.notes.push_back(fmt::format(
        "cranks and rods weigh {:.4g} kg, which their neighbours get (rods by points at their "
        "pins, cranks at their axes, and what they weigh about these the drives): the kinetic "
        "energy of a motion is off by at most {:.2g} of it",
        mass_kg_, worst_));
  }

  std::vector<std::string> names_of(const Linkage& linkage) const {
    std::vector<std::string> names;
    for (const RodLoop& loop : linkage.loops) {
      const std::string& joint = draft_[loop.crank].body.joint.name;
      const auto drive = driven_.find(joint);
      names.push_back(drive == driven_.end() || drive->second.empty() ? joint : drive->second);
    }
    return names;
  }

  /// Whether the file says what rotors weigh, at a crank or at what it moves. Else the actuators'
  /// own do.
  bool states_rotors(const Linkage& linkage) const {
    return std::any_of(linkage.loops.begin(), linkage.loops.end(), [&](const RodLoop& loop) {
      return draft_[loop.crank].states_rotor ||
             std::any_of(loop.held.begin(), loop.held.end(),
                         [&](std::size_t held) { return draft_[held].states_rotor; });
    });
  }

  void put_in_robot() {
    for (const Linkage& linkage : linkages_) {
      Drivetrain drivetrain;
      drivetrain.mechanism = linkage.mechanism;
      for (const std::size_t held : linkage.loops.front().held) {
        drivetrain.joints.push_back(index_[held]);
      }
      drivetrain.actuator_names = names_of(linkage);
      drivetrain.rotors_in_tree = false;
      if (states_rotors(linkage)) drivetrain.stated_rotors_kg_m2 = linkage.rotors_kg_m2;
      if (!options_.drops_link_mass) drivetrain.cranks_kg_m2 = linkage.cranks_kg_m2;
      imported_.robot.drivetrains.push_back(std::move(drivetrain));
      note_ranges(linkage);
      note_drag(linkage);
    }
    draft_ = std::move(left_);
  }

  /// A mechanism has no friction of its own.
  void note_drag(const Linkage& linkage) {
    for (const RodLoop& loop : linkage.loops) {
      std::vector<std::size_t> links = loop.rod;
      links.push_back(loop.crank);
      for (const std::size_t link : links) {
        const dynamics::Joint& joint = draft_[link].body.joint;
        if (joint.passive.is_none()) continue;
        imported_.notes.push_back(fmt::format(
            "damping and friction of \"{}\", a joint of a crank or a rod, are not held; state them "
            "in the drive's document",
            joint.name));
      }
    }
  }

  /// A document limits joints, and drives by their own documents.
  void note_ranges(const Linkage& linkage) {
    for (const RodLoop& loop : linkage.loops) {
      const dynamics::Joint& crank = draft_[loop.crank].body.joint;
      if (!std::isfinite(crank.limits.position_min) && !std::isfinite(crank.limits.effort_max)) {
        continue;
      }
      imported_.notes.push_back(
          fmt::format("range and limit of effort of crank joint \"{}\" are not held", crank.name));
    }
  }

  const DrivenJoints& driven_;
  const ImportFileOptions& options_;
  std::vector<DraftBody>& draft_;
  Imported& imported_;
  Faults& faults_;
  const LoopFollower file_posture_;
  std::vector<RodLoop> loops_;
  std::vector<Linkage> linkages_;
  std::vector<DraftBody> left_;
  std::vector<bool> is_link_;
  std::vector<std::size_t> index_;  ///< In left_, of what is no link.
  double mass_kg_ = 0;              ///< Of all links.
  double worst_ = 0;
};

}  // namespace

void read_linkages(const std::vector<Connect>& connects, const DrivenJoints& driven,
                   const ImportFileOptions& options, std::vector<DraftBody>& draft,
                   Imported& imported, Faults& faults) {
  LinkageReader(driven, options, draft, imported, faults).read(connects);
}

}  // namespace torquewright::hopper
