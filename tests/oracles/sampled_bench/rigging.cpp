// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/sampled_bench/rigging.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::oracles::sampled {
namespace {

constexpr double kMostRows = 180000.0;

int draw_sample_steps(const std::vector<RunPlan>& runs, Draw& draw) {
  static const std::vector<int> kRates_hz{100, 200, 250, 500, 500, 1000, 1000, 2000, 4000, 10000};
  double total_s = 0.0;
  for (const RunPlan& run : runs) total_s += run.duration_s;
  int rate_hz = draw.one_of(kRates_hz);
  while (rate_hz * total_s > kMostRows) rate_hz = rate_hz > 1000 ? 1000 : rate_hz / 2;
  return static_cast<int>(std::lround(1.0 / (kStep_s * rate_hz)));
}

void choose_channels(const Plant& plant, const Needs& needs, SamplingChain& chain, Draw& draw) {
  const auto log = [&](Channel channel) { chain.sensors[channel].is_logged = true; };
  const bool linear = plant.load.kind == LoadKind::kLinearAxis;
  const int encoders = linear ? 0 : draw.between(0, 2);
  if (needs.both_encoders || encoders != 1) log(kOutputPosition);
  if (needs.both_encoders || encoders != 0) log(kMotorPosition);
  if (needs.velocity || draw.chance(0.5)) {
    log(chain.sensors[kOutputPosition].is_logged ? kOutputVelocity : kMotorVelocity);
  }
  if (plant.drive == DriveKind::kCurrent) log(kCurrent);
  if (plant.drive == DriveKind::kCommandedTorque) log(kCommandedTorque);
  if (plant.drive == DriveKind::kDuty || needs.bus) log(kDuty);
  if (plant.drive == DriveKind::kDuty || needs.bus || draw.chance(0.2)) log(kBusVoltage);
  if (plant.drive == DriveKind::kWindingVoltage) log(kWindingVoltage);
  if (plant.load.is_dynamometer()) log(kTorque);
  if (!linear && plant.load.kind != LoadKind::kImposedSpeed && draw.chance(0.3)) {
    log(kCommandedPosition);
  }
  if (needs.temperature) log(kWindingTemperature);
  if (needs.temperature && draw.chance(0.3)) log(kCaseTemperature);
}

/// Counts per turn, a power of two, such that the noise of an angle's second derivative in the band
/// stays at a third of the torque's; a bit or two more than needed at times.
double encoder_step_rad(double inertia, double torque_noise_Nm, double sample_hz, Draw& draw) {
  const double per_rad =
      inertia * std::pow(kTwoPi * kBand_hz, 2.0) * std::sqrt(2.0 * kBand_hz / sample_hz / 60.0);
  const double most_rad = 0.33 * torque_noise_Nm / per_rad;
  const double bits = std::clamp(std::ceil(std::log2(kTwoPi / most_rad)), 11.0, 25.0);
  return kTwoPi / std::exp2(std::min(26.0, bits + draw.between(0, 2)));
}

void set(Sensor& sensor, double noise, double resolution) {
  sensor.noise = noise;
  sensor.resolution = resolution;
}

/// A converter's step under a noise: so fine that the noise dithers it.
double converter_step(double noise, Draw& draw) { return noise * draw.uniform(0.3, 1.5); }

void set_mechanics(const Plant& plant, double noise_Nm, double sample_hz, SamplingChain& chain,
                   Draw& draw) {
  const double output_rad = encoder_step_rad(plant.moved_kg_m2(), noise_Nm, sample_hz, draw);
  const double motor_rad = plant.ratio * output_rad;  // no finer at the output than it needs be
  set(chain.sensors[kOutputPosition], 0.4 * output_rad, output_rad);
  set(chain.sensors[kMotorPosition], 0.4 * motor_rad, motor_rad);
  const double speed_noise = 0.003 * plant.used_speed_rad_s * draw.log_uniform(0.2, 2.0);
  set(chain.sensors[kOutputVelocity], speed_noise, converter_step(speed_noise, draw));
  set(chain.sensors[kMotorVelocity], plant.ratio * speed_noise,
      plant.ratio * converter_step(speed_noise, draw));
}

void set_electrics(const Plant& plant, double noise_Nm, double per_sample, SamplingChain& chain,
                   Draw& draw) {
  const double share = plant.load.is_dynamometer() ? draw.uniform(0.1, 0.7) : 1.0;
  const double current = share * noise_Nm * per_sample / plant.Nm_per_A();
  const double torque = std::sqrt(1.0 - share * share) * noise_Nm * per_sample;
  set(chain.sensors[kCurrent], current, converter_step(current, draw));
  if (plant.load.is_dynamometer())
    set(chain.sensors[kTorque], torque, converter_step(torque, draw));
  const double volts = share * noise_Nm * per_sample * plant.resistance_ohm / plant.Nm_per_A();
  set(chain.sensors[kWindingVoltage], volts, converter_step(volts, draw));
  set(chain.sensors[kBusVoltage], volts, converter_step(volts, draw));
  set(chain.sensors[kDuty], 0.0, 1.0 / 8192.0);
  set(chain.sensors[kWindingTemperature], 0.05, 0.0625);
  set(chain.sensors[kCaseTemperature], 0.05, 0.0625);
}

}  // namespace

SamplingChain draw_chain(const Plant& plant, const std::vector<RunPlan>& runs, const Needs& needs,
                         Draw& draw) {
  SamplingChain chain;
  choose_channels(plant, needs, chain, draw);
  chain.sample_steps = draw_sample_steps(runs, draw);
  const double sample_hz = 1.0 / (chain.sample_steps * kStep_s);
  const double share =
      needs.is_quiet ? draw.log_uniform(5e-4, 1.5e-3) : draw.log_uniform(1e-3, 1e-2);
  const double noise_Nm = 0.5 * share * plant.used_torque_Nm;
  // In the band lies 2 band / rate of a white noise's power.
  const double per_sample = std::sqrt(sample_hz / (2.0 * kBand_hz));
  set_electrics(plant, noise_Nm, per_sample, chain, draw);
  set_mechanics(plant, noise_Nm, sample_hz, chain, draw);
  // What a filter or a stamp delays must stay below the noise at changes of some 2 Hz.
  const double delay_s = 0.3 * share / (kTwoPi * 2.0);
  const double filter_hz = draw.uniform(1.0, 3.0) / (kTwoPi * delay_s);
  chain.filter_hz = filter_hz < 2500.0 ? filter_hz : 0.0;
  if (draw.chance(0.4)) {
    chain.stamp_jitter_s = std::min(delay_s, 0.05 * chain.sample_steps * kStep_s);
  }
  if (draw.chance(0.4)) chain.missing_share = draw.uniform(0.0, 0.002);
  chain.clock_error = draw.chance(0.5) ? 5e-5 : 0.0;
  return chain;
}

}  // namespace torquewright::oracles::sampled
