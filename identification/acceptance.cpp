// SPDX-License-Identifier: Apache-2.0
#include "identification/acceptance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace torquewright::identification {
namespace {

/// Correlation of neighbours within folds, between 0 and 0.9.
double neighbour_correlation(const std::vector<double>& values,
                             const std::vector<std::size_t>& folds) {
  double products = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    squares += values[i] * values[i];
    if (i > 0 && folds[i] == folds[i - 1]) products += values[i] * values[i - 1];
  }
  return squares > 0.0 ? std::clamp(products / squares, 0.0, 0.9) : 0.0;
}

bool is_wave_of(const Variant& variant, const Variant& other) {
  return variant.order > 0.0 && other.effect == variant.effect &&
         other.proportional == variant.proportional;
}

}  // namespace

AcceptanceRules rules_for(const Dictionary& dictionary, const Members& without, const Members& with,
                          AcceptanceRules rules) {
  const auto is_there = [&](const Variant& added) {
    return std::any_of(without.begin(), without.end(), [&](std::size_t member) {
      return is_wave_of(added, dictionary.variants[member]);
    });
  };
  for (const std::size_t member : with) {
    const bool is_old = std::find(without.begin(), without.end(), member) != without.end();
    if (!is_old && !is_there(dictionary.variants[member])) return rules;
  }
  rules.least_gain = rules.least_harmonic;
  return rules;
}

Gain gain_of(const Fitter& fitter, const Fit& without, const Fit& with,
             const AcceptanceRules& rules) {
  Gain gain;
  gain.folds = fitter.fold_count();
  if (!without.is_valid || !with.is_valid) return gain;
  std::vector<double> noise;  // What of each block's gain its models' difference does not promise.
  std::vector<std::size_t> folds;
  std::vector<double> fold_gain(gain.folds, 0.0), fold_square(gain.folds, 0.0),
      fold_loss(gain.folds, 0.0);
  for (std::size_t b = 0; b < fitter.folds().size(); ++b) {
    const std::size_t fold = fitter.folds()[b];
    if (fold == Fitter::kNoFold) continue;
    const double less = without.block_loss[b] - with.block_loss[b];
    const double rest = less - fitter.difference(with, without, b);
    noise.push_back(rest);
    folds.push_back(fold);
    gain.loss += less;
    fold_gain[fold] += less;
    fold_loss[fold] += without.block_loss[b];
    fold_square[fold] += rest * rest;
  }
  const double correlation = neighbour_correlation(noise, folds);
  const double inflation = (1.0 + correlation) / (1.0 - correlation);
  double square = 0.0;
  for (std::size_t f = 0; f < gain.folds; ++f) {
    square += fold_square[f];
    const double error = std::sqrt(fold_square[f] * inflation);
    if (fold_gain[f] > rules.least_run_errors * error) ++gain.folds_better;
    if (-fold_gain[f] > rules.worse_run_errors * error &&
        -fold_gain[f] > rules.worse_run_share * std::abs(fold_loss[f])) {
      ++gain.folds_worse;
    }
  }
  gain.error = std::sqrt(square * inflation);
  gain.t = gain.error > 0.0 ? gain.loss / gain.error : 0.0;
  gain.share = without.loss > 0.0 ? gain.loss / without.loss : 0.0;
  return gain;
}

std::string objection(const Fit& with, const Gain& gain, const AcceptanceRules& rules) {
  if (!with.is_valid) {
    return "its parameters are not determined, or beyond what is physically possible";
  }
  if (gain.loss <= 0.0) return "it raises the error where it was not fitted";
  if (gain.t <= rules.least_t) {
    return fmt::format(
        "it lowers the error where it was not fitted by {:.1f} standard errors; more than {:g} are "
        "needed to exclude chance",
        gain.t, rules.least_t);
  }
  if (gain.share <= rules.least_gain) {
    return fmt::format(
        "it removes {:.1f} % of the squared error where it was not fitted; more than {:g} % are "
        "asked for",
        100.0 * gain.share, 100.0 * rules.least_gain);
  }
  const auto needed = std::max<std::size_t>(
      2,
      static_cast<std::size_t>(std::ceil(rules.least_run_share * static_cast<double>(gain.folds))));
  if (gain.folds_better < std::min(needed, gain.folds)) {
    return fmt::format("it helps in {} of {} runs; {} are needed", gain.folds_better, gain.folds,
                       needed);
  }
  const std::size_t allowed = gain.folds >= 6 ? 1 : 0;
  if (gain.folds_worse > allowed) {
    return fmt::format("it makes {} of {} runs worse", gain.folds_worse, gain.folds);
  }
  return "";
}

}  // namespace torquewright::identification
