// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/region/torque_ceiling.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "actuator/region/current_choice.hpp"
#include "actuator/region/motor_region.hpp"
#include "hopper/planning/region/linear_region.hpp"

namespace torquewright::hopper {
namespace {

using actuator::Limiter;

// Sizes of the fit, choices of ours: with them the bounds lie inside the true ones by what
// docs/derivations/planned_regions.md states; more knots cost a plan time.
constexpr int kVoltageKnots = 9;     // knots over the bus voltage
constexpr int kSpeedKnots = 72;      // knots over the speeds of a piece
constexpr int kScannedSpeeds = 240;  // speeds at which limiters are told apart
constexpr int kPlacesPerKnot = 4;    // places a knot at which a piece is held down
constexpr int kHalvings = 40;        // halvings of a step of the scan: to rounding
// Shares of a stretch of speeds over which a slope is taken: at a corner, and at its other end,
// where the region may end in a nose.
constexpr double kCornerOver = 5e-4;
constexpr double kEndOver = 5e-3;
// Knots beyond the beginning of a stretch, in shares of its length, and likewise behind its end.
constexpr std::array kBeyondBegin{-0.1, -0.04, -0.015, -0.005};
constexpr double kLeastJump = 0.01;    // of the cap
constexpr double kNextTo = 1e-6;       // of the speeds: close by
constexpr double kShortLength = 0.02;  // of the speeds, which a shorter stretch is taken for
constexpr double kSteepest = 4.0;      // caps a stretch, straight on
constexpr double kShortest = 1e-7;     // of the speeds: a stretch
constexpr double kLeadUp = 1.05;       // of a jump
constexpr double kWithoutLimit_rad_s = 100.0;  // looked at where no voltage sets a speed
constexpr double kHeldDown = 1e-4;             // of the cap, for what is between places

enum class PieceKind { kNone, kCap, kVoltage, kPower, kRegeneration };

/// The greatest torque at one bus voltage, with one limit of power or none.
class CeilingSlice {
 public:
  CeilingSlice(const HeldBus& bus, double bus_V, PieceKind kind)
      : model_(bus.model_at(bus_V)), ratio_(std::abs(bus.actuator().transmission.ratio)) {
    actuator::Supply& supply = model_.supply;
    if (kind != PieceKind::kPower) supply.greatest_power_W = actuator::kUnlimited;
    if (kind != PieceKind::kRegeneration) supply.least_power_W = -actuator::kUnlimited;
  }

  struct Value {
    PieceKind kind = PieceKind::kNone;
    double torque_Nm = 0.0;
  };

  Value at(double speed_rad_s) const {
    const actuator::MotorRange range = motor_range(model_, ratio_ * std::abs(speed_rad_s));
    if (range.is_empty) return {};
    // At negative speeds: the mirror image of the least torque.
    const actuator::MotorBound& bound = speed_rad_s < 0.0 ? range.least : range.greatest;
    const double sign = speed_rad_s < 0.0 ? -1.0 : 1.0;
    return {kind_of(bound.limiter), sign * ratio_ * bound.torque_Nm};
  }

 private:
  PieceKind kind_of(Limiter limiter) const {
    switch (limiter) {
      case Limiter::kCurrent:
      case Limiter::kThermal:
        return PieceKind::kCap;
      case Limiter::kRegeneration:
        return PieceKind::kRegeneration;
      case Limiter::kBatteryPower:
        if (model_.supply.greatest_power_W < actuator::kUnlimited) return PieceKind::kPower;
        break;
      default:
        break;
    }
    return PieceKind::kVoltage;
  }

  actuator::PhaseModel model_;
  double ratio_;
};

/// Speeds at which a limiter limits, at one voltage, and straight continuations.
struct LimitStretch {
  double begin_rad_s = 0.0;
  double end_rad_s = 0.0;
  double begin_Nm = 0.0;
  double end_Nm = 0.0;
  double begin_slope = 0.0;
  double end_slope = 0.0;

  double length_rad_s = 0.0;  ///< By which its speeds are told; it may be shorter.
};

double slope_between(const CeilingSlice& slice, double at_rad_s, double towards_rad_s) {
  const CeilingSlice::Value here = slice.at(at_rad_s);
  const CeilingSlice::Value there = slice.at(towards_rad_s);
  return (there.torque_Nm - here.torque_Nm) / (towards_rad_s - at_rad_s);
}

/// The limiter's own at a speed, continued where it does not limit.
double continued_Nm(const CeilingSlice& slice, const LimitStretch& stretch, double speed_rad_s) {
  if (speed_rad_s <= stretch.begin_rad_s) {
    return stretch.begin_Nm + stretch.begin_slope * (speed_rad_s - stretch.begin_rad_s);
  }
  if (speed_rad_s >= stretch.end_rad_s) {
    return stretch.end_Nm + stretch.end_slope * (speed_rad_s - stretch.end_rad_s);
  }
  return slice.at(speed_rad_s).torque_Nm;
}

/// Between two places of which one holds and one does not: the last one that does.
template <typename Holds>
double last_that_holds(const Holds& holds, double inside, double outside) {
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (inside + outside);
    (holds(middle) ? inside : outside) = middle;
  }
  return inside;
}

/// One limiter's pieces, from slices at voltages.
class PieceFit {
 public:
  PieceFit(const HeldBus& bus, PieceKind kind, double end_rad_s, double step_rad_s,
           TorqueCeiling& ceiling)
      : kind_(kind), end_rad_s_(end_rad_s), step_rad_s_(step_rad_s), ceiling_(ceiling) {
    for (int i = 0; i < 2 * kVoltageKnots - 1; ++i) {
      const double share = static_cast<double>(i) / (2 * kVoltageKnots - 2);
      voltages_.push_back((kLeastVoltage + share * (kGreatestVoltage - kLeastVoltage)) *
                          bus.open_circuit_V());
      slices_.emplace_back(bus, voltages_.back(), kind);
      below_.emplace_back();
      above_.emplace_back();
      scan();
    }
  }

  void add_pieces() {
    for (const Stretches* stretches : {&below_, &above_}) {
      const bool is_any = std::any_of(stretches->begin(), stretches->end(),
                                      [](const auto& stretch) { return stretch.has_value(); });
      if (is_any) ceiling_.pieces.push_back(piece(*stretches));
    }
  }

 private:
  using Stretches = std::vector<std::optional<LimitStretch>>;  ///< By voltage.

  /// Close to one another near both ends of what the last slice's region has.
  std::vector<double> scanned_speeds() const {
    const auto holds = [&](double speed_rad_s) {
      return slices_.back().at(speed_rad_s).kind != PieceKind::kNone;
    };
    double end_rad_s = end_rad_s_;
    if (!holds(end_rad_s)) end_rad_s = last_that_holds(holds, 0.0, end_rad_s);
    std::vector<double> speeds_rad_s;
    for (int i = 0; i <= kScannedSpeeds; ++i) {
      speeds_rad_s.push_back(-end_rad_s * std::cos(std::numbers::pi * i / kScannedSpeeds));
    }
    return speeds_rad_s;
  }

  /// Finds the stretches of the last slice.
  void scan() {
    const std::vector<double> speeds_rad_s = scanned_speeds();
    std::vector<CeilingSlice::Value> values;
    for (const double speed_rad_s : speeds_rad_s) values.push_back(slices_.back().at(speed_rad_s));
    for (std::size_t first = 0, next = 0; first < values.size(); first = next) {
      const PieceKind kind = values[first].kind;
      while (next < values.size() && values[next].kind == kind) ++next;
      if (kind != kind_) continue;
      const auto edge = [&](std::size_t inside, std::size_t outside) {
        const auto holds = [&](double speed_rad_s) {
          return slices_.back().at(speed_rad_s).kind == kind;
        };
        return last_that_holds(holds, speeds_rad_s[inside], speeds_rad_s[outside]);
      };
      const double begin_rad_s = first > 0 ? edge(first, first - 1) : speeds_rad_s.front();
      const double end_rad_s = next < values.size() ? edge(next - 1, next) : speeds_rad_s.back();
      if (kind == PieceKind::kVoltage) {
        // What rises belongs to the lower end of the speeds, what falls to the upper one.
        const auto least = [](const CeilingSlice::Value& one, const CeilingSlice::Value& other) {
          return one.torque_Nm < other.torque_Nm;
        };
        const auto at = [&](std::size_t i) {
          return values.begin() + static_cast<std::ptrdiff_t>(i);
        };
        const auto peak =
            static_cast<std::size_t>(std::max_element(at(first), at(next), least) - values.begin());
        const auto is_cap = [&](std::size_t i) {
          return i < values.size() && values[i].kind == PieceKind::kCap;
        };
        double peak_rad_s = speeds_rad_s[peak];
        if (is_cap(next)) peak_rad_s = end_rad_s;
        if (first > 0 && is_cap(first - 1)) peak_rad_s = begin_rad_s;
        add(below_.back(), begin_rad_s, peak_rad_s, false);
        add(above_.back(), peak_rad_s, end_rad_s, true);
      } else if (kind == PieceKind::kRegeneration) {
        add(below_.back(), begin_rad_s, end_rad_s, false);
      } else {
        add(above_.back(), begin_rad_s, end_rad_s, true);
      }
    }
  }

  /// `falls` with the speed, or rises.
  void add(std::optional<LimitStretch>& known, double begin_rad_s, double end_rad_s, bool falls) {
    const CeilingSlice& slice = slices_.back();
    const double length_rad_s = end_rad_s - begin_rad_s;
    if (!(length_rad_s > kShortest * end_rad_s_)) return;
    const auto monotone = [falls](double value) {
      return falls ? std::min(0.0, value) : std::max(0.0, value);
    };
    const double first_over = falls ? kCornerOver : kEndOver;
    const double last_over = falls ? kEndOver : kCornerOver;
    LimitStretch stretch{
        begin_rad_s,
        end_rad_s,
        slice.at(begin_rad_s).torque_Nm,
        slice.at(end_rad_s).torque_Nm,
        monotone(slope_between(slice, begin_rad_s, begin_rad_s + first_over * length_rad_s)),
        monotone(slope_between(slice, end_rad_s, end_rad_s - last_over * length_rad_s)),
        length_rad_s};
    stretch.length_rad_s = std::max(length_rad_s, kShortLength * end_rad_s_);
    // Where a stretch is short it is steep; straight on it need not be.
    const double steepest = kSteepest * ceiling_.cap_Nm / stretch.length_rad_s;
    stretch.begin_slope = std::clamp(stretch.begin_slope, -steepest, steepest);
    stretch.end_slope = std::clamp(stretch.end_slope, -steepest, steepest);
    if (kind_ == PieceKind::kRegeneration) lead_up(stretch);
    if (!known) {
      known = stretch;
      return;
    }
    known->end_rad_s = stretch.end_rad_s;
    known->end_Nm = stretch.end_Nm;
    known->end_slope = stretch.end_slope;
    known->length_rad_s = stretch.end_rad_s - known->begin_rad_s;
  }

  /// Regeneration limits from some speed of braking on, at once.
  void lead_up(LimitStretch& stretch) {
    const double tiny_rad_s = kNextTo * end_rad_s_;
    const CeilingSlice::Value next = slices_.back().at(stretch.end_rad_s + tiny_rad_s);
    const double jump_Nm = next.torque_Nm - stretch.end_Nm;
    if (next.kind == PieceKind::kNone || jump_Nm < kLeastJump * ceiling_.cap_Nm) return;
    const double room_rad_s = 0.5 * std::abs(stretch.end_rad_s);
    const double over_rad_s =
        room_rad_s > tiny_rad_s ? std::min(step_rad_s_, room_rad_s) : step_rad_s_;
    stretch.end_slope = std::max(stretch.end_slope, kLeadUp * jump_Nm / over_rad_s);
    ceiling_.jumps_rad_s.push_back(stretch.end_rad_s);
  }

  /// The voltage itself if the limiter limits anywhere there, else the nearest one where it does.
  static std::size_t nearest(const Stretches& stretches, std::size_t voltage) {
    std::size_t best = stretches.size();
    for (std::size_t i = 0; i < stretches.size(); ++i) {
      const auto distance = [&](std::size_t to) {
        return to > voltage ? to - voltage : voltage - to;
      };
      if (stretches[i] && (best == stretches.size() || distance(i) < distance(best))) best = i;
    }
    return best;
  }

  /// Where the limiter does not limit: straight on from where it does, so that no bend disturbs
  /// what is beside it.
  double begin_rad_s_at(const Stretches& stretches, std::size_t voltage) const {
    const std::size_t from = nearest(stretches, voltage);
    const std::size_t next = from > voltage ? from + 1 : from - 1;
    const double begin_rad_s = stretches[from]->begin_rad_s;
    if (from == voltage || next >= stretches.size() || !stretches[next]) return begin_rad_s;
    return begin_rad_s + (begin_rad_s - stretches[next]->begin_rad_s) *
                             (voltages_[voltage] - voltages_[from]) /
                             (voltages_[from] - voltages_[next]);
  }

  static std::size_t longest(const Stretches& stretches) {
    std::size_t best = nearest(stretches, 0);
    for (std::size_t i = 0; i < stretches.size(); ++i) {
      if (stretches[i] && stretches[i]->length_rad_s > stretches[best]->length_rad_s) best = i;
    }
    return best;
  }

  /// Power hardly knows the voltage: where it does not limit at one, it is continued as it is where
  /// it limits most.
  double by_power_Nm(const Stretches& stretches, std::size_t voltage, double speed_rad_s) const {
    const std::size_t widest = longest(stretches);
    const std::optional<LimitStretch>& own = stretches[voltage];
    const bool is_corner = kind_ == PieceKind::kRegeneration && own && speed_rad_s > own->end_rad_s;
    const bool is_own =
        own && (is_corner || (speed_rad_s >= own->begin_rad_s && speed_rad_s <= own->end_rad_s));
    const std::size_t from = is_own ? voltage : widest;
    return continued_Nm(slices_[from], *stretches[from], speed_rad_s);
  }

  CeilingPiece piece(const Stretches& stretches) const {
    const std::vector<double> x = share_knots();
    std::vector<double> y;
    Eigen::MatrixXd values(static_cast<Eigen::Index>(x.size()), kVoltageKnots);
    Eigen::VectorXd begins(kVoltageKnots);
    Eigen::VectorXd logs(kVoltageKnots);
    const bool is_voltage = kind_ == PieceKind::kVoltage;
    for (Eigen::Index j = 0; j < kVoltageKnots; ++j) {
      const auto voltage = 2 * static_cast<std::size_t>(j);
      const std::size_t from = is_voltage ? nearest(stretches, voltage) : longest(stretches);
      const LimitStretch& stretch = *stretches[from];
      y.push_back(voltages_[voltage]);
      begins[j] = is_voltage ? begin_rad_s_at(stretches, voltage) : stretch.begin_rad_s;
      logs[j] = std::log(stretch.length_rad_s);
      for (std::size_t i = 0; i < x.size(); ++i) {
        const double speed_rad_s = stretch.begin_rad_s + x[i] * stretch.length_rad_s;
        values(static_cast<Eigen::Index>(i), j) =
            is_voltage ? continued_Nm(slices_[from], stretch, speed_rad_s)
                       : by_power_Nm(stretches, voltage, speed_rad_s);
      }
    }
    const SmoothCurve begin_rad_s(y, begins);
    const SmoothCurve log_length(y, logs);
    SmoothSurface surface(x, y, values);
    surface.lower_to(places(stretches, x, begin_rad_s, log_length));
    surface.lower_by(kHeldDown * ceiling_.cap_Nm);
    return {std::move(surface), begin_rad_s, log_length};
  }

  /// Close to one another near both ends of a stretch, and few beyond.
  static std::vector<double> share_knots() {
    std::vector<double> knots(kBeyondBegin.begin(), kBeyondBegin.end());
    for (int i = 0; i <= kSpeedKnots; ++i) {
      knots.push_back(0.5 * (1.0 - std::cos(std::numbers::pi * i / kSpeedKnots)));
    }
    for (auto beyond = kBeyondBegin.rbegin(); beyond != kBeyondBegin.rend(); ++beyond) {
      knots.push_back(1.0 - *beyond);
    }
    return knots;
  }

  /// The true values where the limiter limits, between knots too.
  std::vector<SmoothSurface::Point> places(const Stretches& stretches, const std::vector<double>& x,
                                           const SmoothCurve& begin_rad_s,
                                           const SmoothCurve& log_length) const {
    std::vector<SmoothSurface::Point> points;
    for (std::size_t v = 0; v < stretches.size(); ++v) {
      if (!stretches[v]) continue;
      const double begin = begin_rad_s.at(voltages_[v]).value;
      const double length = std::exp(log_length.at(voltages_[v]).value);
      const auto look = [&](double speed_rad_s) {
        if (speed_rad_s < stretches[v]->begin_rad_s || speed_rad_s > stretches[v]->end_rad_s) {
          return;
        }
        const CeilingSlice::Value value = slices_[v].at(speed_rad_s);
        if (value.kind != kind_) return;
        points.push_back({(speed_rad_s - begin) / length, voltages_[v], value.torque_Nm});
      };
      look(stretches[v]->begin_rad_s);
      look(stretches[v]->end_rad_s);
      for (std::size_t i = 0; i + 1 < x.size(); ++i) {
        for (int k = 0; k < kPlacesPerKnot; ++k) {
          look(begin + length * (x[i] + (x[i + 1] - x[i]) * k / kPlacesPerKnot));
        }
      }
    }
    return points;
  }

  PieceKind kind_;
  double end_rad_s_;
  double step_rad_s_;
  TorqueCeiling& ceiling_;
  std::vector<double> voltages_;
  std::vector<CeilingSlice> slices_;
  Stretches below_;  ///< Those that rise with the speed,
  Stretches above_;  ///< and those that fall.
};

}  // namespace

CeilingPiece::CeilingPiece(SmoothSurface surface, SmoothCurve begin_rad_s, SmoothCurve log_length)
    : surface_(std::move(surface)),
      begin_rad_s_(std::move(begin_rad_s)),
      log_length_(std::move(log_length)) {}

/// With x = (w - b) / s, b and s functions of V: x_w = 1/s, x_V = -(b' + x s')/s,
/// x_wV = -s'/s^2, x_VV = -(b'' + x s'' + 2 x_V s')/s.
Taylor CeilingPiece::at(double speed_rad_s, double bus_V) const {
  const Taylor b = begin_rad_s_.at(bus_V);
  const Taylor l = log_length_.at(bus_V);
  const double per_s = std::exp(-l.value);
  const double x = (speed_rad_s - b.value) * per_s;
  const double bend = l.xx + l.x * l.x;  // of s, over s; l.x is its slope over s
  const double x_w = per_s;
  const double x_V = -b.x * per_s - x * l.x;
  const double x_wV = -l.x * per_s;
  const double x_VV = -b.xx * per_s - x * bend - 2.0 * x_V * l.x;
  const Taylor f = surface_.at(x, bus_V);
  return {f.value,
          f.x * x_w,
          f.y + f.x * x_V,
          f.xx * x_w * x_w,
          f.xy * x_w + f.xx * x_w * x_V + f.x * x_wV,
          f.yy + 2.0 * f.xy * x_V + f.xx * x_V * x_V + f.x * x_VV};
}

TorqueCeiling torque_ceiling(const HeldBus& bus, double step_rad_s) {
  const double ratio = std::abs(bus.actuator().transmission.ratio);
  actuator::PhaseModel fastest = bus.model_at(kGreatestVoltage * bus.open_circuit_V());
  const actuator::Supply supply = fastest.supply;
  fastest.supply.greatest_power_W = actuator::kUnlimited;
  fastest.supply.least_power_W = -actuator::kUnlimited;
  const double no_load_rad_s = no_load_speed_rad_s(fastest) / ratio;
  const double looked_at_rad_s = std::isfinite(no_load_rad_s)
                                     ? actuator::Region::kSpeedsLookedAt * no_load_rad_s
                                     : kWithoutLimit_rad_s;
  TorqueCeiling ceiling;
  ceiling.end_rad_s = greatest_speed_rad_s(fastest, ratio * looked_at_rad_s) / ratio;
  ceiling.goes_on = ceiling.end_rad_s >= looked_at_rad_s * (1.0 - kNextTo);
  ceiling.cap_Nm = ratio * torque_Nm(fastest, greatest_torque_current(fastest));
  std::vector<PieceKind> kinds{PieceKind::kVoltage};
  if (supply.greatest_power_W < actuator::kUnlimited) kinds.push_back(PieceKind::kPower);
  if (supply.least_power_W > -actuator::kUnlimited) kinds.push_back(PieceKind::kRegeneration);
  for (const PieceKind kind : kinds) {
    PieceFit(bus, kind, ceiling.end_rad_s, step_rad_s, ceiling).add_pieces();
  }
  return ceiling;
}

}  // namespace torquewright::hopper
