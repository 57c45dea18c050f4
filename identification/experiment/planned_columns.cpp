// SPDX-License-Identifier: Apache-2.0
#include "identification/experiment/planned_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "actuator/effects/library.hpp"
#include "identification/forward/candidates.hpp"
#include "identification/forward/torque_forward.hpp"
#include "identification/forward/torque_prediction.hpp"

namespace torquewright::identification {
namespace {

using Coordinates = std::vector<double>;

// Typical values at which effects that are not linear are planned for.
constexpr double kStribeckShare = 0.05;  ///< Of the greatest speed.
constexpr double kPreslidingLength_rad = 0.01;
constexpr double kSaturationExponent = 2.0;
constexpr double kLag_s = 0.008;
constexpr double kGap_rad = 0.002;

constexpr double kDifference = 1e-4;  ///< Of a parameter's size, between two hypotheses.

const actuator::EffectKind& kind(const char* name) { return *actuator::find_effect(name); }

/// What is asked by name of waves is one of each: the electrical turn's second, the output's
/// second, and of friction its first.
std::optional<EffectCandidate> planned_wave(const Bench& bench, double torque_Nm,
                                            const std::string& effect) {
  const double electrical = 2.0 * bench.actuator().motor.pole_pairs;
  if (effect == "cogging_torque") {
    return wave_candidate(kind("cogging_torque"), electrical, false, torque_Nm);
  }
  if (effect == "gear_ripple") return wave_candidate(kind("gear_ripple"), 2.0, false, torque_Nm);
  if (effect == "position_dependent_friction") {
    return wave_candidate(kind("position_dependent_friction"), 1.0, false, torque_Nm);
  }
  return std::nullopt;
}

std::optional<EffectCandidate> planned_candidate(const Bench& bench, const actuator::Ranges& ranges,
                                                 const std::string& effect) {
  // Where every channel is late by the same, nothing is: one of them stands for all.
  if (effect == "channel_delay") {
    const bool is_sensor = bench.load_side == LoadSide::kSensor;
    return delay_candidate(is_sensor ? bench.load_channel : bench.drive_channel);
  }
  if (auto wave = planned_wave(bench, ranges.torque_Nm, effect)) return wave;
  for (EffectCandidate& each : torque_candidates(bench, ranges)) {
    if (each.effect == effect) return std::move(each);
  }
  return std::nullopt;
}

/// Columns of one candidate on a bench.
class Columns {
 public:
  Columns(const Bench& bench, const actuator::Ranges& ranges, const EffectCandidate& candidate)
      : ranges_(ranges),
        candidate_(candidate),
        kind_(actuator::find_effect(candidate.effect)),
        start_(candidate.starts.front()) {
    stated_.actuator = bench.actuator();
    stated_.rig = *bench.rig;
  }

  std::vector<PlannedColumn> take() {
    const std::string& effect = candidate_.effect;
    if (effect == "stribeck_friction") {
      return {breakaway(kStribeckShare * ranges_.speed_rad_s)};
    }
    if (effect == "presliding_friction") return {presliding(kPreslidingLength_rad)};
    if (effect == "asymmetric_friction") {
      // What both directions have in common is Coulomb and viscous friction.
      return {difference("coulomb_difference_Nm", 0, 1),
              difference("viscous_difference_Nm_s_rad", 2, 3)};
    }
    if (effect == "torque_constant_saturation") {
      return {share({ranges_.current_A, kSaturationExponent},
                    fmt::format("of a saturation at {:.3g} A, exponent {:g}", ranges_.current_A,
                                kSaturationExponent))};
    }
    if (effect == "torque_lag")
      return {share({kLag_s}, fmt::format("of a lag of {:.3g} s", kLag_s))};
    if (effect == "backlash") {
      return {share({kGap_rad}, fmt::format("of a gap of {:.3g} rad", kGap_rad))};
    }
    return slopes();
  }

 private:
  PlannedColumn column(std::string parameter, std::string at) const {
    return {candidate_.effect, std::move(parameter), std::move(at), stated_, stated_, 1.0};
  }

  PlannedColumn between(std::string parameter, std::string at, const Coordinates& low,
                        const Coordinates& high, double change) const {
    PlannedColumn made = column(std::move(parameter), std::move(at));
    candidate_.apply(low, made.low);
    candidate_.apply(high, made.high);
    made.change = change;
    return made;
  }

  double step(std::size_t parameter) const {
    return kDifference * candidate_.parameters[parameter].size;
  }

  /// What moves nothing while there is nothing of the effect stands at what a fit starts from.
  std::vector<PlannedColumn> slopes() const {
    std::vector<PlannedColumn> all;
    std::string at;
    for (std::size_t k = 0; k < start_.size(); ++k) {
      const FitParameter& parameter = candidate_.parameters[k];
      Coordinates high = start_;
      high[k] += step(k);
      PlannedColumn slope = between(name_of(parameter.name), "", start_, high, step(k));
      if (kind_ == nullptr || law_in(slope.low) != law_in(slope.high)) {
        all.push_back(std::move(slope));
      } else {
        at += fmt::format("{}{} {:.3g}", at.empty() ? "at " : ", ", parameter.name,
                          parameter.value(start_[k]));
      }
    }
    for (PlannedColumn& each : all) each.at = at;
    return all;
  }

  /// The effect's law forward and backward, added so that neither hides the other.
  double law_in(const Hypothesis& hypothesis) const {
    const actuator::Instant forward{1.1, 1.0, 1.2, 1.3, 1.4, 1.5, 1.6, 1.7, 318.15};
    actuator::Instant backward = forward;
    backward.speed_rad_s = -1.1;
    backward.direction = -1.0;
    double sum = 0.0;
    for (const actuator::Effect& each : hypothesis.actuator.effects) {
      if (each.kind == kind_)
        sum += each.kind->law(each, forward) + 2.0 * each.kind->law(each, backward);
    }
    return sum;
  }

  /// As documents have it, but for what is fitted by sine and cosine.
  std::string name_of(const std::string& parameter) const {
    if (candidate_.order > 0.0) {
      const std::string part = parameter.substr(0, parameter.find('_'));
      return fmt::format("{}_{:g}_Nm", part, candidate_.order);
    }
    return candidate_.effect == "torque_offset" ? parameter + "_Nm" : parameter;
  }

  PlannedColumn breakaway(double speed_rad_s) const {
    Coordinates low = start_;
    low[1] = 0.0;
    low[2] = candidate_.parameters[2].coordinate(speed_rad_s);
    Coordinates high = low;
    high[1] += step(1);
    return between("breakaway_over_coulomb_Nm",
                   fmt::format("at a Stribeck velocity of {:.3g} rad/s", speed_rad_s), low, high,
                   step(1));
  }

  /// Friction's level at one length: its stiffness grows along.
  PlannedColumn presliding(double length_rad) const {
    const auto at = [&](double level_Nm) {
      return Coordinates{level_Nm, candidate_.parameters[1].coordinate(level_Nm / length_rad)};
    };
    return between("coulomb_Nm", fmt::format("at a presliding length of {:.3g} rad", length_rad),
                   at(step(0)), at(2.0 * step(0)), step(0));
  }

  PlannedColumn difference(std::string parameter, std::size_t forward, std::size_t backward) const {
    Coordinates high = start_;
    high[forward] += 0.5 * step(forward);
    high[backward] -= 0.5 * step(forward);
    return between(std::move(parameter), "", start_, high, step(forward));
  }

  /// Of the whole effect with these values, beside none of its kind.
  PlannedColumn share(const std::vector<double>& values, std::string at) const {
    PlannedColumn made = column("share", std::move(at));
    std::erase_if(made.low.actuator.effects, [&](const actuator::Effect& each) {
      return each.kind->name == candidate_.effect;
    });
    Coordinates high;
    for (std::size_t k = 0; k < values.size(); ++k) {
      high.push_back(candidate_.parameters[k].coordinate(values[k]));
    }
    candidate_.apply(high, made.high);
    return made;
  }

  const actuator::Ranges& ranges_;
  const EffectCandidate& candidate_;
  const actuator::EffectKind* kind_;  ///< Null: no effect of the actuator.
  Coordinates start_;
  Hypothesis stated_;
};

}  // namespace

std::vector<PlannedColumn> planned_columns(const Bench& bench, const actuator::Ranges& ranges,
                                           const std::string& effect) {
  const std::optional<EffectCandidate> candidate = planned_candidate(bench, ranges, effect);
  if (!candidate) return {};
  return Columns(bench, ranges, *candidate).take();
}

const std::vector<std::string>& effects_with_a_name() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all = {"gravity_imbalance", "load_inertia_error", "load_mass_error",
                                    "channel_delay",     "torque_offset",      "current_offset",
                                    "velocity_mismatch"};
    for (const actuator::EffectKind* each : actuator::effect_library()) {
      all.emplace_back(each->name);
    }
    return all;
  }();
  return names;
}

Eigen::MatrixXd planned_rows(const Bench& bench, const Rows& rows,
                             const std::vector<PlannedColumn>& columns) {
  Eigen::MatrixXd values(rows.count(), static_cast<Eigen::Index>(columns.size()));
  for (Eigen::Index k = 0; k < values.cols(); ++k) {
    const PlannedColumn& column = columns[static_cast<std::size_t>(k)];
    values.col(k) = rows.values([&](const Signals& stretch) {
      std::vector<double> taken = torque_balance_Nm(bench, column.low, stretch);
      const std::vector<double> left = torque_balance_Nm(bench, column.high, stretch);
      for (std::size_t i = 0; i < taken.size(); ++i)
        taken[i] = (taken[i] - left[i]) / column.change;
      return taken;
    });
  }
  return values;
}

}  // namespace torquewright::identification
