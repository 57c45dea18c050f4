// SPDX-License-Identifier: Apache-2.0
#include "actuator/drive_check/interpretation_check.hpp"

#include <algorithm>

#include "actuator/motor/gear_transmission.hpp"

namespace torquewright::actuator {
namespace {

constexpr std::size_t kMostWaiting = 256;
/// Of the no-load speed: a velocity that rounding leaves of none.
constexpr double kRoundedRest = 1e-9;

std::optional<HeatModel> heat_model(const Actuator& actuator) {
  if (!actuator.thermal) return std::nullopt;
  return HeatModel(actuator);
}

/// Root mean square over the time, of a single sample its magnitude.
double rms(const Integral& square, double duration_s, double peak) {
  return duration_s > 0.0 ? std::sqrt(square.sum() / duration_s) : peak;
}

/// Of `square`'s quantity over the motion and the pause after it. Eq. (8), (9).
ContinuousUse continuous_use(const Integral& square, double duration_s, double peak, double pause_s,
                             std::optional<double> limit) {
  ContinuousUse use{rms(square, duration_s + pause_s, peak), limit, {}};
  if (limit) use.pause_s = std::max(0.0, square.sum() / (*limit * *limit) - duration_s);
  return use;
}

std::optional<double> finite(double value) {
  return std::isfinite(value) ? std::optional<double>(value) : std::nullopt;
}

}  // namespace

double rest_speed_rad_s(const Actuator& actuator, const PhaseModel& model) {
  return kRoundedRest * no_load_speed_rad_s(model) / std::abs(actuator.transmission.ratio);
}

CheckBasis::CheckBasis(const Actuator& checked, const OperatingConditions& conditions)
    : actuator(&checked),
      temperature_K(winding_temperature_K(checked, conditions)),
      rotor(checked),
      lookup(rotor.behind_any_teeth(checked), conditions),
      rest_rad_s(rest_speed_rad_s(checked, lookup.model())),
      heat(heat_model(checked)) {}

std::shared_ptr<const HeldRegion> held_region(const CheckBasis& basis,
                                              const OperatingConditions& conditions) {
  return std::make_shared<const HeldRegion>(basis.rotor.behind_any_teeth(*basis.actuator),
                                            conditions, GridTemperatures::kAsAsked);
}

InterpretationCheck::InterpretationCheck(const CheckBasis& basis, bool wants_speed_margin)
    : basis_(&basis),
      lookup_(basis.lookup),
      lookup_of_worst_(basis.lookup),
      lookup_of_first_(basis.lookup),
      wants_speed_margin_(wants_speed_margin) {
  if (basis.heat) heat_.emplace(*basis.heat);
}

bool InterpretationCheck::add(double time_s, double speed_rad_s, double torque_Nm,
                              double acceleration_rad_s2) {
  const RegionLookup& lookup = lookup_;
  speed_rad_s = basis_->counted_rad_s(speed_rad_s);
  const auto [motor_Nm, teeth_Nm] =
      basis_->rotor.of(speed_rad_s, torque_Nm, acceleration_rad_s2, last_speed_rad_s_);
  last_speed_rad_s_ = speed_rad_s;
  const TorqueRange range = lookup.at(speed_rad_s, motor_Nm);
  const double teeth_excess_Nm = std::abs(teeth_Nm) - basis_->actuator->transmission.peak_torque_Nm;
  const double motor_excess_Nm = range.excess_Nm(motor_Nm);
  const bool is_outside =
      lookup.is_outside(range, motor_Nm) || teeth_excess_Nm > lookup.round_off_Nm();
  const bool is_by_teeth = teeth_excess_Nm > motor_excess_Nm;
  const WorstSample sample{time_s, speed_rad_s, is_by_teeth ? teeth_Nm : motor_Nm,
                           {},     0.0,         is_by_teeth ? Limiter::kGear : Limiter::kCurrent};
  if (samples_ == 0) first_s_ = time_s;
  if (is_outside && interpretation_.clipped_samples++ == 0) {
    lookup_of_first_ = lookup_;
    interpretation_.first = sample;
  }
  clipped_.add(time_s, is_outside ? 1.0 : 0.0);
  const double excess_Nm = std::max(motor_excess_Nm, teeth_excess_Nm);
  if (excess_Nm > worst_excess_Nm_) {
    worst_excess_Nm_ = excess_Nm;
    lookup_of_worst_ = lookup_;
    interpretation_.worst = sample;
  }
  // What the motor could hold in place of what turns its rotor says nothing of speeds.
  const bool only_holds = speed_rad_s == 0.0 && motor_Nm != torque_Nm;
  if (wants_speed_margin_ && !only_holds) note_speed_margin(speed_rad_s, motor_Nm);
  interpretation_.peak_torque_Nm = std::max(interpretation_.peak_torque_Nm, std::abs(torque_Nm));
  torque_square_.add(time_s, torque_Nm * torque_Nm);
  add_demand(time_s, speed_rad_s, motor_Nm, range);
  ++samples_;
  last_s_ = time_s;
  return is_outside;
}

void InterpretationCheck::note_speed_margin(double speed_rad_s, double torque_Nm) {
  if (!lookup_.has_less_speed_margin(speed_rad_s, torque_Nm, speed_margin_rad_s_)) return;
  waiting_.push_back({lookup_, speed_rad_s, torque_Nm});
  if (waiting_.size() < kMostWaiting) return;
  speed_margin_rad_s_ = least_speed_margin_rad_s(waiting_, speed_margin_rad_s_);
  waiting_.clear();
}

/// From the last on: where the margin shrinks from sample to sample the others need no search.
double InterpretationCheck::least_speed_margin_rad_s(const std::vector<Slow>& waiting,
                                                     double least_rad_s) {
  for (auto slow = waiting.rbegin(); slow != waiting.rend(); ++slow) {
    const RegionLookup& lookup = slow->lookup;
    if (!lookup.has_less_speed_margin(slow->speed_rad_s, slow->torque_Nm, least_rad_s)) continue;
    least_rad_s = lookup.speed_margin_rad_s(slow->speed_rad_s, slow->torque_Nm, least_rad_s);
  }
  return least_rad_s;
}

void InterpretationCheck::add_demand(double time_s, double speed_rad_s, double torque_Nm,
                                     const TorqueRange& range) {
  const auto demand_of = [&](double asked_Nm) {
    return demand_at(*basis_->actuator, lookup_.model(), basis_->temperature_K, speed_rad_s,
                     asked_Nm);
  };
  std::optional<Demand> demand = demand_of(torque_Nm);
  if (!demand) {
    ++interpretation_.unreachable_samples;
    demand =
        demand_of(range.is_empty ? 0.0 : std::clamp(torque_Nm, range.least_Nm, range.greatest_Nm));
  }
  if (!demand) return;
  interpretation_.peak_current_A = std::max(interpretation_.peak_current_A, demand->current_A);
  peak_motor_torque_Nm_ = std::max(peak_motor_torque_Nm_, std::abs(demand->motor_torque_Nm));
  voltage_margin_V_ = std::min(voltage_margin_V_, demand->voltage_margin_V);
  motor_torque_square_.add(time_s, demand->motor_torque_Nm * demand->motor_torque_Nm);
  current_square_.add(time_s, demand->current_A * demand->current_A);
  drawn_.add(time_s, std::max(0.0, demand->bus_power_W));
  returned_.add(time_s, std::max(0.0, -demand->bus_power_W));
  if (heat_) add_heat(time_s, demand->phase_current_A * demand->phase_current_A);
}

void InterpretationCheck::add_heat(double time_s, double square_A2) {
  if (samples_ > 0) heat_->add(0.5 * (last_square_A2_ + square_A2), time_s - last_s_);
  last_square_A2_ = square_A2;
}

/// A sample whose teeth bear more than its motor lacks.
WorstSample InterpretationCheck::in_the_teeth(WorstSample sample,
                                              const RegionLookup& lookup) const {
  const double most_Nm = basis_->actuator->transmission.peak_torque_Nm;
  const double excess_Nm = std::abs(sample.torque_Nm) - most_Nm;
  sample.limit_Nm = std::copysign(most_Nm, sample.torque_Nm);
  sample.excess_Nm = excess_Nm > lookup.round_off_Nm() ? excess_Nm : 0.0;
  return sample;
}

/// A sample with the bound of the region itself.
WorstSample InterpretationCheck::exactly(WorstSample sample, const RegionLookup& lookup) const {
  if (sample.limiter == Limiter::kGear) return in_the_teeth(sample, lookup);
  const JointRange range = lookup.exact(sample.speed_rad_s);
  if (range.is_empty) {
    sample.limiter = range.why_empty;
    sample.excess_Nm = std::abs(sample.torque_Nm);
    return sample;
  }
  const bool is_upper =
      sample.torque_Nm - range.greatest.torque_Nm >= range.least.torque_Nm - sample.torque_Nm;
  const JointBound& bound = is_upper ? range.greatest : range.least;
  const double excess_Nm =
      is_upper ? sample.torque_Nm - bound.torque_Nm : bound.torque_Nm - sample.torque_Nm;
  sample.limit_Nm = bound.torque_Nm;
  sample.limiter = bound.limiter;
  sample.excess_Nm = excess_Nm > lookup.round_off_Nm() ? excess_Nm : 0.0;
  return sample;
}

CheckedInterpretation InterpretationCheck::finish(std::size_t runs, double pause_s) const {
  CheckedInterpretation interpretation = interpretation_;
  const double duration_s = last_s_ - first_s_;
  interpretation.clipped_time_s = clipped_.sum();
  interpretation.worst = exactly(interpretation_.worst, lookup_of_worst_);
  if (interpretation.first) {
    interpretation.first = exactly(*interpretation.first, lookup_of_first_);
  }
  interpretation.margin_Nm = -interpretation.worst.excess_Nm;
  if (interpretation.worst.excess_Nm == 0.0 && interpretation.worst.limit_Nm) {
    interpretation.margin_Nm =
        std::abs(*interpretation.worst.limit_Nm - interpretation.worst.torque_Nm);
  }
  interpretation.speed_margin_rad_s =
      finite(least_speed_margin_rad_s(waiting_, speed_margin_rad_s_));
  interpretation.has_winding = !basis_->actuator->envelope;
  if (interpretation.has_winding) interpretation.voltage_margin_V = finite(voltage_margin_V_);
  interpretation.rms_torque_Nm = rms(torque_square_, duration_s, interpretation.peak_torque_Nm);
  interpretation.rms_current_A = rms(current_square_, duration_s, interpretation.peak_current_A);
  interpretation.energy_drawn_J = drawn_.sum();
  interpretation.energy_returned_J = returned_.sum();
  if (heat_) interpretation.winding = heat_->report(runs, pause_s);
  add_continuous(pause_s, interpretation);
  return interpretation;
}

void InterpretationCheck::add_continuous(double pause_s, CheckedInterpretation& result) const {
  const Actuator& actuator = *basis_->actuator;
  const double duration_s = last_s_ - first_s_;
  if (actuator.envelope) {
    if (!actuator.envelope->continuous) return;
    const double lasting_Nm = greatest_torque_Nm(*actuator.envelope->continuous) *
                              std::abs(actuator.transmission.ratio / actuator.envelope->ratio);
    result.continuous_torque =
        continuous_use(torque_square_, duration_s, result.peak_torque_Nm, pause_s, lasting_Nm);
    return;
  }
  result.continuous_current = continuous_use(current_square_, duration_s, result.peak_current_A,
                                             pause_s, actuator.drive.continuous_current_A);
  if (!actuator.datasheet) return;
  result.is_rated_at_joint = is_rated_at_joint(actuator);
  const bool at_joint = result.is_rated_at_joint;
  result.continuous_torque =
      continuous_use(at_joint ? torque_square_ : motor_torque_square_, duration_s,
                     at_joint ? result.peak_torque_Nm : peak_motor_torque_Nm_, pause_s,
                     actuator.datasheet->rated_torque_Nm);
}

}  // namespace torquewright::actuator
