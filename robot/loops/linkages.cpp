// SPDX-License-Identifier: Apache-2.0
#include "robot/loops/linkages.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "io/text/number_text.hpp"
#include "robot/loops/kept_loop.hpp"
#include "robot/loops/kept_loops.hpp"
#include "robot/loops/linkage_check.hpp"
#include "robot/loops/linkage_geometry.hpp"
#include "robot/loops/linkage_mass.hpp"
#include "robot/loops/narrowed_range.hpp"

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
        file_posture_(draft, {}),
        kept_(draft, driven, options) {}

  void read(const std::vector<Connect>& connects) {
    for (const Connect& connect : connects) {
      if (leaves_out(connect)) continue;
      auto found = rod_loop_of(draft_, connect, driven_);
      if (auto* objection = std::get_if<std::string>(&found)) {
        kept_.add(connect, std::move(*objection));
      } else {
        loops_.push_back(std::get<RodLoop>(std::move(found)));
      }
    }
    refuse_unknown_names();
    for (const RodLoop& loop : loops_) {
      const bool is_first = &first_with(loop.held) == &loop;
      if (is_first) read_one(loop);
    }
    do {
      take_out_links();
    } while (!check());
    narrow_linkages();
    kept_.make(lumped_, imported_, faults_);
    faults_.refuse();
    note_linkages();
    put_in_robot();
  }

 private:
  /// Whether the user asked for it, by its own name or that of an end.
  bool leaves_out(const Connect& connect) {
    if (!is_opened(connect, options_.opened_loops)) return false;
    for (const std::string& name : options_.opened_loops) {
      if (is_called(connect, name)) opened_names_.insert(name);
    }
    imported_.notes.push_back(fmt::format(
        "the loop between \"{}\" and \"{}\" is opened (--open-loop): nothing holds its ends "
        "together, and its joints move each by itself",
        connect.names[0], connect.names[1]));
    return true;
  }

  void refuse_unknown_names() {
    for (const std::string& name : options_.opened_loops) {
      if (opened_names_.contains(name)) continue;
      throw io::SpecError({{"--open-loop", "",
                            fmt::format("no <connect> that holds the robot is called \"{}\" or "
                                        "joins a body or site of that name",
                                        name)}});
    }
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
      keep(linkage, fmt::format("{} rods move joint{} {}: a four_bar has one rod on one joint, a "
                                "parallel_ankle two on two",
                                linkage.loops.size(), needed > 1 ? "s" : "", joints_of(first)));
      return;
    }
    // What is assembled in two ways is meant to be the one that is nearest to the file's bodies.
    LoopFollower closed(draft_, linkage.loops);
    closed.close();
    auto found = needed == 1 ? four_bar_of(draft_, first, closed)
                             : parallel_ankle_of(draft_, linkage.loops, closed);
    if (const auto* objection = std::get_if<std::string>(&found)) {
      keep(linkage, *objection);
      return;
    }
    linkage.mechanism = std::get<std::shared_ptr<const Mechanism>>(std::move(found));
    linkages_.push_back(std::move(linkage));
  }

  void keep(const Linkage& linkage, const std::string& why) {
    for (const RodLoop& loop : linkage.loops) kept_.add(loop.connect, why);
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
    lumped_ = draft_;
    is_link_.assign(draft_.size(), false);
    mass_kg_ = 0;
    for (Linkage& linkage : linkages_) {
      linkage.rotors_kg_m2.clear();
      linkage.cranks_kg_m2.clear();
      for (const RodLoop& loop : linkage.loops) {
        is_link_[loop.crank] = true;
        for (const std::size_t part : loop.rod) is_link_[part] = true;
        mass_kg_ += draft_[loop.crank].body.inertia.mass_kg;
        for (const std::size_t part : loop.rod) mass_kg_ += draft_[part].body.inertia.mass_kg;
        linkage.rotors_kg_m2.push_back(draft_[loop.crank].body.joint.reflected_inertia);
        linkage.cranks_kg_m2.push_back(
            options_.drops_link_mass ? 0 : lump_links(loop, file_posture_, lumped_));
      }
    }
    leave_out_links();
  }

  void leave_out_links() {
    index_.assign(draft_.size(), 0);
    left_.clear();
    for (std::size_t i = 0; i < lumped_.size(); ++i) {
      if (is_link_[i]) continue;
      index_[i] = left_.size();
      left_.push_back(lumped_[i]);
      left_.back().body.parent = index_[left_.back().body.parent];
    }
  }

  /// Of those whose mass its neighbours cannot have, the one that is off the most: others may only
  /// seem so because of it.
  void refuse_heaviest(std::vector<LinkageDifference>& differences) const {
    if (options_.drops_link_mass || differences.empty()) return;
    const auto worst = std::max_element(
        differences.begin(), differences.end(),
        [](const auto& one, const auto& other) { return one.energy_share < other.energy_share; });
    if (!worst->trouble.empty() || worst->energy_share <= options_.greatest_link_error) return;
    const auto index = static_cast<std::size_t>(worst - differences.begin());
    worst->trouble = fmt::format(
        "cranks and rods weigh {:.4g} kg, and a {} has rods without mass: with their mass put to "
        "their neighbours the kinetic energy of a motion is off by up to {:.2g} of it, more than "
        "{:.2g} (--link-error allows more, --massless-links leaves their mass out)",
        mass_kg_, linkages_[index].mechanism->type(), worst->energy_share,
        options_.greatest_link_error);
  }

  /// False where some linkages were none after all, and are kept as loops.
  bool check() {
    LinkageCheck check(draft_, left_, linkages_, index_);
    std::vector<LinkageDifference> differences;
    for (std::size_t i = 0; i < linkages_.size(); ++i) differences.push_back(check.run(i));
    refuse_heaviest(differences);
    std::vector<Linkage> stay;
    off_.clear();
    for (std::size_t i = 0; i < linkages_.size(); ++i) {
      if (!differences[i].trouble.empty()) {
        keep(linkages_[i], differences[i].trouble);
        continue;
      }
      stay.push_back(linkages_[i]);
      off_.push_back(differences[i]);
    }
    const bool all_stay = stay.size() == linkages_.size();
    linkages_ = std::move(stay);
    return all_stay;
  }

  void narrow_linkages() {
    for (const Linkage& linkage : linkages_) {
      std::vector<std::size_t> cranks;
      for (const RodLoop& loop : linkage.loops) cranks.push_back(loop.crank);
      narrow_held(*linkage.mechanism, linkage.loops.front().held, cranks, draft_, lumped_,
                  imported_.notes);
    }
  }

  void note_linkages() {
    double worst = 0;
    for (std::size_t i = 0; i < linkages_.size(); ++i) {
      worst = std::max(worst, off_[i].energy_share);
      imported_.notes.push_back(
          fmt::format("what moves {} is read as a {}, driven at {}: in {} postures cranks stand "
                      "where the file's bodies do, to within {:.1g} rad",
                      joints_of(linkages_[i].loops.front()), linkages_[i].mechanism->type(),
                      fmt::join(names_of(linkages_[i]), " and "), off_[i].postures,
                      io::known(off_[i].crank_rad, 1.0)));
    }
    if (linkages_.empty()) return;
    imported_.notes.push_back(
        options_.drops_link_mass
            ? fmt::format("cranks and rods are left out with their {:.4g} kg: the kinetic energy "
                          "of a motion is off by at most {:.2g} of it",
                          mass_kg_, worst)
            : fmt::format(
                  "cranks and rods weigh {:.4g} kg, which goes to their neighbours: of rods "
                  "to points at their pins, of cranks to their axes, and their inertia "
                  "about these to the drives. The kinetic energy of a motion is off by at "
                  "most {:.2g} of it",
                  mass_kg_, worst));
  }

  std::vector<std::string> names_of(const Linkage& linkage) const {
    std::vector<std::string> names;
    for (const RodLoop& loop : linkage.loops)
      names.push_back(drive_of(draft_, driven_, loop.crank));
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
    for (const std::size_t link : kept_.links()) is_link_[link] = true;
    leave_out_links();
    for (const Linkage& linkage : linkages_) {
      Drivetrain drivetrain;
      drivetrain.mechanism = linkage.mechanism;
      for (const std::size_t held : linkage.loops.front().held) {
        drivetrain.joints.push_back(index_[held]);
      }
      drivetrain.actuator_names = names_of(linkage);
      for (const RodLoop& loop : linkage.loops) {
        const dynamics::Joint& crank = draft_[loop.crank].body.joint;
        imported_.loop_drives[drive_of(draft_, driven_, loop.crank)] = {
            false, crank.limits, crank.passive.dry_friction, crank.passive.damping};
      }
      drivetrain.rotors_in_tree = false;
      if (states_rotors(linkage)) drivetrain.stated_rotors_kg_m2 = linkage.rotors_kg_m2;
      if (!options_.drops_link_mass) drivetrain.cranks_kg_m2 = linkage.cranks_kg_m2;
      imported_.robot.drivetrains.push_back(std::move(drivetrain));
      note_ranges(linkage);
      note_drag(linkage);
    }
    kept_.put_in_robot(index_, imported_);
    draft_ = std::move(left_);
  }

  /// A mechanism has no friction of its own.
  void note_drag(const Linkage& linkage) {
    for (const RodLoop& loop : linkage.loops) {
      const dynamics::Joint& crank = draft_[loop.crank].body.joint;
      if (!crank.passive.is_none()) {
        imported_.notes.push_back(fmt::format(
            "damping and friction of \"{}\", a crank's joint, are its drive's: --actuators writes "
            "them to its document, and any other must state them",
            crank.name));
      }
      for (const std::size_t link : loop.rod) {
        const dynamics::Joint& joint = draft_[link].body.joint;
        if (joint.passive.is_none()) continue;
        imported_.notes.push_back(fmt::format(
            "damping of {:.4g} N m s/rad and dry friction of {:.4g} N m of \"{}\", a joint of a "
            "rod, are not held",
            joint.passive.damping, joint.passive.dry_friction, joint.name));
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
          fmt::format("range and limit of effort of crank joint \"{}\" are not held: its drive's "
                      "document limits what it gives (--actuators makes it of the file's limits)",
                      crank.name));
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
  std::vector<LinkageDifference> off_;  ///< By linkage.
  KeptLoops kept_;                      ///< That are no linkages.
  std::set<std::string> opened_names_;
  std::vector<DraftBody> lumped_;  ///< All drafts, with what the linkages' links give them.
  std::vector<DraftBody> left_;    ///< Of these, those that are no links.
  std::vector<bool> is_link_;
  std::vector<std::size_t> index_;  ///< In left_, of what is no link.
  double mass_kg_ = 0;              ///< Of the linkages' links.
};

}  // namespace

void read_linkages(const std::vector<Connect>& connects, const DrivenJoints& driven,
                   const ImportFileOptions& options, std::vector<DraftBody>& draft,
                   Imported& imported, Faults& faults) {
  LinkageReader(driven, options, draft, imported, faults).read(connects);
}

}  // namespace torquewright::hopper
