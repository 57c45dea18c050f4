// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "hopper/candidates/candidates.hpp"
#include "hopper/design/gear_choices.hpp"
#include "hopper/design/motor_shelf_spec.hpp"

namespace torquewright::hopper {

/// Which motor with which gears: what is asked.
struct CoDesignQuestion {
  std::size_t drivetrain = 0;
  MotorShelf shelf;
  gearbox::Problem problem;  ///< Its ratio is replaced by each of `ratios`.
  std::vector<io::Rational> ratios;
  std::size_t points = 1;  ///< Gearboxes of a ratio, on the front of its objective and efficiency.
  bool prunes = true;      ///< Search no gears for pairs that no efficiency would save.
  std::size_t threads = 1;
  std::function<bool()> should_stop = [] { return false; };
  std::function<void(const std::string& what, std::size_t done, std::size_t all)> report =
      [](const std::string&, std::size_t, std::size_t) {};
};

/// A motor behind gears, tried on the motion.
struct DesignedPair {
  std::size_t motor = 0;   ///< Of the shelf.
  std::size_t ratio = 0;   ///< Of the question's.
  std::size_t choice = 0;  ///< Of that ratio's gearboxes.
  std::optional<double> gears_kg;
  std::optional<double> mass_kg;  ///< Of motor and gears, where both are known.
  CandidateResult result;
};

/// A pair for which no gears were searched.
struct PrunedPair {
  std::size_t motor = 0;
  std::size_t ratio = 0;
  std::string why;
};

struct CoDesign {
  std::vector<GearsOfRatio> gears;  ///< By ratio.
  /// Those that do the motion first, by mass, those of unknown mass after them by their gears';
  /// then the undecided and the others, by margin.
  std::vector<DesignedPair> pairs;
  std::vector<PrunedPair> pruned;
  bool is_whole = true;  ///< No limit and no interrupt ended it.
};

/// The greatest torque that passes the gears of a drivetrain's actuators in a motion, at the
/// joint's side, whatever their motors' rotors take: what gears have to bear. `report` is
/// check_motion()'s.
double greatest_load_Nm(const Robot& robot, std::size_t drivetrain, const HopperReport& report);

/// Tries every motor of the shelf behind the proved gearboxes of every ratio, in one drivetrain of
/// a robot, on a motion, all other drives as the robot has them. Before gears are searched, each
/// motor is tried at each ratio behind gears that lose nothing when the motor drives, turn no
/// inertia and weigh nothing, and when the joint drives bear nearly all, or nothing. What fails
/// behind both, fails because of the motor and the ratio. `report` is check_motion()'s of the same.
CoDesign co_design(const Robot& robot, const Motion& motion, const CheckOptions& options,
                   const HopperReport& report, const CoDesignQuestion& question);

}  // namespace torquewright::hopper
