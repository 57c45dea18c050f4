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

constexpr double kDifference = 1e-4;  ///< Of a parameter's size, between two hypotheses.

/// What is asked by name of waves is one of each, the typical one.
std::optional<EffectCandidate> planned_wave(const Bench& bench, double torque_Nm,
                                            const std::string& effect) {
  const actuator::EffectKind* kind = actuator::find_effect(effect);
  if (kind == nullptr || !kind->has_harmonics) return std::nullopt;
  const bool is_of_motor = kind->acts == actuator::Acts::kMotorSideTorque;
  const double per_turn = is_of_motor ? bench.actuator().motor.pole_pairs : 1.0;
  return wave_candidate(*kind, kind->typical_order * per_turn, false, torque_Nm);
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

  std::vector<PlannedColumn> take() const {
    if (kind_ == nullptr || kind_->probes == nullptr) return slopes();
    std::vector<double> steps;
    for (std::size_t k = 0; k < start_.size(); ++k) steps.push_back(step(k));
    std::vector<PlannedColumn> all;
    for (const actuator::Probe& probe : kind_->probes(ranges_, start_, steps)) {
      all.push_back(column_of(probe));
    }
    return all;
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

  /// Between the probe's two ends; without a lower one, beside none of its kind.
  PlannedColumn column_of(const actuator::Probe& probe) const {
    PlannedColumn made = column(probe.parameter, probe.at);
    if (probe.low.empty()) {
      std::erase_if(made.low.actuator.effects,
                    [&](const actuator::Effect& each) { return each.kind == kind_; });
    } else {
      candidate_.apply(coordinates(probe.low), made.low);
    }
    candidate_.apply(coordinates(probe.high), made.high);
    made.change = probe.change;
    return made;
  }

  Coordinates coordinates(const std::vector<double>& values) const {
    Coordinates all;
    for (std::size_t k = 0; k < values.size(); ++k) {
      all.push_back(candidate_.parameters[k].coordinate(values[k]));
    }
    return all;
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
