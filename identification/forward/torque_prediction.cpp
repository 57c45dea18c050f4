// SPDX-License-Identifier: Apache-2.0
#include "identification/forward/torque_prediction.hpp"

#include <algorithm>
#include <cmath>

#include "actuator/region/gear_losses.hpp"
#include "actuator/region/torque_at.hpp"
#include "identification/forward/backlash_residual.hpp"
#include "identification/forward/drive_side.hpp"
#include "identification/forward/histories.hpp"
#include "identification/preparation/balance.hpp"
#include "identification/signals/load_model.hpp"
#include "identification/signals/signal.hpp"

namespace torquewright::identification {
namespace {

using actuator::Acts;
using actuator::Actuator;
using actuator::Effect;
using actuator::Instant;

constexpr double kMostGain = 20.0;  ///< Of a mesh that nearly locks.
/// Motions, motors and loads that are remembered: of a model and of the parameter that moves.
constexpr std::size_t kMostStates = 3;

double delay_of_motion_s(const Hypothesis& hypothesis) {
  double delay_s = 0.0;
  for (const Quantity each :
       {Quantity::kOutputPosition, Quantity::kOutputVelocity, Quantity::kLinearPosition,
        Quantity::kLinearVelocity, Quantity::kMotorPosition, Quantity::kMotorVelocity}) {
    delay_s += hypothesis.log.delay_s[static_cast<std::size_t>(each)];
  }
  return delay_s;
}

double delay_of_s(const Hypothesis& hypothesis, Quantity channel) {
  return hypothesis.log.delay_s[static_cast<std::size_t>(channel)];
}

bool is_same_load(const Rig& a, const Rig& b) { return a.load == b.load && a.loads == b.loads; }

/// Torque after over torque before the mesh, by whether the motor drives; the same at every load.
struct Mesh {
  double driving, driven;
  explicit Mesh(const Actuator& actuator)
      : driving(std::min(kMostGain, actuator::after_mesh_Nm(actuator, 1.0, 1.0))),
        driven(std::min(kMostGain, actuator::after_mesh_Nm(actuator, 1.0, -1.0))) {}
  double after(double before_Nm, double direction) const {
    return before_Nm * (before_Nm * direction > 0.0 ? driving : driven);
  }
  double before(double after_Nm, double direction) const {
    return after_Nm / (after_Nm * direction > 0.0 ? driving : driven);
  }
};

/// The mean over both directions by their shares of the instant's time.
template <typename InDirection>
double over_directions(double direction, const InDirection& in_direction) {
  const double forward = 0.5 * (1.0 + direction);
  double sum = 0.0;
  if (forward != 0.0) sum += forward * in_direction(1.0);
  if (forward != 1.0) sum += (1.0 - forward) * in_direction(-1.0);
  return sum;
}

/// What gravity adds on the output beyond the rig's model.
double imbalance_Nm(const Hypothesis& hypothesis, double angle_rad) {
  if (hypothesis.imbalance_sine_Nm == 0.0 && hypothesis.imbalance_cosine_Nm == 0.0) return 0.0;
  return hypothesis.imbalance_sine_Nm * std::sin(angle_rad) +
         hypothesis.imbalance_cosine_Nm * std::cos(angle_rad);
}

/// Removes what a gap between motor and output does, where one is supposed and can be felt.
void subtract_gap(const Bench& bench, const Hypothesis& hypothesis, const Signals& signals,
                  std::vector<double>& balance_Nm) {
  for (const Effect& effect : hypothesis.actuator.effects) {
    const bool is_gap = effect.kind->in_train == actuator::TrainPart::kGap;
    if (!is_gap || effect.values[0] <= 0.0 || !shows_backlash(bench)) continue;
    Bench with_gap = bench;
    with_gap.in_gap = std::make_shared<const Actuator>(hypothesis.actuator);
    const std::vector<double> gap_Nm =
        backlash_residual_Nm(Balance(with_gap), effect.values[0], signals);
    for (std::size_t i = 0; i < balance_Nm.size(); ++i) balance_Nm[i] -= gap_Nm[i];
  }
}

/// What changes the motor's torque: factors of its constant, and what a winding's current follows.
bool acts_on_motor(const Effect& effect) {
  switch (effect.kind->acts) {
    case Acts::kTorqueFactor:
    case Acts::kFluxFactor:
    case Acts::kResistanceFactor:
    case Acts::kWindingVoltage:
    case Acts::kBusVoltage:
      return true;
    default:
      return false;
  }
}

void add(const LawSeries& series, LawSeries& sum) {
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += series[i];
}

std::vector<const Effect*> effects_acting(const Actuator& actuator, Acts acts) {
  std::vector<const Effect*> effects;
  for (const Effect& each : actuator.effects) {
    if (each.kind->acts == acts) effects.push_back(&each);
  }
  return effects;
}

LawSeries sum_of_plain(const Actuator& actuator, Acts acts, MovedStretch& moved) {
  LawSeries sum(moved.at().size(), 0.0);
  for (const Effect* each : effects_acting(actuator, acts)) add(*moved.plain(*each), sum);
  return sum;
}

/// Multiplies by the factor of every effect on all drag.
void times_drag_factor(const Actuator& actuator, MovedStretch& moved, LawSeries& drag) {
  const std::vector<const Effect*> effects = effects_acting(actuator, Acts::kDragFactor);
  if (effects.empty()) return;
  LawSeries factor(drag.size(), 1.0);
  for (const Effect* each : effects) {
    const auto series = moved.plain(*each);
    for (std::size_t i = 0; i < factor.size(); ++i) factor[i] *= (*series)[i];
  }
  for (std::size_t i = 0; i < factor.size(); ++i) drag[i] *= std::max(0.0, factor[i]);
}

/// Friction that does not depend on load, in both directions.
DirectedSeries drag_of(const Actuator& actuator, MovedStretch& moved) {
  const std::size_t n = moved.at().size();
  DirectedSeries drag{LawSeries(n, 0.0), LawSeries(n, 0.0)};
  for (const Effect* each : effects_acting(actuator, Acts::kDrag)) {
    const auto series = moved.drag(*each);
    add(series->forward, drag.forward);
    add(series->backward, drag.backward);
  }
  times_drag_factor(actuator, moved, drag.forward);
  times_drag_factor(actuator, moved, drag.backward);
  return drag;
}

}  // namespace

/// What of the torque at the output repeats with its angle, in proportion to the load or not.
class TorqueBalance::Ripples {
 public:
  Ripples(const Actuator& actuator, MovedStretch& moved) {
    for (const Effect* each : effects_acting(actuator, Acts::kOutputTorque)) {
      parts_.push_back({moved.ripple(*each), each->proportional});
    }
  }
  double at_Nm(std::size_t i, double load_Nm) const {
    double sum = 0.0;
    for (const Part& each : parts_) {
      sum += each.is_proportional ? each.series->loaded[i] * load_Nm : each.series->alone[i];
    }
    return sum;
  }
  bool empty() const { return parts_.empty(); }
  double alone_Nm(std::size_t i) const {
    double sum = 0.0;
    for (const Part& each : parts_) sum += each.series->alone[i];
    return sum;
  }
  /// Under a load of 1 Nm.
  double loaded_Nm(std::size_t i) const {
    double sum = 0.0;
    for (const Part& each : parts_) sum += each.series->loaded[i];
    return sum;
  }

 private:
  struct Part {
    std::shared_ptr<const RippleSeries> series;
    bool is_proportional;
  };
  std::vector<Part> parts_;
};

/// What a hypothesis makes of the stretch, term by term.
struct TorqueBalance::Terms {
  std::shared_ptr<const MovedStretch> moved;
  std::shared_ptr<const DriveTorque> drive;
  std::shared_ptr<const LawSeries> load_Nm;
  LawSeries smooth_Nm;  ///< Before drag and mesh.
  DirectedSeries drag_Nm;
  Ripples ripples;
};

TorqueBalance::TorqueBalance(const Bench& bench, const Signals& signals, std::size_t most)
    : bench_(bench),
      signals_(signals),
      most_(most),
      moved_(std::min(most, kMostStates)),
      drives_(std::min(most, kMostStates)),
      loads_(std::min(most, kMostStates)),
      lags_(std::min(most, kMostStates)) {}

TorqueBalance::DriveTorque TorqueBalance::drive_torque(const Hypothesis& hypothesis,
                                                       const MovedStretch& moved,
                                                       double drive_late_s) const {
  const std::size_t n = signals_.size();
  std::vector<double> channel(n);
  for (std::size_t i = 0; i < n; ++i) {
    channel[i] = bench_.drive == Drive::kVoltage ? signals_.voltage_V[i] : signals_.at[i].current_A;
  }
  if (drive_late_s != 0.0) channel = advanced(channel, drive_late_s, signals_.step_s);
  const DriveSide side(bench_, hypothesis, signals_, channel, moved.at(), drive_late_s);
  DriveTorque torque;
  for (std::size_t i = 0; i < n; ++i) {
    Instant at = moved.at()[i];
    torque.motor_Nm.push_back(side.motor_Nm(i, at));
    if (bench_.load_side != LoadSide::kSensor)
      torque.stated_over_own_slope.push_back(side.stated_over_own_slope(i, at));
  }
  return torque;
}

LawSeries TorqueBalance::load_torque(const Hypothesis& hypothesis, double late_s,
                                     bool is_as_stated) const {
  LawSeries load_Nm =
      is_as_stated ? signals_.load_side_Nm : model_load_Nm(hypothesis.rig, bench_.joint, signals_);
  return late_s != 0.0 ? advanced(load_Nm, late_s, signals_.step_s) : load_Nm;
}

double TorqueBalance::load_late_s(const Hypothesis& hypothesis, double moved_s) const {
  if (bench_.load_side == LoadSide::kModel) return moved_s;
  return bench_.load_side == LoadSide::kSensor ? delay_of_s(hypothesis, bench_.load_channel) : 0.0;
}

LawSeries TorqueBalance::histories(const Actuator& actuator, MovedStretch& moved,
                                   const std::shared_ptr<const DriveTorque>& drive) {
  LawSeries sum(signals_.size(), 0.0);
  for (const Effect& effect : actuator.effects) {
    if (!has_history(effect)) continue;
    if (effect.kind->follows_torque) {
      const auto lag = [&] {
        return lag_history_Nm(effect, moved.at(), drive->motor_Nm, signals_.step_s);
      };
      add(*lags_.of({effect, drive}, lag), sum);
      continue;
    }
    LawSeries friction = *moved.friction_history(effect);
    times_drag_factor(actuator, moved, friction);
    add(friction, sum);
  }
  return sum;
}

TorqueBalance::Terms TorqueBalance::terms(const Hypothesis& hypothesis) {
  const Actuator& actuator = hypothesis.actuator;
  const double moved_s = delay_of_motion_s(hypothesis);
  const double drive_late_s =
      delay_of_s(hypothesis, bench_.drive_channel) + hypothesis.log.instant_s;
  const double ratio = actuator.transmission.ratio;
  const std::shared_ptr<MovedStretch> moved =
      moved_.of({moved_s, ratio}, [&] { return MovedStretch(signals_, moved_s, ratio, most_); });
  DriveKey key{moved_s,
               drive_late_s,
               hypothesis.winding_late_s,
               hypothesis.log.current_offset_A,
               hypothesis.log.positive_current_gain,
               hypothesis.log.negative_current_gain,
               actuator.motor,
               actuator.drive,
               actuator.transmission,
               {}};
  std::copy_if(actuator.effects.begin(), actuator.effects.end(), std::back_inserter(key.effects),
               acts_on_motor);
  const auto drive =
      drives_.of(key, [&] { return drive_torque(hypothesis, *moved, drive_late_s); });
  const bool is_as_stated =
      bench_.load_side == LoadSide::kSensor || is_same_load(hypothesis.rig, *bench_.rig);
  LoadKey load_key{load_late_s(hypothesis, moved_s), {}, {}};
  if (!is_as_stated) {
    load_key.load = {hypothesis.rig.load};
    load_key.loads = hypothesis.rig.loads;
  }
  const auto load =
      loads_.of(load_key, [&] { return load_torque(hypothesis, load_key.late_s, is_as_stated); });
  Terms terms{moved,
              drive,
              load,
              sum_of_plain(actuator, Acts::kMotorSideTorque, *moved),
              drag_of(actuator, *moved),
              Ripples(actuator, *moved)};
  const LawSeries histories_Nm = histories(actuator, *moved, drive);
  const double inertia_kg_m2 = actuator::reflected_inertia_kg_m2(actuator);
  const LawSeries& acceleration_rad_s2 = moved->rotor_rad_s2();
  for (std::size_t i = 0; i < terms.smooth_Nm.size(); ++i) {
    terms.smooth_Nm[i] = drive->motor_Nm[i] + histories_Nm[i] + terms.smooth_Nm[i] -
                         inertia_kg_m2 * acceleration_rad_s2[i];
  }
  return terms;
}

std::vector<double> TorqueBalance::residual_Nm(const Hypothesis& hypothesis) {
  const Terms of = terms(hypothesis);
  const Mesh mesh(hypothesis.actuator);
  const bool is_sensor = bench_.load_side == LoadSide::kSensor;
  const double offset_Nm = hypothesis.log.torque_offset_Nm;
  std::vector<double> balance_Nm(signals_.size());
  for (std::size_t i = 0; i < balance_Nm.size(); ++i) {
    const Instant& at = of.moved->at()[i];
    const double imbalance = imbalance_Nm(hypothesis, at.output_angle_rad);
    const auto drag_Nm = [&](double direction) {
      return direction > 0.0 ? of.drag_Nm.forward[i] : of.drag_Nm.backward[i];
    };
    if (is_sensor) {
      const double predicted_Nm = over_directions(at.direction, [&](double direction) {
        const double after_Nm = mesh.after(of.smooth_Nm[i] + drag_Nm(direction), direction);
        return after_Nm + of.ripples.at_Nm(i, after_Nm);
      });
      balance_Nm[i] = (*of.load_Nm)[i] - offset_Nm - imbalance - predicted_Nm;
      continue;
    }
    const double alone_Nm = of.ripples.alone_Nm(i);
    const double load_Nm = ((*of.load_Nm)[i] - imbalance - alone_Nm - offset_Nm) /
                           (1.0 + (of.ripples.loaded_Nm(i) - alone_Nm));
    const double needed_Nm = over_directions(at.direction, [&](double direction) {
      return mesh.before(load_Nm, direction) - drag_Nm(direction);
    });
    balance_Nm[i] = (needed_Nm - of.smooth_Nm[i]) * of.drive->stated_over_own_slope[i];
  }
  subtract_gap(bench_, hypothesis, signals_, balance_Nm);
  return balance_Nm;
}

std::vector<double> torque_balance_Nm(const Bench& bench, const Hypothesis& hypothesis,
                                      const Signals& signals) {
  return TorqueBalance(bench, signals, 1).residual_Nm(hypothesis);
}

}  // namespace torquewright::identification
