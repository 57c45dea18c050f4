// SPDX-License-Identifier: Apache-2.0
#include "actuator/region/voltage_end.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "actuator/region/bracketed_search.hpp"
#include "actuator/region/current_plane.hpp"
#include "actuator/unlimited.hpp"

namespace torquewright::actuator {
namespace {

constexpr int kMostEndSteps = 20;
constexpr double kShortEndStep = 1e-9;  // of the current limit; the next one is its square
constexpr double kStartShare = 1e-3;    // of a curve, from where Newton's method takes over
constexpr double kRoomyShare = 0.01;    // of a curve, where some room is enough
constexpr double kPastLimit = 1e-9;     // relative: how far rounding puts a point past a limit

/// What else holds where the voltage ends the torques, eq. (14).
enum class Beside { kMostPerVolt, kCurrentLimit, kDemagnetisation, kLeastCurrent };

/// Zero where it holds, and positive where the drive may go.
struct EndCondition {
  double value, d, q;
};

/// Where eq. (2) needs no voltage; not a number for a machine without impedance.
Current short_circuit(const PhaseModel& model, double speed_rad_s) {
  const double X_d = model.pole_pairs * speed_rad_s * model.inductance_d_H;
  const double X_q = model.pole_pairs * speed_rad_s * model.inductance_q_H;
  const double R = model.resistance_ohm;
  const double per_ohm_A = -model.back_emf_V_s_rad * speed_rad_s / (R * R + X_d * X_q);
  return {per_ohm_A * X_q, per_ohm_A * R};
}

class EndSearch {
 public:
  EndSearch(const PhaseModel& model, double speed_rad_s, const Current& cap)
      : model_(model), speed_rad_s_(speed_rad_s), cap_(cap), sign_(std::copysign(1.0, cap.q_A)) {
    const double w = model.pole_pairs * speed_rad_s;
    X_d_ = w * model.inductance_d_H;
    X_q_ = w * model.inductance_q_H;
    emf_V_ = model.back_emf_V_s_rad * speed_rad_s;
    determinant_ = model.resistance_ohm * model.resistance_ohm + X_d_ * X_q_;
    short_circuit_ = short_circuit(model, speed_rad_s);
  }

  std::optional<VoltageEnd> run() const {
    if (!(determinant_ > 0.0)) return std::nullopt;
    if (!model_.field_weakening) return end(Beside::kLeastCurrent, on_ray());
    if (const auto found = end(Beside::kCurrentLimit, on_arc())) return found;
    if (const auto found = end(Beside::kMostPerVolt, highest())) return found;
    if (const auto found = end(Beside::kDemagnetisation, on_floor())) return found;
    return end(Beside::kLeastCurrent, on_ray());
  }

 private:
  double room_V2(const Current& current) const { return room_V2_at(model_, current, speed_rad_s_); }

  /// Near the last point with room towards `outside` of a curve that begins at `other_end`, from
  /// `inside` if there is room, else from wherever there is most.
  template <typename Curve>
  std::optional<Current> last_with_room(const Curve& curve, double other_end, double inside,
                                        double outside) const {
    const auto room = [&](double at) { return room_V2(curve(at)); };
    if (room(outside) >= 0.0) return std::nullopt;
    const auto [low, high] = std::minmax(other_end, outside);
    double tolerance = kStartShare;
    if (!(room(inside) >= 0.0))
      inside = greatest_point(room, low, high, kRoomyShare * (high - low));
    if (!(room(inside) >= 0.0)) {
      inside = greatest_point(room, low, high, 0.0);  // to what doubles tell
      tolerance = 0.0;                                // the other end may be as near
    }
    if (!(room(inside) >= 0.0)) return std::nullopt;
    return curve(last_nonnegative(room, inside, outside, tolerance * std::abs(outside - inside)));
  }

  /// From the q axis towards negative d currents, so that none lies between two of interest.
  static double angle_of(const Current& i) {
    const double angle = std::atan2(-i.d_A, i.q_A);
    return angle < -0.5 * std::numbers::pi ? angle + 2.0 * std::numbers::pi : angle;
  }

  /// On the current limit, from the greatest torque towards the current of a short circuit.
  std::optional<Current> on_arc() const {
    const double limit_A = model_.current_limit_A;
    const auto arc = [&](double angle) {
      return Current{-limit_A * std::sin(angle), limit_A * std::cos(angle)};
    };
    const double other_end = sign_ > 0.0 ? std::numbers::pi : 0.0;
    return last_with_room(arc, other_end, angle_of(short_circuit_), angle_of(cap_));
  }

  std::optional<Current> on_floor() const {
    const double limit_A = model_.current_limit_A;
    const double d_A = -model_.demagnetisation_current_A;
    if (-d_A >= limit_A) return std::nullopt;
    const auto floor = [&](double q_A) { return Current{d_A, q_A}; };
    const double R = model_.resistance_ohm;
    const double least_V_q_A = (X_q_ * R * d_A - R * (X_d_ * d_A + emf_V_)) / (X_q_ * X_q_ + R * R);
    const double outside_A = sign_ * std::sqrt(limit_A * limit_A - d_A * d_A);
    return last_with_room(floor, -outside_A, least_V_q_A, outside_A);
  }

  std::optional<Current> on_ray() const {
    constexpr double kNearlyNothing = 1e-9;
    const auto ray = [&](double share) { return Current{share * cap_.d_A, share * cap_.q_A}; };
    return last_with_room(ray, -1.0, kNearlyNothing, 1.0);
  }

  /// The highest q current of the ellipse that a bus voltage allows; twice, so that the bus has
  /// sagged under about the power that it delivers.
  std::optional<Current> highest() const {
    const double R = model_.resistance_ohm;
    const double length = sign_ * std::hypot(R, X_d_);
    Current current;
    double bus_V = model_.supply.open_circuit_V;
    for (int pass = 0; pass < 2; ++pass) {
      const double rise = model_.phase_volts_per_bus_volt * bus_V / (length * determinant_);
      current = {short_circuit_.d_A + rise * R * (X_q_ - X_d_),
                 short_circuit_.q_A + rise * length * length};
      bus_V = bus_voltage_V(model_.supply, bus_power_W(model_, current, speed_rad_s_))
                  .value_or(0.5 * model_.supply.open_circuit_V);
    }
    return current;
  }

  EndCondition condition(Beside beside, const Current& i, const CurrentPlane& plane) const {
    const Bent& T = plane.torque_Nm;
    const Bent& h = plane.room_V2;
    switch (beside) {
      case Beside::kMostPerVolt:
        return {h.d * T.q - h.q * T.d, h.dd * T.q + h.d * T.dq - h.dq * T.d - h.q * T.dd,
                h.dq * T.q + h.d * T.qq - h.qq * T.d - h.q * T.dq};
      case Beside::kCurrentLimit:
        return {model_.current_limit_A * model_.current_limit_A - i.d_A * i.d_A - i.q_A * i.q_A,
                -2.0 * i.d_A, -2.0 * i.q_A};
      case Beside::kDemagnetisation:
        return {i.d_A + model_.demagnetisation_current_A, 1.0, 0.0};
      case Beside::kLeastCurrent:
        break;
    }
    return {i.q_A * T.d - i.d_A * T.q, i.q_A * T.dd - T.q - i.d_A * T.dq,
            T.d + i.q_A * T.dq - i.d_A * T.qq};
  }

  /// No step towards more torque is free, eq. (15).
  bool is_optimum(Beside beside, const EndCondition& c, const CurrentPlane& plane) const {
    const Bent& T = plane.torque_Nm;
    const Bent& h = plane.room_V2;
    if (beside == Beside::kMostPerVolt) {
      // Along the line of this torque the room is greatest here.
      const double slope = -T.d / T.q;
      const double turn = -(T.dd + 2.0 * T.dq * slope + T.qq * slope * slope) / T.q;
      const double bend = h.dd + 2.0 * h.dq * slope + h.qq * slope * slope + h.q * turn;
      return sign_ * h.q * T.q < 0.0 && bend < 0.0;
    }
    const double determinant = h.d * c.q - h.q * c.d;
    const double by_voltage = -sign_ * (T.d * c.q - T.q * c.d) / determinant;
    const double by_condition = -sign_ * (h.d * T.q - h.q * T.d) / determinant;
    return by_voltage > 0.0 && (!model_.field_weakening || by_condition >= 0.0);
  }

  bool is_allowed(Beside beside, const Current& i, const CurrentPlane& plane) const {
    const double limit_A = model_.current_limit_A;
    if (i.amplitude_A() > limit_A * (1.0 + kPastLimit)) return false;
    if (i.d_A < -model_.demagnetisation_current_A * (1.0 + kPastLimit)) return false;
    if (!(plane.torque_Nm.q > 0.0)) return false;  // the flux would have changed its sign
    return beside == Beside::kLeastCurrent ||
           condition(Beside::kLeastCurrent, i, plane).value >=
               -kPastLimit * limit_A * model_.torque_constant_Nm_A;
  }

  /// Dead time turns with the current, so that the room for a torque may have two tops: one beside
  /// no d current at all.
  bool has_room_unweakened(Beside beside, double torque_Nm) const {
    if (model_.dead_time_V == 0.0 || beside == Beside::kLeastCurrent) return false;
    return room_V2({0.0, q_current_A(model_, torque_Nm, 0.0)}) > 0.0;
  }

  std::optional<VoltageEnd> end(Beside beside, const std::optional<Current>& start) const {
    if (!start) return std::nullopt;
    Current i = *start;
    for (int step = 0; step < kMostEndSteps; ++step) {
      const std::optional<CurrentPlane> plane = current_plane_at(model_, i, speed_rad_s_);
      if (!plane) return std::nullopt;
      const Bent& h = plane->room_V2;
      const EndCondition c = condition(beside, i, *plane);
      const double determinant = h.d * c.q - h.q * c.d;
      const double d_A = (h.q * c.value - h.value * c.q) / determinant;
      const double q_A = (h.value * c.d - h.d * c.value) / determinant;
      const double length_A = std::hypot(d_A, q_A);
      if (!(length_A <= 2.0 * model_.current_limit_A)) return std::nullopt;
      i = {i.d_A + d_A, i.q_A + q_A};
      if (length_A > kShortEndStep * model_.current_limit_A) continue;
      const VoltageEnd found{i, torque_Nm(model_, i)};
      const bool is_end = is_optimum(beside, c, *plane) && is_allowed(beside, i, *plane) &&
                          !has_room_unweakened(beside, found.torque_Nm);
      return is_end ? std::optional(found) : std::nullopt;
    }
    return std::nullopt;
  }

  const PhaseModel& model_;
  double speed_rad_s_;
  Current cap_;
  double sign_;
  double X_d_, X_q_, emf_V_, determinant_;
  Current short_circuit_;
};

/// The greatest margin on a curve.
template <typename Curve>
double greatest_on_V(const PhaseModel& model, double speed_rad_s, const Curve& curve, double low,
                     double high) {
  const auto margin_V = [&](double at) { return voltage_margin_V(model, curve(at), speed_rad_s); };
  return margin_V(greatest_point(margin_V, low, high, 0.0));  // to what doubles tell
}

}  // namespace

GreatestMargin greatest_margin(const PhaseModel& model, double speed_rad_s) {
  const double limit_A = model.current_limit_A;
  const double most_A = std::min(model.demagnetisation_current_A, limit_A);
  const Current least_V = short_circuit(model, speed_rad_s);
  if (!(least_V.amplitude_A() > limit_A || least_V.d_A < -most_A)) return {};
  const auto arc = [&](double angle) {
    return Current{-limit_A * std::sin(angle), -limit_A * std::cos(angle)};
  };
  const double on_arc_V = greatest_on_V(model, speed_rad_s, arc, 0.0, std::asin(most_A / limit_A));
  const auto floor = [&](double q_A) { return Current{-most_A, q_A}; };
  const double corner_A = std::sqrt(limit_A * limit_A - most_A * most_A);
  const double on_floor_V = greatest_on_V(model, speed_rad_s, floor, -corner_A, 0.0);
  const bool is_on_floor =
      most_A < limit_A && on_floor_V >= on_arc_V - kPastLimit * std::abs(on_arc_V);
  return {std::max(on_arc_V, on_floor_V),
          is_on_floor ? Limiter::kDemagnetisation : Limiter::kFieldWeakening};
}

std::optional<VoltageEnd> voltage_end(const PhaseModel& model, double speed_rad_s,
                                      const Current& cap) {
  return EndSearch(model, speed_rad_s, cap).run();
}

}  // namespace torquewright::actuator
