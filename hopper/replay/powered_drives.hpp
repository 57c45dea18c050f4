// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "hopper/replay/powered_drive_options.hpp"
#include "hopper/tracking/drive_ranges.hpp"
#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// Results of the drives in a step, by drive (drives x 1).
struct DriveStep {
  /// Torque that acts at the output, with all effects of the drive's document: on rotor and load,
  /// or with an elastic train (free_rotors.hpp) on the load alone.
  Eigen::VectorXd torque_Nm;
  Eigen::VectorXd cut_off_Nm;  ///< Of what was wanted; signed, zero where nothing was. Further
                               ///< friction is not in it.
  Eigen::VectorXd current_A;   ///< Amplitude, in the document's convention.
  /// Temperature at the step's end; of a drive without thermal data the start's.
  Eigen::VectorXd winding_K;
  /// Voltage of the battery that feeds it, under the power of all its drives.
  Eigen::VectorXd bus_V;
  /// Least voltage of the drives that have a winding; empty: there are none.
  std::optional<double> least_bus_V;
  double power_W = 0.0;  ///< Power of all batteries together; negative: returned.
  /// A battery could not give the power, or not take it back. In the region (kMor) the motors'
  /// torques on it were cut by a common factor, so that it can.
  bool is_starved = false;
};

/// A robot's drives and batteries while they work: region, sag under all drives at once, friction,
/// heat. A torque inside the region acts as it is wanted, as far as the current can see to it: the
/// drive compensates what its document knows of friction and saturation. What no current evens out
/// acts besides, by simulation/joint: lag, backlash, compliance, presliding friction, waves,
/// springs and stops. docs/derivations/replay_drives.md.
///
/// The region is clipped by actuator/clip.hpp at the voltage that all drives on the battery leave
/// with the torques that then act: solved in every step, eq. (2). Temperatures are those at which
/// the step begins. One object serves one thread; copies share what was computed of the regions,
/// which does not depend on who asked for it first.
class PoweredDrives {
 public:
  /// Copies what it needs. Throws io::SpecError where actuator::objections() has some.
  PoweredDrives(const Robot& robot, const PoweredDriveOptions& options);
  PoweredDrives(const PoweredDrives& other);
  PoweredDrives(PoweredDrives&&) noexcept;
  PoweredDrives& operator=(PoweredDrives&&) noexcept;
  ~PoweredDrives();

  /// Returns the same drives under other options, at their start; they share the regions of one
  /// rating. For trials that differ in friction, charge or limits.
  PoweredDrives under(const PoweredDriveOptions& options) const;

  /// Cold, with the batteries at rest: the winding as the conditions say, else at the ambient of
  /// its thermal data, else as its document has it; the case at the ambient.
  void start();

  /// A step of positive length in which torques are wanted at the outputs, which begin it at these
  /// positions and turn at these speeds (drives x 1 each). std::invalid_argument on wrong sizes or
  /// numbers that are not finite.
  const DriveStep& drive(const Eigen::VectorXd& wanted_Nm, const Eigen::VectorXd& position_rad,
                         const Eigen::VectorXd& speed_rad_s, double step_s);

  /// Torques between which each drive is held, as DriveRanges::at() has it: what drive() cuts to,
  /// but for batteries that cannot give the power of all.
  void ranges(const Eigen::VectorXd& speed_rad_s, const Eigen::VectorXd& bus_V,
              const Eigen::VectorXd& winding_K, Eigen::VectorXd& least_Nm,
              Eigen::VectorXd& greatest_Nm) const;

  /// Charge that left each supply since the start, in the order of drive_supplies(), less what came
  /// back, in Ah.
  std::vector<double> drawn_Ah() const;

  Eigen::Index size() const;
  bool has_heat(Eigen::Index drive) const;

 private:
  class Work;
  explicit PoweredDrives(std::unique_ptr<Work> work);
  std::unique_ptr<Work> work_;
};

/// The ranges of a robot's drives under these options, for a controller.
std::shared_ptr<const DriveRanges> drive_ranges(const Robot& robot,
                                                const PoweredDriveOptions& options);

}  // namespace torquewright::hopper
