// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "identification/signals/bench.hpp"

namespace torquewright::identification::made {

/// Of one instant of a made run: what a law of torque on the output may ask for.
struct Made {
  double time_s, angle_rad, speed_rad_s, current_A, torque_Nm;  ///< Torque: N Kt i.
};

/// A drive of round numbers on a dynamometer, and logs of it by closed forms: angles are sums of
/// sines, speeds their derivatives; the sensor shows N Kt i and whatever a law adds. No friction is
/// declared, and the rotor is next to massless. 4 runs of 12 s at 200 Hz, the last held out.
class MadeBench {
 public:
  static constexpr std::size_t kRuns = 4;
  static constexpr double kRatio = 10.0, kTorqueConstant_Nm_A = 0.1;

  MadeBench() {
    rig.joints = {""};
    actuator.motor.torque_constant_Nm_A = kTorqueConstant_Nm_A;
    actuator.motor.resistance_ohm = 0.5;
    actuator.motor.pole_pairs = 7;
    actuator.motor.rotor_inertia_kg_m2 = 1e-12;
    actuator.drive.bus_voltage_V = 48.0;
    actuator.drive.peak_current_A = 40.0;
    actuator.transmission.ratio = kRatio;
  }

  static double angle_rad(std::size_t run, double t) { return sum(run, t, false); }
  static double speed_rad_s(std::size_t run, double t) { return sum(run, t, true); }
  static double current_A(std::size_t run, double t) {
    const auto shift = static_cast<double>(run);
    return 6.0 * std::sin(1.7 * t + shift) + 3.0 * std::sin(4.3 * t + 2.0 * shift);
  }

  /// `added`: on the output, by the sensor. `late_s`: of the sensor. White noise of `sigma_Nm`.
  Log log(const std::function<double(const Made&)>& added, double sigma_Nm = 0.01,
          double late_s = 0.0) const {
    std::mt19937_64 random(5);
    std::normal_distribution<double> noise(0.0, sigma_Nm);
    Log made;
    for (std::size_t r = 0; r < kRuns; ++r) {
      Run run;
      run.name = "run_" + std::to_string(r);
      (r + 1 == kRuns ? made.holdout_runs : made.train_runs).push_back(run.name);
      run.joints.resize(1);
      for (int k = 0; k < 2400; ++k) {
        const double t = 0.005 * k;
        run.time_s.push_back(t);
        run.joints[0][Quantity::kOutputPosition].push_back(angle_rad(r, t));
        run.joints[0][Quantity::kMotorCurrent].push_back(current_A(r, t));
        const double seen = t - late_s;
        const double torque = kRatio * kTorqueConstant_Nm_A * current_A(r, seen);
        run.joints[0][Quantity::kOutputTorque].push_back(
            torque + noise(random) +
            added({seen, angle_rad(r, seen), speed_rad_s(r, seen), current_A(r, seen), torque}));
      }
      run.masked.assign(run.time_s.size(), 0);
      made.runs.push_back(std::move(run));
    }
    return made;
  }

  Bench bench(const Log& log) const { return make_bench(rig, log, 0, {&actuator}); }

  Rig rig;
  actuator::Actuator actuator;

 private:
  static double sum(std::size_t run, double t, bool derivative) {
    double value = 0.0;
    const auto shift = static_cast<double>(run);
    const std::array<std::array<double, 3>, 3> terms = {
        {{4.0, 0.8, 0.7}, {0.6, 2.9, 1.9}, {0.15, 7.3, 2.6}}};
    for (const auto& [amplitude, rate, phase] : terms) {
      value += derivative ? amplitude * rate * std::cos(rate * t + phase * shift)
                          : amplitude * std::sin(rate * t + phase * shift);
    }
    return value;
  }
};

inline double sign(double value) { return value > 0.0 ? 1.0 : value < 0.0 ? -1.0 : 0.0; }

}  // namespace torquewright::identification::made
