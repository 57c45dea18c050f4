// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "robot/loops/general_loop.hpp"
#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// Where one joint's way through its range, the others nearest to zero, opens a loop or brings its
/// links in line, in a sentence; empty where none does. `joints`: those that it moves.
std::string end_within_range(const Loop& loop, const std::vector<dynamics::Joint>& joints);

/// Which joint the links that follow it hold where it stands, in a sentence; empty where all can
/// move.
std::string stuck_joint(const ClosedLinks& links, const std::vector<dynamics::Joint>& joints);

/// The drive that turns a draft's joint, by its own name; the joint's where it has none.
std::string drive_of(const std::vector<DraftBody>& draft, const DrivenJoints& driven,
                     std::size_t turned);

/// A loop of a file on its way into the robot.
struct KeptLoop {
  const GeneralLoop& loop;
  const std::vector<DraftBody>& draft;
  const DrivenJoints& driven;
  bool drops_mass = false;  ///< Of its links.

  /// `index`: where in the robot's tree each draft is. Nobody has named its actuators yet.
  Drivetrain drivetrain(const std::vector<std::size_t>& index) const;
  /// The same of links that follow.
  Follower follower(const std::vector<std::size_t>& index) const;
  /// What was kept, why it is no mechanism of closed form, and what of it is left out.
  void add_notes(const std::string& why_kept, std::vector<std::string>& notes) const;

 private:
  LoopGeometry geometry() const;
  void add_note_of_ends(std::vector<std::string>& notes) const;
};

}  // namespace torquewright::hopper
