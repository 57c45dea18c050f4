// SPDX-License-Identifier: Apache-2.0
#include "identification/forward/backlash_residual.hpp"

#include <algorithm>
#include <cmath>

#include "actuator/region/gear_losses.hpp"
#include "actuator/region/torque_at.hpp"
#include "dynamics/gravity.hpp"
#include "identification/forward/free_play.hpp"
#include "identification/rig/load_inertia.hpp"

namespace torquewright::identification {
namespace {

/// The value between a sample and the next.
double between(const std::vector<double>& values, std::size_t sample, double share) {
  const double next = values[std::min(sample + 1, values.size() - 1)];
  return values[sample] + share * (next - values[sample]);
}

/// The motor in the gap of an output whose motion is known. Its friction follows its own speed.
class FreeMotor : public FreeSide {
 public:
  FreeMotor(const actuator::Actuator& actuator, const Signals& signals)
      : actuator_(actuator),
        signals_(signals),
        inertia_kg_m2_(actuator::reflected_inertia_kg_m2(actuator)) {
    for (const actuator::Instant& at : signals.at) {
      rigid_drag_Nm_.push_back(actuator::drag_Nm(actuator, at));
      undamped_Nm_.push_back(actuator::before_mesh_at_Nm(actuator, at) - rigid_drag_Nm_.back());
      speed_rad_s_.push_back(at.speed_rad_s);
    }
  }

  std::size_t samples() const override { return signals_.size(); }

  double push_Nm(std::size_t sample, double share, double speed_rad_s) const override {
    const double drag_Nm =
        speed_rad_s == 0.0
            ? between(rigid_drag_Nm_, sample, share)
            : own_drag_Nm(sample, between(speed_rad_s_, sample, share) + speed_rad_s);
    return between(undamped_Nm_, sample, share) + drag_Nm;
  }

 private:
  /// Near rest in proportion to the speed, so that what sticks does not chatter.
  double own_drag_Nm(std::size_t sample, double motor_rad_s) const {
    actuator::Instant at = signals_.at[sample];
    at.speed_rad_s = motor_rad_s;
    at.direction = std::copysign(1.0, motor_rad_s);
    const double drag_Nm = actuator::drag_Nm(actuator_, at);
    const double stopped_in_a_step = std::abs(motor_rad_s) * inertia_kg_m2_ / kFreePlayStep_s;
    return std::copysign(std::min(std::abs(drag_Nm), stopped_in_a_step), drag_Nm);
  }

  const actuator::Actuator& actuator_;
  const Signals& signals_;
  double inertia_kg_m2_;
  std::vector<double> undamped_Nm_, rigid_drag_Nm_, speed_rad_s_;
};

/// Motor and load, both free in the gap: their motion against each other is that of the reduced
/// inertia under the torque that would pass between them. Never the measured acceleration, which
/// would have to be known at the very instants at which it jumps.
class FreePair : public FreeSide {
 public:
  FreePair(const Bench& bench, const Signals& signals)
      : motor_kg_m2_(actuator::reflected_inertia_kg_m2(bench.actuator())),
        load_kg_m2_(load_inertia_kg_m2(load_of(*bench.rig, signals.run_name))) {
    const actuator::Actuator& actuator = bench.actuator_in_gap();
    for (std::size_t i = 0; i < signals.size(); ++i) {
      const actuator::Instant& at = signals.at[i];
      const double gravity_Nm = signals.load_side_Nm[i] - load_kg_m2_ * at.acceleration_rad_s2;
      const double drag_Nm = actuator::drag_Nm(actuator, at);
      const double driven_Nm = actuator::before_mesh_at_Nm(actuator, at) - drag_Nm +
                               motor_kg_m2_ * at.acceleration_rad_s2;
      double together_Nm = drag_Nm, apart_Nm = drag_Nm;
      if (std::abs(at.direction) < 1.0) {
        // At rest friction is what holds, up to its level.
        const double level_Nm = rest_level_Nm(actuator, at);
        together_Nm = std::clamp(gravity_Nm - driven_Nm, -level_Nm, level_Nm);
        apart_Nm = std::clamp(-driven_Nm, -level_Nm, level_Nm);
      }
      touching_Nm_.push_back(passes_Nm(driven_Nm + together_Nm, gravity_Nm));
      free_Nm_.push_back(passes_Nm(driven_Nm + apart_Nm, gravity_Nm));
    }
  }

  double load_kg_m2() const { return load_kg_m2_; }
  double reduced_kg_m2() const { return motor_kg_m2_ * load_kg_m2_ / (motor_kg_m2_ + load_kg_m2_); }

  std::size_t samples() const override { return touching_Nm_.size(); }
  double push_Nm(std::size_t sample, double share, double speed_rad_s) const override {
    return between(speed_rad_s == 0.0 ? touching_Nm_ : free_Nm_, sample, share);
  }

 private:
  static double rest_level_Nm(const actuator::Actuator& actuator, actuator::Instant at) {
    at.speed_rad_s = 0.0;
    at.direction = 1.0;
    return std::abs(actuator::drag_Nm(actuator, at));
  }

  double passes_Nm(double motor_Nm, double gravity_Nm) const {
    return (load_kg_m2_ * motor_Nm + motor_kg_m2_ * gravity_Nm) / (motor_kg_m2_ + load_kg_m2_);
  }

  double motor_kg_m2_, load_kg_m2_;
  std::vector<double> touching_Nm_, free_Nm_;
};

/// What a load takes more where it hangs `place_rad` behind the measured motor.
double gravity_slope_Nm_rad(const Load& load, double angle_rad) {
  if (load.type != LoadType::kPendulum) return 0.0;
  return load.mass_kg * dynamics::kGravity_m_s2 * load.length_m * std::cos(angle_rad);
}

/// With the output's encoder.
std::vector<double> seen_from_output(const Balance& balance, double gap_rad,
                                     const Signals& signals) {
  const actuator::Actuator& actuator = balance.bench().actuator_in_gap();
  const double inertia_kg_m2 = actuator::reflected_inertia_kg_m2(actuator);
  const GapMotion motion =
      move_in_gap(FreeMotor(actuator, signals), inertia_kg_m2, gap_rad, signals.step_s);
  std::vector<double> residual(signals.size());
  for (std::size_t i = 0; i < residual.size(); ++i) {
    residual[i] = balance.gain(signals, i) *
                  (motion.push_change_Nm[i] - inertia_kg_m2 * motion.acceleration_rad_s2[i]);
  }
  return residual;
}

/// With the motor's: the rig's load is thought to move as the motor does.
std::vector<double> seen_from_motor(const Bench& bench, double gap_rad, const Signals& signals) {
  const FreePair pair(bench, signals);
  const GapMotion motion = move_in_gap(pair, pair.reduced_kg_m2(), gap_rad, signals.step_s);
  const Load& load = load_of(*bench.rig, signals.run_name);
  std::vector<double> residual(signals.size());
  for (std::size_t i = 0; i < residual.size(); ++i) {
    residual[i] = pair.load_kg_m2() * motion.acceleration_rad_s2[i] +
                  gravity_slope_Nm_rad(load, signals.at[i].output_angle_rad) * motion.place_rad[i];
  }
  return residual;
}

}  // namespace

bool shows_backlash(const Bench& bench) {
  if (!bench.has_torque_balance() || bench.encoders == Encoders::kBoth) return false;
  if (!(actuator::reflected_inertia_kg_m2(bench.actuator()) > 0.0)) return false;
  if (bench.encoders == Encoders::kOutput) return true;
  return bench.load_side == LoadSide::kModel && load_inertia_kg_m2(bench.rig->load) > 0.0;
}

std::vector<double> backlash_residual_Nm(const Balance& balance, double gap_rad,
                                         const Signals& signals) {
  return balance.bench().encoders == Encoders::kOutput
             ? seen_from_output(balance, gap_rad, signals)
             : seen_from_motor(balance.bench(), gap_rad, signals);
}

}  // namespace torquewright::identification
