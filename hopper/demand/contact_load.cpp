// SPDX-License-Identifier: Apache-2.0
#include "hopper/demand/contact_load.hpp"

#include <cmath>

#include "hopper/demand/running_integral.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Drives' names and ratios, in the order of the demand's drives.
std::vector<ContactLoad> empty_loads(const Robot& robot) {
  std::vector<ContactLoad> loads;
  for (const Drivetrain& drivetrain : robot.drivetrains) {
    for (std::size_t i = 0; i < drivetrain.actuators.size(); ++i) {
      ContactLoad& load = loads.emplace_back();
      load.drive = drivetrain.actuator_names[i];
      load.ratio = std::abs(drivetrain.actuators[i].transmission.ratio);
    }
  }
  return loads;
}

void note_jolts(const Demand& demand, Index drive, ContactLoad& load) {
  for (const Jolt& jolt : demand.jolts) {
    const double impulse_Nm_s = std::abs(jolt.contact_Nm_s[drive]);
    if (impulse_Nm_s <= load.impulse_Nm_s) continue;
    load.impulse_Nm_s = impulse_Nm_s;
    load.impulse_time_s = jolt.time_s;
  }
}

}  // namespace

std::vector<ContactLoad> contact_loads(const CheckedMotion& checked) {
  const Demand& demand = checked.demand;
  std::vector<ContactLoad> loads = empty_loads(checked.robot);
  if (!demand.has_dynamics) return {};
  const MatrixXd magnitudes = demand.contact_Nm.cwiseAbs();
  const RunningIntegral steady(checked.motion.times_s, magnitudes);
  RunningIntegral all(checked.motion.times_s, magnitudes);
  for (const Jolt& jolt : demand.jolts) all.add_impulse(jolt.sample, jolt.contact_Nm_s.cwiseAbs());
  const double window_s = checked.options.load_window_s;
  for (Index sample = 0; sample < checked.motion.samples(); ++sample) {
    const Eigen::VectorXd mean = all.over(sample, window_s) / window_s;
    for (std::size_t i = 0; i < loads.size(); ++i) {
      const auto drive = static_cast<Index>(i);
      if (mean[drive] <= loads[i].joint_Nm) continue;
      loads[i].joint_Nm = mean[drive];
      loads[i].time_s = checked.motion.time_s(sample);
      loads[i].steady_joint_Nm = steady.over(sample, window_s)[drive] / window_s;
    }
  }
  for (std::size_t i = 0; i < loads.size(); ++i) {
    loads[i].motor_Nm = loads[i].joint_Nm / loads[i].ratio;
    note_jolts(demand, static_cast<Index>(i), loads[i]);
  }
  return loads;
}

}  // namespace torquewright::hopper
