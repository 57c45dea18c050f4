// SPDX-License-Identifier: Apache-2.0
#include "identification/alignment.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <utility>

#include "identification/balance.hpp"
#include "identification/folds.hpp"
#include "identification/signal.hpp"

namespace torquewright::identification {
namespace {

constexpr double kBand_Hz = 15.0;
constexpr double kLeastDelay_s = 0.0015;

/// What is smooth and may be missing, without which its absence would be taken for a delay.
Dictionary rich_dictionary(const Bench& bench) {
  const auto balance = std::make_shared<Balance>(bench);
  Dictionary dictionary;
  const auto add = [&](const char* name, std::function<double(const Signals&, std::size_t)> value) {
    dictionary.columns.push_back({name, [value](const Signals& signals, std::vector<double>& out) {
                                    for (std::size_t i = 0; i < out.size(); ++i)
                                      out[i] = value(signals, i);
                                  }});
  };
  add("coulomb", [balance](const Signals& s, std::size_t i) { return -s.at[i].direction; });
  add("viscous", [balance](const Signals& s, std::size_t i) { return -s.at[i].speed_rad_s; });
  add("drag", [balance](const Signals& s, std::size_t i) {
    return -s.at[i].speed_rad_s * std::abs(s.at[i].speed_rad_s);
  });
  add("load", [balance](const Signals& s, std::size_t i) {
    return -std::abs(s.at[i].load_torque_Nm) * s.at[i].direction;
  });
  add("torque constant",
      [balance](const Signals& s, std::size_t i) { return balance->driven_Nm(s, i); });
  add("inertia",
      [balance](const Signals& s, std::size_t i) { return -s.at[i].acceleration_rad_s2; });
  add("gravity sine",
      [](const Signals& s, std::size_t i) { return std::sin(s.at[i].output_angle_rad); });
  add("gravity cosine",
      [](const Signals& s, std::size_t i) { return std::cos(s.at[i].output_angle_rad); });
  add("offset", [](const Signals&, std::size_t) { return 1.0; });
  Variant all;
  for (std::size_t c = 0; c < dictionary.columns.size(); ++c) {
    all.coefficients.push_back({{{c, 1.0}}, -1e300, 1e300});
  }
  dictionary.variants.push_back(all);
  return dictionary;
}

class Aligner {
 public:
  Aligner(const Bench& bench, const std::vector<Signals>& signals,
          const std::vector<std::size_t>& fold_of_run)
      : balance_(bench),
        signals_(signals),
        fold_of_run_(fold_of_run),
        dictionary_(rich_dictionary(bench)) {}

  const Fit& fit_at(double delay_s) {
    const auto known = fits_.find(delay_s);
    if (known != fits_.end()) return known->second;
    const Gram& gram = grams_[delay_s] = gram_at(delay_s);
    if (fits_.empty()) keep_independent(gram);
    return fits_[delay_s] = Fitter(gram, dictionary_, folds(gram), {}).fit({0});
  }

  double loss(double delay_s) {
    const Fit& fit = fit_at(delay_s);
    return fit.is_valid ? fit.loss : INFINITY;
  }

  Gain gain(double delay_s) {
    const Fit with = fit_at(delay_s), without = fit_at(0.0);
    Gain gain;
    double square = 0.0;
    const Gram both = gram_of_both(delay_s);
    const std::vector<std::size_t> fold = folds(both);
    std::map<std::size_t, double> by_fold;
    for (std::size_t b = 0; b < fold.size(); ++b) {
      if (fold[b] == Fitter::kNoFold) continue;
      const double less = without.block_loss[b] - with.block_loss[b];
      const Eigen::VectorXd change = error(without, fold[b], 0) - error(with, fold[b], 1);
      const double rest = less - change.dot(both.blocks[b].product * change);
      gain.loss += less;
      by_fold[fold[b]] += less;
      square += rest * rest;
    }
    gain.error = std::sqrt(square);
    gain.t = gain.error > 0.0 ? gain.loss / gain.error : 0.0;
    gain.share = without.loss > 0.0 ? gain.loss / without.loss : 0.0;
    gain.folds = by_fold.size();
    for (const auto& [f, value] : by_fold) {
      gain.folds_better += value > 0.0;
      gain.folds_worse += value < 0.0;
    }
    return gain;
  }

  std::size_t blocks() { return grams_.begin()->second.blocks.size(); }

 private:
  std::vector<std::size_t> folds(const Gram& gram) const {
    return folds_of_blocks(fold_of_run_, gram).of_block;
  }

  std::vector<double> residual(const Signals& signals, double delay_s) const {
    std::vector<double> measured(signals.size());
    for (std::size_t i = 0; i < signals.size(); ++i) measured[i] = balance_.measured_Nm(signals, i);
    std::vector<double> residual = advanced(measured, delay_s, signals.step_s);
    for (std::size_t i = 0; i < signals.size(); ++i) {
      residual[i] -= balance_.predicted_Nm(signals, i);
      if (!balance_.is_sensor()) residual[i] = -residual[i];
    }
    return residual;
  }

  Gram gram_at(double delay_s) const {
    const Target target = [&](const Signals& signals) { return residual(signals, delay_s); };
    return build_gram(signals_, {}, dictionary_, target, {kBand_Hz, 1.5, 400});
  }

  /// The residual as logged as a column behind the others, the moved one as the target.
  Gram gram_of_both(double delay_s) const {
    Dictionary both = dictionary_;
    both.columns.push_back({"as logged", [&](const Signals& signals, std::vector<double>& out) {
                              out = residual(signals, 0.0);
                            }});
    const Target target = [&](const Signals& signals) { return residual(signals, delay_s); };
    return build_gram(signals_, {}, both, target, {kBand_Hz, 1.5, 400});
  }

  /// What a fit leaves over, without a fold, as weights of the columns of gram_of_both().
  /// `residual`: of the last two, which one it is the error of.
  Eigen::VectorXd error(const Fit& fit, std::size_t fold, Eigen::Index residual) const {
    const auto columns = static_cast<Eigen::Index>(dictionary_.columns.size());
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(columns + 2);
    for (std::size_t j = 0; j < fit.coefficients.size(); ++j) {
      for (const auto& term : fit.coefficients[j].terms) {
        weights[static_cast<Eigen::Index>(term.column)] -=
            term.weight * fit.left_out[fold][static_cast<Eigen::Index>(j)];
      }
    }
    weights[columns + residual] = 1.0;
    return weights;
  }

  /// Without excitation some columns vanish or coincide: they are left out, for every delay alike.
  void keep_independent(const Gram& gram) {
    std::vector<Coefficient>& kept = dictionary_.variants[0].coefficients;
    const std::vector<Coefficient> all = std::exchange(kept, {});
    for (const Coefficient& coefficient : all) {
      kept.push_back(coefficient);
      if (!Fitter(gram, dictionary_, folds(gram), {}).fit({0}).is_valid) kept.pop_back();
    }
  }

  Balance balance_;
  const std::vector<Signals>& signals_;
  const std::vector<std::size_t>& fold_of_run_;
  Dictionary dictionary_;
  std::map<double, Gram> grams_;
  std::map<double, Fit> fits_;
};

}  // namespace

std::optional<Delay> find_delay(const Bench& bench, const std::vector<Signals>& signals,
                                const std::vector<std::size_t>& fold_of_run) {
  if (!bench.has_torque_balance() || signals.empty() || signals.front().step_s == 0.0) return {};
  Aligner aligner(bench, signals, fold_of_run);
  const std::vector<double> grid = {-0.15, -0.12,  -0.09, -0.07, -0.05, -0.035, -0.02,
                                    -0.01, -0.005, 0.0,   0.005, 0.01,  0.02,   0.035,
                                    0.05,  0.07,   0.09,  0.12,  0.15};
  std::size_t best = 9;
  if (!std::isfinite(aligner.loss(0.0))) return {};  // First: it chooses the columns.
  for (std::size_t k = 0; k < grid.size(); ++k) {
    if (aligner.loss(grid[k]) < aligner.loss(grid[best])) best = k;
  }
  if (best == 0 || best + 1 == grid.size()) return {};
  double low = grid[best - 1], middle = grid[best], high = grid[best + 1];
  for (int round = 0; round < 8; ++round) {
    const double left = 0.5 * (low + middle), right = 0.5 * (middle + high);
    if (aligner.loss(left) < aligner.loss(middle)) {
      high = middle;
      middle = left;
    } else if (aligner.loss(right) < aligner.loss(middle)) {
      low = middle;
      middle = right;
    } else {
      low = left;
      high = right;
    }
  }
  // The parabola through the last three: its vertex, and the width in which the loss rises by its
  // own standard error per degree of freedom.
  const double fl = aligner.loss(low), fm = aligner.loss(middle), fh = aligner.loss(high);
  const double bend =
      ((fh - fm) / (high - middle) - (fm - fl) / (middle - low)) / (0.5 * (high - low)) / 2.0;
  Delay delay;
  delay.delay_s = middle;
  const double variance = fm / static_cast<double>(std::max<std::size_t>(1, aligner.blocks()));
  delay.error_s = bend > 0.0 ? std::sqrt(variance / bend) : 0.0;
  delay.gain = aligner.gain(middle);
  if (std::abs(middle) < kLeastDelay_s || delay.gain.t < 3.0 || delay.gain.share < 0.08) return {};
  const bool measured_is_late = middle > 0.0;
  if (bench.load_side == LoadSide::kSensor) {
    delay.channel = measured_is_late ? bench.load_channel : bench.drive_channel;
  } else {
    delay.channel = measured_is_late  ? bench.drive_channel
                    : bench.is_linear ? Quantity::kLinearPosition
                                      : Quantity::kOutputPosition;
  }
  delay.delay_s = std::abs(middle);
  return delay;
}

}  // namespace torquewright::identification
