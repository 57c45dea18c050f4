// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <utility>

#include "actuator/motor/actuator.hpp"
#include "identification/log/log.hpp"
#include "identification/rig/rig.hpp"

namespace torquewright::identification::test_logs {

/// One joint at 100:1 on a free load of a stated inertia, driven at 10 Nm/A.
struct FreeJoint {
  explicit FreeJoint(double stated_kg_m2) {
    rig.joints = {""};
    rig.load.type = LoadType::kFree;
    rig.load.inertia_kg_m2 = stated_kg_m2;
    actuator.motor.torque_constant_Nm_A = 0.1;
    actuator.motor.resistance_ohm = 0.3;
    actuator.motor.pole_pairs = 7;
    actuator.drive.bus_voltage_V = 48.0;
    actuator.drive.peak_current_A = 60.0;
    actuator.transmission.ratio = 100.0;
  }

  Rig rig;
  actuator::Actuator actuator;
};

/// Three runs of one joint, 30 s each at 100 Hz, of which the last is held out. `add_row` adds what
/// its sensors show at a time of a run.
inline Log three_runs(
    const std::function<void(std::size_t run, double time_s, Run& into)>& add_row) {
  Log log;
  for (std::size_t r = 0; r < 3; ++r) {
    Run run;
    run.name = "run_" + std::to_string(r);
    (r == 2 ? log.holdout_runs : log.train_runs).push_back(run.name);
    run.joints.resize(1);
    for (int k = 0; k < 3000; ++k) {
      run.time_s.push_back(0.01 * k);
      add_row(r, run.time_s.back(), run);
    }
    run.masked.assign(run.time_s.size(), 0);
    log.runs.push_back(std::move(run));
  }
  return log;
}

}  // namespace torquewright::identification::test_logs
