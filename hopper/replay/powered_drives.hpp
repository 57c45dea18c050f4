// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "actuator/heat/heat_model.hpp"
#include "actuator/region/operating_conditions.hpp"
#include "hopper/robot/robot.hpp"

namespace torquewright::hopper {

/// What a drive's torque is held to.
enum class DriveLimits {
  kMor,  ///< Its motor operating region at the voltage and temperature of the instant.
  kBox,  ///< Its peak torque at any speed, and no driving torque beyond its no-load speed.
};

struct PoweredDriveOptions {
  DriveLimits limits = DriveLimits::kMor;
  actuator::OperatingConditions conditions;  ///< At the start.
  /// Coulomb friction beyond what the documents know, at each drive's output (drives x 1), which
  /// nobody compensates. Empty: none.
  Eigen::VectorXd further_friction_Nm;
};

/// What the drives did in a step. By drive.
struct DriveStep {
  Eigen::VectorXd torque_Nm;   ///< On the rotor's and load's side of the output: what acts.
  Eigen::VectorXd cut_off_Nm;  ///< Of what was wanted; signed, zero where nothing was.
  Eigen::VectorXd current_A;   ///< In the document's convention.
  Eigen::VectorXd winding_K;   ///< Empty without thermal data of all... NaN never: see has_heat().
  Eigen::VectorXd bus_V;       ///< Of the battery that feeds it.
  double power_W = 0.0;        ///< Of all batteries together.
  bool is_starved = false;     ///< A battery could not give the power; torque was cut for it.
};

/// A robot's drives and batteries while they work: region, sag under all drives at once, friction,
/// heat. One object serves one thread; copies share what was computed of the regions.
class PoweredDrives {
 public:
  /// The robot must outlive it. Throws as actuator::objections() say where the conditions cannot be
  /// met.
  PoweredDrives(const Robot& robot, const PoweredDriveOptions& options);
  ~PoweredDrives();
  PoweredDrives(PoweredDrives&&) noexcept;

  /// Cold (as the conditions say) and with the batteries at rest.
  void start();

  /// A step in which torques are wanted at the outputs (drives x 1) at these speeds there. Voltage
  /// and temperature are those that the step before left.
  const DriveStep& drive(const Eigen::VectorXd& wanted_Nm, const Eigen::VectorXd& speed_rad_s,
                         double step_s);

  Eigen::Index size() const;

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

}  // namespace torquewright::hopper
