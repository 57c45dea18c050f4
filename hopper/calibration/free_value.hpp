// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "robot/model/robot.hpp"

namespace torquewright::io {
struct Document;
}

namespace torquewright::hopper::calibration {

/// One number of a robot's document, found in the robot that was read from it.
struct Knob {
  enum class Kind { kMass, kCenterOfMass, kInertia, kRoundInertia, kJointPosition, kPosture };
  Kind kind = Kind::kMass;
  std::size_t body = 0;     ///< Index in the tree; for a joint that of the body it carries.
  std::size_t posture = 0;  ///< Index in robot.postures.
  Eigen::Index row = 0;     ///< Row of a vector or an inertia.
  Eigen::Index column = 0;
};

/// Sets the number; of an inertia both mirrored elements.
void turn(const Knob& knob, double value, dynamics::Tree& tree, std::vector<Posture>& postures);

/// Describes the number with its owner and unit: "thigh: moment of inertia yy, kg m^2".
std::string words_of(const Knob& knob, const Robot& robot);

/// A value that a calibration may choose within bounds; several pointers take the same value.
struct FreeValue {
  std::vector<std::string> pointers;
  std::vector<Knob> knobs;
  std::string words;  ///< Description of the first knob.
  double documented = 0.0;
  double lowest = 0.0;
  double highest = 0.0;
  bool has_stated_bounds = false;

  std::string name() const;  ///< Returns the pointers, joined by commas.
};

/// Reads POINTER[,POINTER...][=LOW:HIGH]. Bounds that are not stated are plausible ones: half to
/// twice a mass, a quarter to four times a moment of inertia, 0.1 m about a place, the joint's
/// range. Throws io::SpecError, for `--free`: a pointer to nothing, to no number or to what bears
/// on neither CAM nor CAV, pointers with different values, bounds that are not ordered or leave a
/// joint's range.
FreeValue free_value(const std::string& text, const io::Document& document, const Robot& robot);

}  // namespace torquewright::hopper::calibration
