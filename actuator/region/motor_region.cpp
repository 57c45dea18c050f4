// SPDX-License-Identifier: Apache-2.0
#include "actuator/region/motor_region.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "actuator/region/bracketed_search.hpp"
#include "actuator/region/current_choice.hpp"
#include "actuator/region/range_by_search.hpp"
#include "actuator/region/voltage_disc.hpp"
#include "actuator/region/voltage_end.hpp"
#include "actuator/unlimited.hpp"

namespace torquewright::actuator {
namespace {

constexpr double kRelativeTolerance = 1e-14;  // of the greatest torque or speed
// How far back from an end that rounding put too far a speed with a range is looked for, in
// tolerances of the speed.
constexpr double kMostBack = 100.0;
constexpr double kPeakTolerance = 1e-9;      // where only the place of a flat top is sought
constexpr double kVoltageTolerance = 2e-15;  // of the phase voltage: rounding in a square root

enum class Method {
  kSolve,   ///< By closed forms or Newton's method where they tell, else by search.
  kSearch,  ///< By brackets alone.
};

/// What the motor can do at one speed >= 0.
class RangeSearch {
 public:
  RangeSearch(const PhaseModel& model, double speed_rad_s, Method method)
      : model_(model),
        speed_rad_s_(speed_rad_s),
        method_(method),
        cap_(greatest_torque_current(model)),
        cap_Nm_(torque_Nm(model, cap_)),
        slack_V_(kVoltageTolerance * model.phase_volts_per_bus_volt * model.supply.open_circuit_V) {
  }

  MotorRange run() {
    find_by_voltage();
    if (range_.is_empty) return range_;
    find_by_power();
    if (range_.is_empty) return range_;
    range_.least = at(least_);
    range_.greatest = at(greatest_);
    return range_;
  }

 private:
  struct End {
    double torque_Nm = 0.0;
    Limiter limiter = Limiter::kCurrent;
    std::optional<Current> current = {};  ///< Where it is known; else the drive's choice.
  };

  double margin_V(double torque_Nm) const {
    const Current current = gentlest_current(model_, torque_Nm, speed_rad_s_);
    return voltage_margin_V(model_, current, speed_rad_s_) + slack_V_;
  }

  double power_W(double torque_Nm) const {
    return bus_power_W(model_, chosen_current(model_, torque_Nm, speed_rad_s_), speed_rad_s_);
  }

  MotorBound at(const End& end) const {
    if (!end.current) return motor_point(model_, end.torque_Nm, speed_rad_s_, end.limiter);
    return {end.torque_Nm, *end.current, bus_power_W(model_, *end.current, speed_rad_s_),
            end.limiter};
  }

  void be_empty(Limiter why) {
    range_.is_empty = true;
    range_.why_empty = why;
  }

  /// What stands in the way just past a bound that margin_V set.
  Limiter voltage_limiter(double past_Nm) const {
    const Current current = gentlest_current(model_, past_Nm, speed_rad_s_);
    if (voltage_margin_V(model_, current, speed_rad_s_) == -kUnlimited) {
      return Limiter::kBatteryPower;
    }
    return weakening_limiter(current.d_A);
  }

  Limiter weakening_limiter(double d_A) const {
    if (!model_.field_weakening) return Limiter::kVoltage;
    const bool at_floor = d_A <= -model_.demagnetisation_current_A * (1.0 - 1e-9);
    return at_floor ? Limiter::kDemagnetisation : Limiter::kFieldWeakening;
  }

  /// The end of the range from a torque that the voltage allows, towards +-cap.
  End end_towards(double from_Nm, double cap_Nm) const {
    if (margin_V(cap_Nm) >= 0.0) return {cap_Nm, model_.current_limiter};
    const auto margin = [this](double torque_Nm) { return margin_V(torque_Nm); };
    const double tolerance_Nm = kRelativeTolerance * cap_Nm_;
    const double end_Nm = last_nonnegative(margin, from_Nm, cap_Nm, tolerance_Nm);
    const double past_Nm = end_Nm + std::copysign(2.0 * tolerance_Nm, cap_Nm);
    return {end_Nm, voltage_limiter(past_Nm)};
  }

  void find_by_voltage() {
    if (method_ == Method::kSearch) return search_by_voltage();
    const std::optional<VoltageDisc> disc = voltage_disc(model_, speed_rad_s_, slack_V_);
    const std::optional<DiscRange> closed = disc ? disc_range(*disc, model_) : std::nullopt;
    if (!closed) {
      if (solve_by_voltage()) return;
      if (model_.field_weakening) {
        const GreatestMargin margin = greatest_margin(model_, speed_rad_s_);
        if (margin.V + slack_V_ < 0.0 && margin.V > -kUnlimited) return be_empty(margin.limiter);
      }
      return search_by_voltage();
    }
    if (closed->is_empty) return be_empty(weakening_limiter(0.0));
    least_ = end_of(closed->least);
    greatest_ = end_of(closed->greatest);
  }

  /// Both ends as optima in the plane of currents, if both are found.
  bool solve_by_voltage() {
    const std::optional<End> greatest = solved_end(cap_);
    const std::optional<End> least = greatest ? solved_end({cap_.d_A, -cap_.q_A}) : std::nullopt;
    if (!least || least->torque_Nm > greatest->torque_Nm) return false;
    least_ = *least;
    greatest_ = *greatest;
    if (greatest_.torque_Nm < 0.0) greatest_.limiter = voltage_limiter(0.0);
    return true;
  }

  std::optional<End> solved_end(const Current& cap) const {
    if (voltage_margin_V(model_, cap, speed_rad_s_) + slack_V_ >= 0.0) {
      return End{torque_Nm(model_, cap), model_.current_limiter, cap};
    }
    const std::optional<VoltageEnd> end = voltage_end(model_, speed_rad_s_, cap);
    if (!end) return std::nullopt;
    return End{end->torque_Nm, weakening_limiter(end->current.d_A), end->current};
  }

  End end_of(const DiscEnd& end) const {
    const double torque_at_end_Nm = actuator::torque_Nm(model_, {0.0, end.current.q_A});
    const Limiter limiter =
        end.by_current_limit ? model_.current_limiter : weakening_limiter(end.current.d_A);
    return {torque_at_end_Nm, limiter};
  }

  void search_by_voltage() {
    double from_Nm = 0.0;
    if (margin_V(0.0) < 0.0) {
      // Beyond no-load speed only braking current, whose drop opposes the back-EMF, is possible.
      const auto margin = [this](double torque_Nm) { return margin_V(torque_Nm); };
      from_Nm = greatest_point(margin, -cap_Nm_, 0.0, kPeakTolerance * cap_Nm_);
      if (margin_V(from_Nm) < 0.0) return be_empty(voltage_limiter(from_Nm));
      greatest_ = end_towards(from_Nm, 0.0);
      greatest_.limiter = voltage_limiter(0.0);
    } else {
      greatest_ = end_towards(0.0, cap_Nm_);
    }
    least_ = end_towards(from_Nm, -cap_Nm_);
  }

  void find_by_power() {
    if (model_.supply.greatest_power_W < kUnlimited) limit_drawn_power();
    if (model_.supply.least_power_W > -kUnlimited && !range_.is_empty) limit_returned_power();
  }

  /// The torque of the range at which the least power is drawn; driving draws more than none.
  double frugal_Nm() const {
    const auto saved_W = [this](double torque_Nm) { return -power_W(torque_Nm); };
    const double top_Nm = std::min(0.0, greatest_.torque_Nm);
    if (least_.torque_Nm >= top_Nm) return least_.torque_Nm;
    return greatest_point(saved_W, least_.torque_Nm, top_Nm, kPeakTolerance * cap_Nm_);
  }

  /// Where T w + 3/2 R (T/K)^2 is least: without saturation and weakening, frugal_Nm.
  double likely_valley_Nm() const {
    const double K = model_.torque_constant_Nm_A;
    const double valley_Nm = -K * K * speed_rad_s_ / (3.0 * model_.resistance_ohm);
    const double top_Nm = std::max(least_.torque_Nm, std::min(0.0, greatest_.torque_Nm));
    return valley_Nm > least_.torque_Nm ? std::min(valley_Nm, top_Nm) : least_.torque_Nm;
  }

  void limit_drawn_power() {
    const auto room_W = [this](double torque_Nm) {
      return model_.supply.greatest_power_W - power_W(torque_Nm);
    };
    const double most_W = model_.supply.greatest_power_W;
    if (at(least_).bus_power_W <= most_W && at(greatest_).bus_power_W <= most_W) return;
    const double top_Nm = std::min(0.0, greatest_.torque_Nm);
    const double start_Nm =
        top_Nm >= least_.torque_Nm && room_W(top_Nm) >= 0.0 ? top_Nm : frugal_Nm();
    if (room_W(start_Nm) < 0.0) return be_empty(Limiter::kBatteryPower);
    for (End* end : {&least_, &greatest_}) {
      if (room_W(end->torque_Nm) >= 0.0) continue;
      *end = {last_nonnegative(room_W, start_Nm, end->torque_Nm, kRelativeTolerance * cap_Nm_),
              Limiter::kBatteryPower};
    }
  }

  void limit_returned_power() {
    const auto room_W = [this](double torque_Nm) {
      return power_W(torque_Nm) - model_.supply.least_power_W;
    };
    double valley_Nm = likely_valley_Nm();
    if (room_W(valley_Nm) >= 0.0) valley_Nm = frugal_Nm();
    if (room_W(valley_Nm) >= 0.0) return;
    const double tolerance_Nm = kRelativeTolerance * cap_Nm_;
    const double bottom_Nm = least_.torque_Nm;
    if (room_W(bottom_Nm) >= 0.0) {
      range_.plugging = {bottom_Nm, last_nonnegative(room_W, bottom_Nm, valley_Nm, tolerance_Nm)};
    }
    const double top_Nm = std::min(0.0, greatest_.torque_Nm);
    if (room_W(top_Nm) < 0.0) return be_empty(Limiter::kRegeneration);
    least_ = {last_nonnegative(room_W, top_Nm, valley_Nm, tolerance_Nm), Limiter::kRegeneration};
  }

  const PhaseModel& model_;
  double speed_rad_s_;
  Method method_;
  Current cap_;
  double cap_Nm_;
  double slack_V_;
  End least_;
  End greatest_;
  MotorRange range_;
};

MotorBound mirrored(MotorBound bound) {
  bound.torque_Nm = -bound.torque_Nm;
  bound.current.q_A = -bound.current.q_A;
  return bound;
}

MotorRange range_by(Method method, const PhaseModel& model, double speed_rad_s) {
  if (speed_rad_s < 0.0) return mirrored(RangeSearch(model, -speed_rad_s, method).run());
  return RangeSearch(model, speed_rad_s, method).run();
}

}  // namespace

MotorRange mirrored(const MotorRange& range) {
  MotorRange result = range;
  result.least = mirrored(range.greatest);
  result.greatest = mirrored(range.least);
  if (range.plugging) {
    result.plugging = {-range.plugging->greatest_Nm, -range.plugging->least_Nm};
  }
  return result;
}

namespace {

/// Of a drive that is known by its curve; empty beyond it.
MotorRange envelope_range(const PhaseModel& model, double speed_rad_s) {
  MotorRange range;
  const std::optional<EnvelopeBounds> bounds = bounds_at(*model.envelope, speed_rad_s);
  if (!bounds) {
    range.is_empty = true;
    range.why_empty = Limiter::kEnvelope;
    return range;
  }
  range.least = motor_point(model, bounds->least_Nm, speed_rad_s, Limiter::kEnvelope);
  range.greatest = motor_point(model, bounds->greatest_Nm, speed_rad_s, Limiter::kEnvelope);
  return range;
}

}  // namespace

MotorRange motor_range(const PhaseModel& model, double speed_rad_s) {
  if (model.envelope) return envelope_range(model, speed_rad_s);
  return range_by(Method::kSolve, model, speed_rad_s);
}

MotorRange motor_range_by_search(const PhaseModel& model, double speed_rad_s) {
  return range_by(Method::kSearch, model, speed_rad_s);
}

MotorBound motor_point(const PhaseModel& model, double torque_Nm, double speed_rad_s,
                       Limiter limiter) {
  const Current current = chosen_current(model, torque_Nm, speed_rad_s);
  return {torque_Nm, current, bus_power_W(model, current, speed_rad_s), limiter};
}

double no_load_speed_rad_s(const PhaseModel& model) {
  if (model.envelope) return last_speed_rad_s(*model.envelope);
  const double voltage_V = model.phase_volts_per_bus_volt * model.supply.open_circuit_V;
  return model.back_emf_V_s_rad > 0.0 ? voltage_V / model.back_emf_V_s_rad : kUnlimited;
}

double greatest_speed_rad_s(const PhaseModel& model, double limit_rad_s) {
  if (model.envelope) return std::min(last_speed_rad_s(*model.envelope), limit_rad_s);
  const auto holds = [&](double speed_rad_s) {
    return motor_range(model, speed_rad_s).is_empty ? -1.0 : 1.0;
  };
  if (holds(limit_rad_s) > 0.0) return limit_rad_s;
  const double tolerance_rad_s = kRelativeTolerance * limit_rad_s;
  const auto margin_V = [&](double speed_rad_s) { return greatest_margin(model, speed_rad_s).V; };
  if (model.field_weakening && margin_V(limit_rad_s) < 0.0) {
    // The margin is continuous where whether there is one is not; rounding may leave it too far.
    const double end_rad_s = last_nonnegative(margin_V, 0.0, limit_rad_s, tolerance_rad_s);
    for (double back = 0.0; back <= kMostBack; back = 4.0 * back + 1.0) {
      const double speed_rad_s = end_rad_s - back * tolerance_rad_s;
      if (holds(speed_rad_s) > 0.0) return speed_rad_s;
    }
  }
  return last_nonnegative(holds, 0.0, limit_rad_s, tolerance_rad_s);
}

}  // namespace torquewright::actuator
