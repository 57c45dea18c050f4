// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/sampled_bench/bench.hpp"

#include <algorithm>
#include <cmath>

#include "tests/oracles/sampled_bench/control.hpp"
#include "tests/oracles/sampled_bench/drive_train.hpp"

namespace torquewright::oracles::sampled {
namespace {

bool is_analogue(std::size_t channel) {
  return channel == kCurrent || channel == kBusVoltage || channel == kTorque ||
         channel == kWindingTemperature || channel == kCaseTemperature;
}

/// The analogue half of the chain, at the integrator's step: faults, delay, filter.
class FrontEnd {
 public:
  explicit FrontEnd(const SamplingChain& chain) : chain_(chain) {
    for (std::size_t c = 0; c < kChannels; ++c) {
      late_steps_[c] = static_cast<std::size_t>(std::llround(chain.sensors[c].delay_s / kStep_s));
    }
    has_memory_ =
        chain.filter_hz > 0.0 || *std::max_element(late_steps_.begin(), late_steps_.end()) > 0;
    follow_ = chain.filter_hz > 0.0 ? -std::expm1(-kTwoPi * chain.filter_hz * kStep_s) : 1.0;
  }

  void feed(const Row& ideal, double time_s) {
    Row seen = ideal;
    distort(seen, time_s);
    for (std::size_t c = 0; c < kChannels; ++c) {
      if (late_steps_[c] > 0) seen[c] = late(c, seen[c]);
      const double follow = is_first_ || !is_analogue(c) ? 1.0 : follow_;
      now_[c] += (seen[c] - now_[c]) * follow;
    }
    is_first_ = false;
  }
  const Row& now() const { return now_; }
  /// Whether it must see every step of the integrator.
  bool has_memory() const { return has_memory_; }

 private:
  void distort(Row& seen, double time_s) const {
    const SensorOddities& odd = chain_.odd;
    const double angle = seen[kOutputPosition];
    seen[kOutputPosition] += odd.eccentricity_rad * std::sin(angle + odd.eccentricity_phase_rad) +
                             odd.interpolation_rad * std::sin(odd.interpolation_lines * angle);
    double& current = seen[kCurrent];
    if (current < 0.0) current *= odd.negative_gain;
    if (odd.dead_band_A > 0.0) {
      current = std::copysign(std::max(0.0, std::abs(current) - odd.dead_band_A), current);
    }
    seen[kTorque] += odd.torque_drift_1_s * time_s;
    if (odd.hum != 0.0) seen[odd.hum_channel] += odd.hum * std::sin(kTwoPi * odd.hum_hz * time_s);
    for (std::size_t c = 0; c < kChannels; ++c) {
      seen[c] = chain_.sensors[c].scale * seen[c] + chain_.sensors[c].offset;
    }
  }
  double late(std::size_t channel, double value) {
    std::vector<double>& line = lines_[channel];
    if (line.empty()) line.assign(late_steps_[channel], value);
    std::size_t& head = heads_[channel];
    const double oldest = line[head];
    line[head] = value;
    head = (head + 1) % line.size();
    return oldest;
  }

  const SamplingChain& chain_;
  std::array<std::size_t, kChannels> late_steps_{}, heads_{};
  std::array<std::vector<double>, kChannels> lines_;
  double follow_ = 1.0;
  bool has_memory_ = false;
  bool is_first_ = true;
  Row now_{};
};

Row converted(const Row& seen, const SamplingChain& chain, Draw& draw) {
  Row out = seen;
  for (std::size_t c = 0; c < kChannels; ++c) {
    const Sensor& sensor = chain.sensors[c];
    if (!sensor.is_logged) continue;
    out[c] += sensor.noise * draw.normal();
    if (sensor.resolution > 0.0) {
      out[c] = sensor.resolution * std::round(out[c] / sensor.resolution);
    }
  }
  return out;
}

/// Torque and acceleration hold for a step: at an instant between two steps it is their mean.
Instant between_steps(Instant at, const Instant& after) {
  at.torque_Nm = 0.5 * (at.torque_Nm + after.torque_Nm);
  at.acceleration_rad_s2 = 0.5 * (at.acceleration_rad_s2 + after.acceleration_rad_s2);
  at.motor_acceleration_rad_s2 =
      0.5 * (at.motor_acceleration_rad_s2 + after.motor_acceleration_rad_s2);
  at.brake_Nm = 0.5 * (at.brake_Nm + after.brake_Nm);
  return at;
}

Target target_at(const RunPlan& plan, double time_s, double travelled_rad) {
  Target target;
  target.run_time_s = time_s;
  if (plan.is_position) {
    constexpr double kDelta_s = 1e-3;
    target.angle_rad = plan.reference.at(time_s);
    target.speed_rad_s = plan.reference.rate(time_s);
    target.acceleration_rad_s2 =
        (plan.reference.rate(time_s + kDelta_s) - plan.reference.rate(time_s - kDelta_s)) /
        (2.0 * kDelta_s);
  } else {
    target.angle_rad = travelled_rad;
    target.speed_rad_s = plan.reference.at(time_s);
    target.acceleration_rad_s2 = plan.reference.rate(time_s);
  }
  return target;
}

/// Samples are taken in the middle of a control period, as drives do: a held command then has no
/// delay.
constexpr int kMidHold = kControlSteps / 2;
constexpr double kControl_s = kControlSteps * kStep_s;

double stamp_of(double time_s, double clock, double jitter_s, double period_s, Draw& draw) {
  const double jitter = std::clamp(jitter_s * draw.normal(), -0.3 * period_s, 0.3 * period_s);
  return time_s * clock + jitter;
}

}  // namespace

Row ideal_row(const Plant& plant, const Instant& at) {
  Row row{};
  row[kOutputPosition] = at.angle_rad;
  row[kOutputVelocity] = at.speed_rad_s;
  row[kMotorPosition] = plant.ratio * at.motor_angle_rad;
  row[kMotorVelocity] = plant.ratio * at.motor_speed_rad_s;
  row[kCurrent] = at.current_A;
  row[kDuty] = at.winding_V / at.bus_V;
  row[kWindingVoltage] = at.winding_V;
  row[kBusVoltage] = at.bus_V;
  row[kTorque] = at.torque_Nm;
  row[kCommandedTorque] = plant.Nm_per_A() * at.commanded_A;
  row[kCommandedPosition] = at.reference_rad;
  row[kWindingTemperature] = at.winding_K;
  row[kCaseTemperature] = at.case_K;
  return row;
}

RunLog run_bench(const Plant& plant, const Laws& laws, const SamplingChain& chain,
                 const RunPlan& plan, double begins_s, Draw& draw) {
  Laws here = laws;
  here.load_mass_factor *= plan.mass_factor;
  // A drive that is told a torque and logs it has a current loop that is no lag of its own.
  const double current_loop_s = plant.drive == DriveKind::kCommandedTorque ? 2e-5 : 4e-4;
  DriveTrain train(plant, here, kStep_s, current_loop_s);
  const bool imposed = plant.load.kind == LoadKind::kImposedSpeed;
  const Target first = target_at(plan, 0.0, 0.0);
  train.start(begins_s, first.angle_rad, imposed ? first.speed_rad_s : 0.0, plan.start_winding_K);
  FrontEnd front(chain);
  RunLog log;
  const double clock = 1.0 + chain.clock_error * draw.uniform(-1.0, 1.0);
  const double period_s = chain.sample_steps * kStep_s;
  double travelled_rad = first.angle_rad;
  double command = 0.0;
  double brake_Nm = 0.0;
  Target target = first;
  const auto steps = static_cast<int>(plan.duration_s / kStep_s);
  for (int step = 0; step <= steps; ++step) {
    const double time_s = step * kStep_s;
    const Instant now = train.now();
    if (step % kControlSteps == 0) {
      target = target_at(plan, time_s, travelled_rad);
      command = command_of(plant, plan, now, target);
      if (plant.load.kind == LoadKind::kBrake) brake_Nm = plan.other.at(time_s);
      if (!plan.is_position)
        travelled_rad += kControl_s * plan.reference.at(time_s + 0.5 * kControl_s);
    }
    train.advance({command, brake_Nm, imposed ? plan.reference.at(time_s + kStep_s) : 0.0});
    const bool is_sampled = step >= kMidHold && (step - kMidHold) % chain.sample_steps == 0;
    if (!is_sampled && !front.has_memory()) continue;
    Instant at = between_steps(now, train.now());
    at.commanded_A = plant.is_voltage_driven() ? 0.0 : command;
    at.reference_rad = target.angle_rad;
    const Row ideal = ideal_row(plant, at);
    front.feed(ideal, at.time_s);
    if (!is_sampled) continue;
    log.truth.push_back(at);
    log.ideal.push_back(ideal);
    log.measured.push_back(converted(front.now(), chain, draw));
    log.stamp_s.push_back(stamp_of(time_s, clock, chain.stamp_jitter_s, period_s, draw));
  }
  return log;
}

}  // namespace torquewright::oracles::sampled
