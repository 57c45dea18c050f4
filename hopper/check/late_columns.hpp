// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hopper/demand/checked_motion.hpp"
#include "hopper/motion/row_comparison.hpp"

namespace torquewright::hopper {

/// Columns of a motion that belong to the row before: simulators store positions and velocities
/// after a step beside what they computed at its beginning.
struct LateColumns {
  bool accelerations = false;
  bool forces = false;  ///< Contact forces.
  bool flags = false;   ///< Contact flags.
  bool torques = false;

  bool any() const { return accelerations || forces || flags || torques; }
};

/// Returns the motion with these columns moved to the row before; the last row, which then lacks
/// them, is left out.
Motion moved_to_row_before(Motion motion, const LateColumns& columns);

/// Reads a file's columns, each in the row that its own physics says: accelerations in that of the
/// velocities, forces and flags in that of the base, torques in that of the drives
/// (docs/derivations/whole_body_check.md, "Rows").
class RowReading {
 public:
  /// Moves the motion's late columns, but for torques, which go with the accelerations. Requires
  /// rates that are not derived yet. Throws io::SpecError where all is to be moved and rows state
  /// an impact.
  RowReading(const Robot& robot, const CheckOptions& options, Motion& motion);

  /// Decides on the torques by the demand of the motion. True: they were moved, or moved back, and
  /// the motion has another demand.
  bool settle_torques(const Demand& demand, Motion& motion);

  /// Returns the motion with the other reading of all that nothing decides; none: all is decided.
  std::optional<Motion> other() const;

  /// Takes the other reading of what nothing decides, because the first was refused.
  void take_other();

  const LateColumns& late() const { return late_; }
  const LateColumns& open() const { return open_; }

  /// Returns what was moved and why; empty: nothing.
  std::vector<Finding> findings() const;

 private:
  void judge(const Robot& robot, const CheckOptions& options, Motion& motion);
  void settle(bool LateColumns::*column, const RowEvidence& evidence, bool by_model);

  Motion file_;  ///< The motion as it was read.
  LateColumns late_;
  LateColumns open_;
  LateColumns given_;
  bool is_judged_ = false;
  std::vector<std::string> reasons_;
};

/// Names the columns: "accelerations and contact forces".
std::string words_of(const LateColumns& columns);

}  // namespace torquewright::hopper
