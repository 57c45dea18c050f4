// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/mujoco_bench/bench.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/oracles/mujoco_bench/laws.hpp"
#include "tests/oracles/mujoco_bench/plant.hpp"

namespace torquewright::oracles::mujoco_bench {
namespace {

constexpr double kTurn_rad = 2 * std::numbers::pi;
/// What is played rises from nothing in this time.
constexpr double kFade_s = 0.3;
/// Of the bench where it imposes a speed: proportional, and integral a quarter of it.
constexpr double kServo_hz = 60;

/// Beyond the least step that a gear's flanks or a spring allow.
int steps_per_record(const Laws& laws) {
  return laws.gap_rad > 0 ? 20 : laws.is_elastic() ? 10 : 5;
}

/// Everything that changes within one run.
class Player {
 public:
  Player(const Bench& bench, std::size_t index)
      : bench_(bench),
        recipe_(bench.recipes[index]),
        per_record_(steps_per_record(bench.world.laws)),
        plant_(bench.world, bench.inertia_kg_m2, payload(index), kRecord_s / per_record_),
        temperature_K_(recipe_.start_temperature_K) {
    record_.name = recipe_.name;
    record_.index = index;
    if (recipe_.begins_moving) plant_.set_speed(recipe_.motion(0));
  }

  Record play() {
    const auto count = std::lround(recipe_.duration_s / kRecord_s) * per_record_;
    for (long k = 0; k < count; ++k) {
      time_s_ = static_cast<double>(k) * plant_.step_s();
      advance(k % per_record_ == 0);
    }
    return record_;
  }

 private:
  double payload(std::size_t index) const {
    const auto& shares = bench_.world.load.payload_share;
    return shares.empty() ? 0 : shares[index % shares.size()];
  }

  double played(const Profile& profile, double time_s) const {
    return profile(time_s) * (recipe_.begins_moving ? 1 : std::min(1.0, time_s / kFade_s));
  }

  bool bench_imposes() const { return recipe_.mode == Recipe::Mode::kImposed; }

  /// Speed that is asked for.
  double asked_speed() const {
    if (recipe_.mode != Recipe::Mode::kPlaced) return played(recipe_.motion, time_s_);
    return (played(recipe_.motion, time_s_ + 1e-3) - played(recipe_.motion, time_s_)) / 1e-3;
  }

  double asked_current(const Motion& now, double speed) {
    const double peak = bench_.world.motor.peak_current_A;
    if (bench_imposes()) return std::clamp(played(recipe_.effort, time_s_), -peak, peak);
    asked_rad_ += speed * plant_.step_s();
    const double rate = kTurn_rad * bench_.bandwidth_hz;
    const double torque =
        plant_.total_inertia_kg_m2() * (rate * rate * (asked_rad_ - now.rotor_position_rad) +
                                        1.6 * rate * (speed - now.rotor_speed_rad_s));
    double current = torque / bench_.world.motor.gain_Nm_A();
    if (recipe_.mode != Recipe::Mode::kHeld) current += played(recipe_.effort, time_s_);
    return std::clamp(current, -peak, peak);
  }

  double bench_torque(const Motion& now, double speed) {
    if (recipe_.mode == Recipe::Mode::kHeld) return played(recipe_.effort, time_s_);
    if (!bench_imposes()) return 0;
    const double rate = kTurn_rad * kServo_hz, late = speed - now.speed_rad_s;
    late_rad_ += late * plant_.step_s();
    const double ahead = (played(recipe_.motion, time_s_ + 1e-3) - speed) / 1e-3;
    return plant_.total_inertia_kg_m2() * (rate * late + rate * rate / 4 * late_rad_ + ahead);
  }

  /// The drive sets a duty; current follows from the winding at once.
  void set_current(double asked_A, double rotor_speed_rad_s) {
    const World& world = bench_.world;
    const double back_emf = world.motor.torque_constant_Nm_A * world.motor.ratio *
                            rotor_speed_rad_s * magnet_factor(world, temperature_K_);
    const double resistance = resistance_ohm(world, temperature_K_);
    const double supply = world.motor.bus_voltage_V;
    const double wanted =
        world.motor.resistance_ohm * asked_A +
        world.motor.torque_constant_Nm_A * world.motor.ratio * rotor_speed_rad_s +
        (bench_.voltage_driven ? 0 : std::copysign(world.laws.dead_time_V, asked_A));
    duty_ = std::clamp(wanted / supply, -1.0, 1.0);
    const double driving = duty_ * supply - back_emf;
    const double left = std::max(0.0, std::abs(driving) - world.laws.dead_time_V);
    current_A_ = std::copysign(left, driving) / (resistance + world.laws.sag_ohm * duty_ * duty_);
    bus_V_ = supply - world.laws.sag_ohm * duty_ * current_A_;
  }

  void warm() {
    if (!bench_.warms) return;
    const double rise = bench_.heating_K_s_A2 * current_A_ * current_A_;
    const double fall = (temperature_K_ - 298.15) / bench_.cooling_s;
    temperature_K_ += plant_.step_s() * (rise - fall);
  }

  /// Motor, cogging, and what the presliding contact takes.
  double motor_torque(const Motion& now) {
    const World& world = bench_.world;
    const double step = plant_.step_s();
    const double asked = motor_torque_Nm(world, current_A_, temperature_K_);
    const double share = world.laws.lag_s > 0 ? 1 - std::exp(-step / world.laws.lag_s) : 1;
    torque_Nm_ += share * (asked - torque_Nm_);
    if (world.laws.presliding_Nm > 0) {
      const double warmer = temperature_K_ - world.motor.reference_temperature_K;
      presliding_Nm_ = dahl_Nm(presliding_Nm_, now.rotor_speed_rad_s * step,
                               world.laws.presliding_Nm * (1 + world.laws.grease_1_K * warmer),
                               world.laws.presliding_stiffness_Nm_rad);
    }
    return torque_Nm_ + sum_of(world.laws.cogging, world.motor.ratio * now.rotor_position_rad) -
           presliding_Nm_;
  }

  void advance(bool keeps) {
    const Motion before = plant_.motion();
    const double speed = asked_speed();
    set_current(asked_current(before, speed), before.rotor_speed_rad_s);
    warm();
    const Motion now = plant_.step({.motor_torque_Nm = motor_torque(before),
                                    .bench_torque_Nm = bench_torque(before, speed),
                                    .current_A = current_A_,
                                    .temperature_K = temperature_K_,
                                    .time_s = time_s_});
    if (keeps) keep(now);
  }

  void keep(const Motion& now) {
    record_.time_s.push_back(time_s_);
    record_.position_rad.push_back(now.position_rad);
    record_.speed_rad_s.push_back(now.speed_rad_s);
    record_.acceleration_rad_s2.push_back(now.acceleration_rad_s2);
    record_.rotor_rad.push_back(now.rotor_position_rad * bench_.world.motor.ratio);
    record_.current_A.push_back(current_A_);
    record_.torque_Nm.push_back(now.load_torque_Nm);
    record_.temperature_K.push_back(temperature_K_);
    record_.duty.push_back(duty_);
    record_.bus_V.push_back(bus_V_);
  }

  const Bench& bench_;
  const Recipe& recipe_;
  int per_record_;
  Plant plant_;
  Record record_;
  double temperature_K_, time_s_ = 0, asked_rad_ = 0, late_rad_ = 0;
  double current_A_ = 0, torque_Nm_ = 0, presliding_Nm_ = 0, duty_ = 0, bus_V_ = 0;
};

}  // namespace

std::vector<Record> play(const Bench& bench) {
  std::vector<Record> records;
  for (std::size_t k = 0; k < bench.recipes.size(); ++k) records.push_back(Player(bench, k).play());
  return records;
}

}  // namespace torquewright::oracles::mujoco_bench
