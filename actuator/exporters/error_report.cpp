// SPDX-License-Identifier: Apache-2.0
#include "actuator/exporters/error_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "actuator/friction/friction_answers.hpp"
#include "actuator/region/bracketed_search.hpp"

namespace torquewright::actuator {
namespace {

constexpr int kSpeeds = 1000;         // on each side of rest, besides the corners
constexpr double kRounding = 1e-9;    // of the peak torque
constexpr double kLookedPast = 2.0;   // times the greatest speed: only the law itself is looked at
constexpr double kNearlyRest = 1e-9;  // of the greatest speed

enum class State { kInterval, kContradiction, kUnbounded };

/// A law's bounds against the region's at one speed.
class Comparison {
 public:
  Comparison(const Subject& subject, const Exporter& exporter, std::span<const double> shape)
      : subject_(subject), exporter_(exporter), shape_(shape) {
    if (!subject.friction) return;
    answers_.emplace(*subject.whole, subject.conditions, *subject.friction, exporter.friction.dry);
  }

  TorqueLimits limits(double speed_rad_s) const { return exporter_.law(shape_, speed_rad_s); }

  State state(double speed_rad_s) const {
    const TorqueLimits at = limits(speed_rad_s);
    if (std::isinf(at.least_Nm) && std::isinf(at.greatest_Nm) && at.least_Nm < at.greatest_Nm) {
      return State::kUnbounded;
    }
    const double rounding_Nm = kRounding * subject_.table.peak_torque_Nm;
    return at.least_Nm <= at.greatest_Nm + rounding_Nm ? State::kInterval : State::kContradiction;
  }

  /// What the simulator gives too much of (sign 1) or too little of (sign -1); negative: nothing.
  /// Zero where they cannot be compared.
  double error_Nm(double speed_rad_s, bool is_upper, double sign) const {
    const JointRange range = region(speed_rad_s);
    if (range.is_empty || state(speed_rad_s) != State::kInterval) return 0.0;
    const TorqueLimits at = delivered(speed_rad_s);
    const TorqueLimits region{range.least.torque_Nm, range.greatest.torque_Nm};
    if (speed_rad_s == 0.0) {
      return sign *
             (is_upper ? at.greatest_Nm - region.greatest_Nm : region.least_Nm - at.least_Nm);
    }
    const bool is_driving = (speed_rad_s > 0.0) == is_upper;
    return speed_rad_s > 0.0 ? forward_error_Nm(at, region, is_driving, sign)
                             : forward_error_Nm(mirrored(at), mirrored(region), is_driving, sign);
  }

  /// The same of a command of half the limit, in the command's direction; `speed_rad_s` is not 0.
  double error_at_half_Nm(double speed_rad_s, bool is_upper, double sign) const {
    const TorqueLimits at = limits(speed_rad_s);
    if (state(speed_rad_s) != State::kInterval || std::isinf(at.greatest_Nm)) return 0.0;
    const double command_Nm = 0.5 * (is_upper ? at.greatest_Nm : at.least_Nm);
    const double side = is_upper ? 1.0 : -1.0;
    if (command_Nm * side <= 0.0 || subject_.region.at(speed_rad_s).is_empty) return 0.0;
    const double direction = std::copysign(1.0, speed_rad_s);
    const double simulated_Nm = answers_->simulated_Nm(command_Nm, speed_rad_s, direction);
    const Span given_Nm = answers_->given_Nm(command_Nm, speed_rad_s, direction);
    return std::max(sign * side * (simulated_Nm - given_Nm.least),
                    sign * side * (simulated_Nm - given_Nm.greatest));
  }

  bool has_joint_friction() const { return answers_.has_value(); }

  /// Lengths of what the law allows, and of the part of it outside the region.
  struct Lengths {
    double allowed_Nm = 0.0;
    double outside_Nm = 0.0;
  };
  Lengths lengths(double speed_rad_s) const {
    if (state(speed_rad_s) != State::kInterval) return {};
    const TorqueLimits at = delivered(speed_rad_s);
    const double allowed_Nm = std::max(0.0, at.greatest_Nm - at.least_Nm);
    const JointRange range = region(speed_rad_s);
    if (range.is_empty) return {allowed_Nm, allowed_Nm};
    const double shared_Nm = std::min(at.greatest_Nm, range.greatest.torque_Nm) -
                             std::max(at.least_Nm, range.least.torque_Nm);
    return {allowed_Nm, allowed_Nm - std::max(0.0, shared_Nm)};
  }

 private:
  JointRange region(double speed_rad_s) const {
    return answers_ ? answers_->region(speed_rad_s) : subject_.region.at(speed_rad_s);
  }

  /// What the law's limits leave to the load; at rest of both ways.
  TorqueLimits delivered(double speed_rad_s) const {
    const TorqueLimits law = limits(speed_rad_s);
    if (!answers_) return law;
    const auto towards = [&](double direction) {
      return TorqueLimits{answers_->simulated_Nm(law.least_Nm, speed_rad_s, direction),
                          answers_->simulated_Nm(law.greatest_Nm, speed_rad_s, direction)};
    };
    if (speed_rad_s != 0.0) return towards(std::copysign(1.0, speed_rad_s));
    const TorqueLimits forward = towards(1.0);
    const TorqueLimits backward = towards(-1.0);
    return {std::min(forward.least_Nm, backward.least_Nm),
            std::max(forward.greatest_Nm, backward.greatest_Nm)};
  }

  static TorqueLimits mirrored(const TorqueLimits& limits) {
    return {-limits.greatest_Nm, -limits.least_Nm};
  }

  /// Driving is what lies above zero. Of braking both ends count: past the no-load speed a motor
  /// cannot but brake, and the least of it is a bound too.
  static double forward_error_Nm(const TorqueLimits& at, const TorqueLimits& region,
                                 bool is_driving, double sign) {
    if (is_driving) {
      return sign * (std::max(0.0, at.greatest_Nm) - std::max(0.0, region.greatest_Nm));
    }
    const double most_Nm = region.least_Nm - at.least_Nm;
    const double least_Nm = std::min(0.0, at.greatest_Nm) - std::min(0.0, region.greatest_Nm);
    return std::max(sign * most_Nm, sign * least_Nm);
  }

  const Subject& subject_;
  const Exporter& exporter_;
  std::span<const double> shape_;
  std::optional<FrictionAnswers> answers_;  ///< Where the joint has the friction.
};

/// Ascending from just off rest, where a bound may jump.
std::vector<double> speeds_looked_at(const Subject& subject, int direction) {
  const double end_rad_s = subject.region.greatest_speed_rad_s();
  std::vector<double> speeds_rad_s{direction * kNearlyRest * end_rad_s};
  for (int i = 1; i <= kSpeeds; ++i) speeds_rad_s.push_back(direction * end_rad_s * i / kSpeeds);
  for (const MorRow& row : subject.table.rows) {
    if (row.speed_rad_s * direction > 0.0) speeds_rad_s.push_back(row.speed_rad_s);
  }
  std::sort(speeds_rad_s.begin(), speeds_rad_s.end(),
            [](double a, double b) { return std::abs(a) < std::abs(b); });
  return speeds_rad_s;
}

/// The worst error of one sign, sought between the neighbours of the worst speed looked at.
WorstError worst(const std::function<double(double)>& error_Nm,
                 const std::vector<double>& speeds_rad_s, double rounding_Nm) {
  std::size_t place = 0;
  double greatest_Nm = error_Nm(speeds_rad_s[0]);
  for (std::size_t i = 1; i < speeds_rad_s.size(); ++i) {
    const double here_Nm = error_Nm(speeds_rad_s[i]);
    if (here_Nm > greatest_Nm + rounding_Nm) {
      greatest_Nm = here_Nm;
      place = i;
    }
  }
  if (greatest_Nm <= rounding_Nm) return {};
  const double low = speeds_rad_s[place == 0 ? 0 : place - 1];
  const double high = speeds_rad_s[std::min(place + 1, speeds_rad_s.size() - 1)];
  const double refined = greatest_point(error_Nm, std::min(low, high), std::max(low, high),
                                        1e-12 * std::abs(speeds_rad_s.back()));
  const double refined_Nm = error_Nm(refined);
  if (refined_Nm > greatest_Nm + rounding_Nm) return {refined_Nm, refined};
  return {greatest_Nm, place == 0 ? 0.0 : speeds_rad_s[place]};
}

/// An error of both signs over speeds of one sign.
template <typename Error>
QuadrantError quadrant(int direction, bool is_upper, const Error& error_Nm,
                       const std::vector<double>& speeds_rad_s, double rounding_Nm) {
  const auto of_sign = [&](double sign) {
    return worst([&](double speed_rad_s) { return error_Nm(speed_rad_s, is_upper, sign); },
                 speeds_rad_s, rounding_Nm);
  };
  return {direction, is_upper, of_sign(1.0), of_sign(-1.0)};
}

template <typename Error>
std::array<QuadrantError, 4> quadrants(const Subject& subject, const Error& error_Nm,
                                       double rounding_Nm) {
  std::array<QuadrantError, 4> all{};
  std::size_t place = 0;
  for (const int direction : {1, -1}) {
    const std::vector<double> speeds_rad_s = speeds_looked_at(subject, direction);
    for (const bool is_upper : {true, false}) {
      all[place++] = quadrant(direction, is_upper, error_Nm, speeds_rad_s, rounding_Nm);
    }
  }
  return all;
}

WorstError at_rest(const Comparison& comparison, bool is_upper, double sign, double rounding_Nm) {
  const double error_Nm = comparison.error_Nm(0.0, is_upper, sign);
  return error_Nm > rounding_Nm ? WorstError{error_Nm, 0.0} : WorstError{};
}

/// The first speed past which the law is in that state, to a billionth; negative: none is found.
double first_speed_rad_s(const Comparison& comparison, double end_rad_s, int direction,
                         State state) {
  double before_rad_s = 0.0;
  for (int i = 1; i <= kSpeeds; ++i) {
    double after_rad_s = end_rad_s * i / kSpeeds;
    if (comparison.state(direction * after_rad_s) != state) {
      before_rad_s = after_rad_s;
      continue;
    }
    while (after_rad_s - before_rad_s > 1e-9 * end_rad_s) {
      const double middle = 0.5 * (before_rad_s + after_rad_s);
      (comparison.state(direction * middle) == state ? after_rad_s : before_rad_s) = middle;
    }
    return after_rad_s;
  }
  return -1.0;
}

std::vector<std::string> sentences_of(const Subject& subject, const Comparison& comparison) {
  std::vector<std::string> sentences;
  const double end_rad_s = subject.region.greatest_speed_rad_s();
  for (const int direction : {1, -1}) {
    const std::string_view mark = direction > 0 ? ">" : "<";
    const double crossed =
        first_speed_rad_s(comparison, kLookedPast * end_rad_s, direction, State::kContradiction);
    if (crossed >= 0.0) {
      sentences.push_back(
          fmt::format("at speeds {} {:.6g} rad/s the law contradicts itself: its upper limit lies "
                      "below its lower one",
                      mark, direction * crossed));
    }
    const double unbounded =
        first_speed_rad_s(comparison, kLookedPast * end_rad_s, direction, State::kUnbounded);
    if (unbounded >= 0.0) {
      sentences.push_back(fmt::format(
          "at speeds {} {:.6g} rad/s the format sets no limit to the torque: it holds that such "
          "speeds are not reached",
          mark, direction * unbounded));
    }
  }
  const auto empty = [](const MorRow& row) { return row.range.is_empty; };
  const auto row = std::find_if(subject.table.rows.begin(), subject.table.rows.end(), empty);
  if (row != subject.table.rows.end()) {
    sentences.push_back(fmt::format(
        "the region is empty at some speeds, such as {:.6g} rad/s (limiter {}): they count in no "
        "number, whatever the simulator does there",
        row->speed_rad_s, name_of(row->range.why_empty)));
  }
  return sentences;
}

/// What the joint's friction cannot hold. A composed law holds all but what turns on the angle.
std::vector<std::string> sentences_of_friction(const Subject& subject, const Exporter& exporter) {
  if (exporter.friction.dry == DryFriction::kComposed) return {};
  return friction_not_held(
      *subject.whole, winding_temperature_K(subject.actuator, subject.conditions),
      subject.region.greatest_speed_rad_s(), exporter.friction.dry == DryFriction::kBreakaway,
      subject.table.peak_torque_Nm);
}

/// Midpoint rule, cut where the law stops being an interval.
double share_outside(const Subject& subject, const Comparison& comparison) {
  double allowed = 0.0;
  double outside = 0.0;
  for (const int direction : {1, -1}) {
    double end_rad_s = subject.region.greatest_speed_rad_s();
    for (const State state : {State::kContradiction, State::kUnbounded}) {
      const double cut_rad_s = first_speed_rad_s(comparison, end_rad_s, direction, state);
      if (cut_rad_s >= 0.0) end_rad_s = cut_rad_s;
    }
    for (int i = 0; i < kSpeeds; ++i) {
      const auto lengths = comparison.lengths(direction * end_rad_s * (i + 0.5) / kSpeeds);
      allowed += lengths.allowed_Nm * end_rad_s;
      outside += lengths.outside_Nm * end_rad_s;
    }
  }
  return outside > kRounding * allowed ? outside / allowed : 0.0;
}

}  // namespace

std::string_view mode_of(const QuadrantError& error) {
  if (error.direction == 0) return "at rest";
  return (error.direction > 0) == error.is_upper ? "driving" : "braking";
}

ErrorReport error_report(const Subject& subject, const Exporter& exporter,
                         std::span<const double> shape) {
  const Comparison comparison(subject, exporter, shape);
  const double rounding_Nm = kRounding * subject.table.peak_torque_Nm;
  ErrorReport report{.greatest_speed_rad_s = subject.region.greatest_speed_rad_s(),
                     .quadrants = quadrants(
                         subject,
                         [&](double speed_rad_s, bool is_upper, double sign) {
                           return comparison.error_Nm(speed_rad_s, is_upper, sign);
                         },
                         rounding_Nm),
                     .at_rest = {},
                     .share_outside = share_outside(subject, comparison),
                     .sentences = sentences_of(subject, comparison)};
  for (const bool is_upper : {true, false}) {
    report.at_rest[is_upper ? 0 : 1] = {0, is_upper,
                                        at_rest(comparison, is_upper, 1.0, rounding_Nm),
                                        at_rest(comparison, is_upper, -1.0, rounding_Nm)};
  }
  if (!comparison.has_joint_friction()) return report;
  for (std::string& sentence : sentences_of_friction(subject, exporter)) {
    report.sentences.push_back(std::move(sentence));
  }
  report.at_half = quadrants(
      subject,
      [&](double speed_rad_s, bool is_upper, double sign) {
        return comparison.error_at_half_Nm(speed_rad_s, is_upper, sign);
      },
      rounding_Nm);
  return report;
}

std::vector<std::string> error_lines(const ErrorReport& report) {
  const auto cell = [](const WorstError& error) {
    if (error.torque_Nm == 0.0) return fmt::format("{:>28}", "none");
    return fmt::format(
        "{:>28}", fmt::format("{:.6g} Nm at {:.6g} rad/s", error.torque_Nm, error.speed_rad_s));
  };
  std::vector<std::string> lines{
      fmt::format("Worst torque error of the simulator with this file, |speed| up to {:.6g} rad/s:",
                  report.greatest_speed_rad_s),
      fmt::format("{:>18} {:>28} {:>28}", "bound", "too optimistic", "too cautious")};
  const auto add = [&](const QuadrantError& error, const std::string& where) {
    lines.push_back(
        fmt::format("{:>18} {} {}", where, cell(error.optimistic), cell(error.cautious)));
  };
  const auto add_quadrant = [&](const QuadrantError& error) {
    add(error, fmt::format("speed {} 0, {}", error.direction > 0 ? '>' : '<', mode_of(error)));
  };
  for (const QuadrantError& error : report.quadrants) add_quadrant(error);
  for (const QuadrantError& error : report.at_rest) {
    add(error, fmt::format("at rest, {}", error.is_upper ? "upper" : "lower"));
  }
  if (report.at_half) {
    lines.emplace_back("At a command of half the limit, of which the motor brings as much:");
    for (const QuadrantError& error : *report.at_half) add_quadrant(error);
  }
  lines.push_back(fmt::format(
      "{:.4g} % of the torque-speed area that the simulator allows lies outside the region",
      100.0 * report.share_outside));
  for (const std::string& sentence : report.sentences) lines.push_back(sentence);
  return lines;
}

}  // namespace torquewright::actuator
