// SPDX-License-Identifier: Apache-2.0
#include "identification/forward/torque_prediction.hpp"

#include <algorithm>
#include <cmath>

#include "actuator/region/gear_losses.hpp"
#include "actuator/region/torque_at.hpp"
#include "identification/forward/backlash_residual.hpp"
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
/// Motions, motors and loads that are remembered: of a model and of the parameter that moves. Each
/// is as large as many series.
std::size_t states(std::size_t most) { return std::min<std::size_t>(most / 2, 3); }

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
  double forward_factor(double torque_Nm) const { return torque_Nm > 0.0 ? driving : driven; }
  double backward_factor(double torque_Nm) const { return torque_Nm < 0.0 ? driving : driven; }
};

/// Subtracts what gravity adds on the output beyond the rig's model.
void subtract_imbalance(const Hypothesis& hypothesis, const MovedStretch& moved, LawSeries& load) {
  if (hypothesis.imbalance_sine_Nm == 0.0 && hypothesis.imbalance_cosine_Nm == 0.0) return;
  for (std::size_t i = 0; i < load.size(); ++i) {
    const double angle_rad = moved.at()[i].output_angle_rad;
    load[i] -= hypothesis.imbalance_sine_Nm * std::sin(angle_rad) +
               hypothesis.imbalance_cosine_Nm * std::cos(angle_rad);
  }
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

/// What of the torque at the output repeats with its angle, alone or in proportion to the load.
class Ripples {
 public:
  Ripples(const Actuator& actuator, MovedStretch& moved) {
    for (const Effect* each : effects_acting(actuator, Acts::kOutputTorque)) {
      parts_.push_back({moved.ripple(*each), each->proportional});
    }
  }
  bool empty() const { return parts_.empty(); }

  LawSeries under(const LawSeries& load_Nm) const {
    LawSeries sum(load_Nm.size(), 0.0);
    for (const Part& each : parts_) {
      for (std::size_t i = 0; i < sum.size(); ++i) {
        const double torque_Nm = (*each.series)[i];
        sum[i] += each.is_proportional ? torque_Nm * load_Nm[i] : torque_Nm;
      }
    }
    return sum;
  }

  /// The load that makes such a torque together with the ripple under it and an offset.
  void take_from(LawSeries& torque_Nm, double offset_Nm) const {
    if (parts_.empty()) {
      for (double& each : torque_Nm) each -= offset_Nm;
      return;
    }
    const std::size_t n = torque_Nm.size();
    const LawSeries alone_Nm = under(LawSeries(n, 0.0)), loaded_Nm = under(LawSeries(n, 1.0));
    for (std::size_t i = 0; i < n; ++i) {
      torque_Nm[i] =
          (torque_Nm[i] - alone_Nm[i] - offset_Nm) / (1.0 + (loaded_Nm[i] - alone_Nm[i]));
    }
  }

 private:
  struct Part {
    std::shared_ptr<const LawSeries> series;
    bool is_proportional;
  };
  std::vector<Part> parts_;
};

/// Through the mesh to the output, the mean over both directions by their shares of the time.
LawSeries torque_on_load(const Mesh& mesh, const LawSeries& forward_shares,
                         const LawSeries& smooth_Nm, const DirectedSeries& drag_Nm,
                         const Ripples& ripples) {
  const std::size_t n = smooth_Nm.size();
  DirectedSeries after_Nm{LawSeries(n), LawSeries(n)};
  for (std::size_t i = 0; i < n; ++i) {
    const double forward_Nm = smooth_Nm[i] + drag_Nm.forward[i];
    const double backward_Nm = smooth_Nm[i] + drag_Nm.backward[i];
    after_Nm.forward[i] = forward_Nm * mesh.forward_factor(forward_Nm);
    after_Nm.backward[i] = backward_Nm * mesh.backward_factor(backward_Nm);
  }
  if (!ripples.empty()) {
    add(ripples.under(after_Nm.forward), after_Nm.forward);
    add(ripples.under(after_Nm.backward), after_Nm.backward);
  }
  LawSeries mean_Nm(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double forward = forward_shares[i];
    mean_Nm[i] = forward * after_Nm.forward[i] + (1.0 - forward) * after_Nm.backward[i];
  }
  return mean_Nm;
}

/// What a load needs before the mesh and drag, in the same mean.
LawSeries torque_for_load(const Mesh& mesh, const LawSeries& forward_shares,
                          const LawSeries& load_Nm, const DirectedSeries& drag_Nm) {
  LawSeries mean_Nm(load_Nm.size());
  for (std::size_t i = 0; i < mean_Nm.size(); ++i) {
    const double forward = forward_shares[i];
    const double ahead_Nm = load_Nm[i] / mesh.forward_factor(load_Nm[i]) - drag_Nm.forward[i];
    const double back_Nm = load_Nm[i] / mesh.backward_factor(load_Nm[i]) - drag_Nm.backward[i];
    mean_Nm[i] = forward * ahead_Nm + (1.0 - forward) * back_Nm;
  }
  return mean_Nm;
}

}  // namespace

TorqueBalance::TorqueBalance(const Bench& bench, const Signals& signals, std::size_t most)
    : bench_(bench),
      signals_(signals),
      most_(most),
      motor_torques_(bench, signals, states(most)),
      moved_(states(most)),
      loads_(states(most)) {}

std::shared_ptr<const LawSeries> TorqueBalance::load_torque(const Hypothesis& hypothesis,
                                                            double moved_s) {
  const bool is_sensor = bench_.load_side == LoadSide::kSensor;
  const bool is_as_stated = is_sensor || is_same_load(hypothesis.rig, *bench_.rig);
  LoadKey key{is_sensor ? delay_of_s(hypothesis, bench_.load_channel) : moved_s, {}, {}};
  if (!is_as_stated) {
    key.load = {hypothesis.rig.load};
    key.loads = hypothesis.rig.loads;
  }
  return loads_.of(key, [&] {
    LawSeries load_Nm = is_as_stated ? signals_.load_side_Nm
                                     : model_load_Nm(hypothesis.rig, bench_.joint, signals_);
    return key.late_s != 0.0 ? advanced(load_Nm, key.late_s, signals_.step_s) : load_Nm;
  });
}

/// Motor, lag and histories, cogging, and what accelerates the rotor.
LawSeries TorqueBalance::before_drag(const Hypothesis& hypothesis, MovedStretch& moved,
                                     const std::shared_ptr<const MotorTorque>& motor) {
  const Actuator& actuator = hypothesis.actuator;
  LawSeries histories_Nm(signals_.size(), 0.0), periodic_Nm = histories_Nm;
  for (const Effect& effect : actuator.effects) {
    if (effect.kind->acts == Acts::kMotorSideTorque) add(*moved.plain(effect), periodic_Nm);
    if (!has_history(effect)) continue;
    if (effect.kind->follows_torque) {
      add(*motor_torques_.lag(effect, motor, moved), histories_Nm);
      continue;
    }
    LawSeries friction_Nm = *moved.friction_history(effect);
    times_drag_factor(actuator, moved, friction_Nm);
    add(friction_Nm, histories_Nm);
  }
  const double inertia_kg_m2 = actuator::reflected_inertia_kg_m2(actuator);
  LawSeries torque_Nm(signals_.size());
  for (std::size_t i = 0; i < torque_Nm.size(); ++i) {
    torque_Nm[i] = motor->motor_Nm[i] + histories_Nm[i] + periodic_Nm[i] -
                   inertia_kg_m2 * moved.rotor_rad_s2()[i];
  }
  return torque_Nm;
}

std::vector<double> TorqueBalance::residual_Nm(const Hypothesis& hypothesis) {
  const Actuator& actuator = hypothesis.actuator;
  const double moved_s = delay_of_motion_s(hypothesis), ratio = actuator.transmission.ratio;
  const std::shared_ptr<MovedStretch> moved =
      moved_.of({moved_s, ratio}, [&] { return MovedStretch(signals_, moved_s, ratio, most_); });
  const auto motor = motor_torques_.of(hypothesis, *moved, moved_s);
  const LawSeries smooth_Nm = before_drag(hypothesis, *moved, motor);
  const DirectedSeries drag_Nm = drag_of(actuator, *moved);
  const Ripples ripples(actuator, *moved);
  const Mesh mesh(actuator);
  LawSeries balance_Nm = *load_torque(hypothesis, moved_s);
  const double offset_Nm = hypothesis.log.torque_offset_Nm;
  if (bench_.load_side == LoadSide::kSensor) {
    for (double& each : balance_Nm) each -= offset_Nm;
    subtract_imbalance(hypothesis, *moved, balance_Nm);
    const LawSeries predicted_Nm =
        torque_on_load(mesh, moved->forward_shares(), smooth_Nm, drag_Nm, ripples);
    for (std::size_t i = 0; i < balance_Nm.size(); ++i) balance_Nm[i] -= predicted_Nm[i];
  } else {
    subtract_imbalance(hypothesis, *moved, balance_Nm);
    ripples.take_from(balance_Nm, offset_Nm);
    const LawSeries needed_Nm = torque_for_load(mesh, moved->forward_shares(), balance_Nm, drag_Nm);
    for (std::size_t i = 0; i < balance_Nm.size(); ++i) {
      balance_Nm[i] = (needed_Nm[i] - smooth_Nm[i]) * motor->stated_over_own_slope[i];
    }
  }
  subtract_gap(bench_, hypothesis, signals_, balance_Nm);
  return balance_Nm;
}

std::vector<double> torque_balance_Nm(const Bench& bench, const Hypothesis& hypothesis,
                                      const Signals& signals) {
  return TorqueBalance(bench, signals, 1).residual_Nm(hypothesis);
}

}  // namespace torquewright::identification
