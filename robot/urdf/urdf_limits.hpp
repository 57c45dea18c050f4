// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "robot/draft/draft.hpp"
#include "robot/xml/xml.hpp"

namespace torquewright::hopper {

/// Reads <limit> of URDF's joints. Where it leaves lower and upper out, or states both as zero
/// beside an effort or a velocity, the format says that the joint is locked, and MuJoCo, Pinocchio,
/// Bullet and Isaac let it move freely: so does this, unless locked joints are to be welds. A range
/// of one other position is a weld.
class UrdfLimits {
 public:
  UrdfLimits(bool welds_locked, Faults& faults) : welds_locked_(welds_locked), faults_(&faults) {}

  /// Into the joint of the draft, whose frame and axis are set. `has_range`: whether joints of its
  /// type have one.
  void read(const Element& limit, bool has_range, DraftBody& draft);

  /// Of a joint that ranges are for, and that has no <limit>.
  void read_none(DraftBody& draft);

  /// Which joints were welded or freed, state limits of 0, or seem to state degrees, in sentences.
  std::vector<std::string> notes() const;

 private:
  void read_range(const Element& limit, DraftBody& draft);
  double bound(const Element& limit, const char* name);
  void weld(bool is_stated, DraftBody& draft);

  bool welds_locked_;
  Faults* faults_;
  std::vector<std::string> welded_, wide_;                   ///< Sentences.
  std::vector<std::string> freed_;                           ///< Names, as the following.
  std::vector<std::string> without_effort_, without_speed_;  ///< That state it as 0.
};

}  // namespace torquewright::hopper
