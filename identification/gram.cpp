// SPDX-License-Identifier: Apache-2.0
#include "identification/gram.hpp"

#include <algorithm>
#include <cmath>

#include "identification/signal.hpp"

namespace torquewright::identification {
namespace {

constexpr double kRatePerCutoff = 4.0;  ///< Samples are thinned to this times the cut-off.
constexpr double kShortestBlock_s = 0.5;
constexpr double kBlocksOfShortLog = 24.0;
constexpr double kLeastAboveNoise = 6.0;  ///< Power of a column over that of its noise.

/// Samples whose neighbourhood, as far as the filter reaches, is usable.
std::vector<std::size_t> rows_of(const Signals& signals, const BandOptions& options) {
  const std::size_t n = signals.size();
  std::size_t factor = 1, reach = 0;
  if (signals.step_s > 0.0) {
    const double rate_Hz = 1.0 / signals.step_s;
    factor = std::max<std::size_t>(
        1, static_cast<std::size_t>(std::floor(rate_Hz / (kRatePerCutoff * options.cutoff_Hz))));
    reach = static_cast<std::size_t>(std::round(0.3 * rate_Hz / options.cutoff_Hz));
  }
  std::vector<std::size_t> bad_until(n + 1, 0);  // Prefix counts of unusable samples.
  for (std::size_t i = 0; i < n; ++i) bad_until[i + 1] = bad_until[i] + (signals.usable[i] == 0);
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < n; i += factor) {
    const std::size_t from = i > reach ? i - reach : 0, until = std::min(n, i + reach + 1);
    if (bad_until[until] == bad_until[from]) rows.push_back(i);
  }
  return rows;
}

void write_column(std::vector<double>& values, const Signals& signals, const BandOptions& options,
                  const std::vector<std::size_t>& rows, Eigen::Ref<Eigen::VectorXd> out) {
  if (signals.step_s > 0.0) LowPass(options.cutoff_Hz, 1.0 / signals.step_s).apply(values);
  for (std::size_t k = 0; k < rows.size(); ++k) out[static_cast<Eigen::Index>(k)] = values[rows[k]];
}

std::vector<const Column*> pointers(const Dictionary& dictionary) {
  std::vector<const Column*> columns;
  for (const Column& column : dictionary.columns) columns.push_back(&column);
  return columns;
}

/// Time of a block: the option's; longer for a long log, shorter for a short one, so that a spread
/// can be estimated.
double block_length_s(const std::vector<Signals>& signals, const BandOptions& options) {
  double total_s = 0.0;
  for (const Signals& stretch : signals) {
    total_s += static_cast<double>(stretch.size()) * stretch.step_s;
  }
  const double short_s = std::max(kShortestBlock_s, total_s / kBlocksOfShortLog);
  return std::max(std::min(options.block_s, short_s),
                  total_s / static_cast<double>(options.most_blocks));
}

}  // namespace

BandRows band_rows(const Signals& signals, const std::vector<const Column*>& columns,
                   const Target& target, const BandOptions& options) {
  BandRows rows;
  rows.index = rows_of(signals, options);
  rows.values.resize(static_cast<Eigen::Index>(rows.index.size()),
                     static_cast<Eigen::Index>(columns.size()) + 1);
  std::vector<double> values(signals.size());
  for (std::size_t c = 0; c < columns.size(); ++c) {
    values.resize(signals.size());
    columns[c]->fill(signals, values);
    write_column(values, signals, options, rows.index,
                 rows.values.col(static_cast<Eigen::Index>(c)));
  }
  values = target(signals);
  write_column(values, signals, options, rows.index,
               rows.values.col(static_cast<Eigen::Index>(columns.size())));
  return rows;
}

Gram build_gram(const std::vector<Signals>& signals,
                const std::vector<std::vector<Signals>>& replicas, const Dictionary& dictionary,
                const Target& target, const BandOptions& options) {
  const std::vector<const Column*> columns = pointers(dictionary);
  const auto size = static_cast<Eigen::Index>(columns.size()) + 1;
  const double block_s = block_length_s(signals, options);
  Gram gram;
  gram.noise = Eigen::MatrixXd::Zero(size, size);
  Eigen::MatrixXd power = Eigen::MatrixXd::Zero(size, size);
  for (std::size_t s = 0; s < signals.size(); ++s) {
    const Signals& stretch = signals[s];
    const BandRows rows = band_rows(stretch, columns, target, options);
    std::vector<Eigen::MatrixXd> noises;
    for (const auto& replica : replicas) {
      BandRows other = band_rows(replica[s], columns, target, options);
      // Rests, and so the mask, may differ by a sample; the same rows count in both.
      Eigen::MatrixXd difference = Eigen::MatrixXd::Zero(rows.values.rows(), size);
      std::size_t at = 0;
      for (std::size_t k = 0; k < rows.index.size(); ++k) {
        while (at < other.index.size() && other.index[at] < rows.index[k]) ++at;
        if (at < other.index.size() && other.index[at] == rows.index[k]) {
          difference.row(static_cast<Eigen::Index>(k)) =
              other.values.row(static_cast<Eigen::Index>(at)) -
              rows.values.row(static_cast<Eigen::Index>(k));
        }
      }
      noises.push_back(std::move(difference));
    }
    const double stretch_s = static_cast<double>(stretch.size()) * stretch.step_s;
    const std::size_t count =
        stretch.step_s > 0.0
            ? std::max<std::size_t>(1, static_cast<std::size_t>(std::round(stretch_s / block_s)))
            : 4;
    const double length = static_cast<double>(stretch.size()) / static_cast<double>(count);
    std::size_t begin = 0;
    for (std::size_t b = 0; b < count && begin < rows.index.size(); ++b) {
      std::size_t end = begin;
      while (end < rows.index.size() &&
             (b + 1 == count ||
              static_cast<double>(rows.index[end]) < static_cast<double>(b + 1) * length)) {
        ++end;
      }
      if (end == begin) continue;
      const auto first = static_cast<Eigen::Index>(begin),
                 many = static_cast<Eigen::Index>(end - begin);
      Block block;
      block.run = stretch.run;
      block.samples = static_cast<double>(end - begin);
      const auto part = rows.values.middleRows(first, many);
      block.product = Eigen::MatrixXd::Zero(size, size);
      block.product.selfadjointView<Eigen::Lower>().rankUpdate(part.transpose());
      Eigen::MatrixXd noise = Eigen::MatrixXd::Zero(size, size);
      for (const Eigen::MatrixXd& difference : noises) {
        noise.selfadjointView<Eigen::Lower>().rankUpdate(
            difference.middleRows(first, many).transpose(),
            1.0 / static_cast<double>(noises.size()));
      }
      noise = noise.selfadjointView<Eigen::Lower>();
      block.product = block.product.selfadjointView<Eigen::Lower>();
      power += block.product;
      gram.noise += noise;
      block.product -= noise;
      gram.samples += block.samples;
      gram.blocks.push_back(std::move(block));
      begin = end;
    }
  }
  for (Eigen::Index c = 0; c < size; ++c) {
    gram.is_usable.push_back(power(c, c) > 0.0 &&
                             power(c, c) >= kLeastAboveNoise * gram.noise(c, c));
  }
  return gram;
}

}  // namespace torquewright::identification
