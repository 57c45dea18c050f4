// SPDX-License-Identifier: Apache-2.0
#include "identification/selection/comparison.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::identification {
namespace {

constexpr double kMostBlockCorrelation = 0.9;

/// Correlation of neighbours of one fold, at least none.
double block_correlation(const std::vector<double>& noise, const std::vector<std::size_t>& folds) {
  double products = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < noise.size(); ++i) {
    squares += noise[i] * noise[i];
    if (i > 0 && folds[i] == folds[i - 1]) products += noise[i] * noise[i - 1];
  }
  return squares > 0.0 ? std::clamp(products / squares, 0.0, kMostBlockCorrelation) : 0.0;
}

/// The normal distribution's quantile, by bisection of its closed form.
double normal_quantile(double beyond) {
  double low = 0.0, high = 40.0;
  for (int k = 0; k < 200; ++k) {
    const double middle = 0.5 * (low + high);
    (0.5 * std::erfc(middle / std::sqrt(2.0)) > beyond ? low : high) = middle;
  }
  return low;
}

}  // namespace

Comparison compare(const Rows& rows, const ModelFit& less, const ModelFit& more) {
  Comparison result;
  std::vector<double> noise, of_fold(rows.folds(), 0.0);
  std::vector<std::size_t> folds;
  double square = 0.0, changed = 0.0, count = 0.0;
  for (std::size_t b = 0; b < rows.blocks().size(); ++b) {
    const Rows::Block& block = rows.blocks()[b];
    if (block.is_held_out()) {
      result.held_out_gain += less.unseen[b] - more.unseen[b];
      continue;
    }
    const auto part = [&](const Eigen::VectorXd& values) {
      return values.segment(block.begin, block.count);
    };
    const double change = (part(less.residual) - part(more.residual)).squaredNorm() -
                          (part(less.noise) - part(more.noise)).squaredNorm();
    const double gain = less.unseen[b] - more.unseen[b];
    noise.push_back(less.sums[b].loss - more.sums[b].loss - change);
    folds.push_back(block.fold);
    square += noise.back() * noise.back();
    result.gain += gain;
    of_fold[block.fold] += gain;
    changed += change;
    count += static_cast<double>(block.count);
  }
  const double correlation = block_correlation(noise, folds);
  result.error = std::sqrt(square * (1.0 + correlation) / (1.0 - correlation));
  result.t = result.error > 0.0 ? result.gain / result.error : 0.0;
  result.change_rms = std::sqrt(std::max(0.0, changed) / std::max(1.0, count));
  result.parts = of_fold.size();
  for (const double gain : of_fold) result.parts_better += gain > 0.0;
  return result;
}

double threshold_t(double chance, std::size_t trials, std::size_t blocks) {
  const double z = normal_quantile(chance / static_cast<double>(std::max<std::size_t>(1, trials)));
  const double freedom = static_cast<double>(std::max<std::size_t>(4, blocks));
  const double z3 = z * z * z, z5 = z3 * z * z;
  return z + (z3 + z) / (4.0 * freedom) +
         (5.0 * z5 + 16.0 * z3 + 3.0 * z) / (96.0 * freedom * freedom);
}

}  // namespace torquewright::identification
