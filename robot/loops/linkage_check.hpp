// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "robot/loops/loop_follower.hpp"
#include "robot/loops/rod_loop.hpp"
#include "robot/mechanisms/mechanism.hpp"

namespace torquewright::hopper {

/// One or two loops of a file, and the mechanism that they are read as.
struct Linkage {
  std::vector<RodLoop> loops;  ///< Per drive.
  std::shared_ptr<const Mechanism> mechanism;
  std::vector<double> rotors_kg_m2;  ///< Per drive, of its crank's joint.
  std::vector<double> cranks_kg_m2;
};

/// How far a mechanism is from the bodies that it was read from.
struct LinkageDifference {
  std::string trouble;  ///< Why it is not theirs; empty if it is.
  int postures = 0;
  double crank_rad = 0;     ///< Greatest difference of a crank's position.
  double energy_share = 0;  ///< Greatest difference of a motion's kinetic energy, of it.
};

/// Holds mechanisms against the file's bodies, whose loops are closed by numbers.
class LinkageCheck {
 public:
  /// All drafts; those without cranks and rods, their mass put elsewhere or left out; where of the
  /// latter each of the former is.
  LinkageCheck(const std::vector<DraftBody>& all, const std::vector<DraftBody>& left,
               const std::vector<Linkage>& linkages, const std::vector<std::size_t>& index);

  /// Compares over the ranges of one linkage's joints, within half a turn of the file's posture, or
  /// 1 rad to both sides of it; all other joints stand as the file puts them.
  LinkageDifference run(std::size_t linkage);

 private:
  bool go_to(LoopFollower& file, const Linkage& linkage, const SmallVector& joint_rad,
             LinkageDifference& off) const;
  void compare(LoopFollower& file, const Linkage& linkage, const Transfer& transfer,
               LinkageDifference& off) const;
  Eigen::MatrixXd own_mass_matrix(const LoopFollower& file) const;
  SmallVector posture(const Linkage& linkage, const LoopFollower& file, int sample) const;

  const std::vector<DraftBody>& all_;
  const std::vector<DraftBody>& left_;
  const std::vector<Linkage>& linkages_;
  const std::vector<std::size_t>& index_;
};

}  // namespace torquewright::hopper
