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
constexpr std::size_t kBlocksOfMap = 4;   ///< Of each of its stretches.
constexpr double kFullBlock = 1.25;       ///< Times the length: pieces fill a block up to here.
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
    if (i < signals.core_begin || i >= signals.core_end) continue;
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
double block_length_s(double total_s, const BandOptions& options) {
  const double short_s = std::max(kShortestBlock_s, total_s / kBlocksOfShortLog);
  return std::max(std::min(options.block_s, short_s),
                  total_s / static_cast<double>(options.most_blocks));
}

/// What noise added once more changes in each row. Rests, and so the mask, may differ by a sample;
/// the same rows count in both.
Eigen::MatrixXd difference_of(const BandRows& other, const BandRows& rows) {
  Eigen::MatrixXd difference = Eigen::MatrixXd::Zero(rows.values.rows(), rows.values.cols());
  std::size_t at = 0;
  for (std::size_t k = 0; k < rows.index.size(); ++k) {
    while (at < other.index.size() && other.index[at] < rows.index[k]) ++at;
    if (at < other.index.size() && other.index[at] == rows.index[k]) {
      difference.row(static_cast<Eigen::Index>(k)) =
          other.values.row(static_cast<Eigen::Index>(at)) -
          rows.values.row(static_cast<Eigen::Index>(k));
    }
  }
  return difference;
}

/// Blocks of a stretch.
std::size_t block_count(const Signals& stretch, double block_s) {
  if (!(stretch.step_s > 0.0)) return kBlocksOfMap;
  const double stretch_s = static_cast<double>(stretch.core_size()) * stretch.step_s;
  return std::max<std::size_t>(1, static_cast<std::size_t>(std::round(stretch_s / block_s)));
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

GramBuilder::GramBuilder(const Dictionary& dictionary, const Target& target,
                         const BandOptions& options, double total_s)
    : columns_(pointers(dictionary)),
      target_(target),
      options_(options),
      block_s_(block_length_s(total_s, options)) {
  const auto size = static_cast<Eigen::Index>(columns_.size()) + 1;
  gram_.noise = Eigen::MatrixXd::Zero(size, size);
  power_ = Eigen::MatrixXd::Zero(size, size);
}

void GramBuilder::add(const Signals& stretch, const std::vector<const Signals*>& replicas) {
  const BandRows rows = band_rows(stretch, columns_, target_, options_);
  Differences noises;
  for (const Signals* replica : replicas) {
    noises.push_back(difference_of(band_rows(*replica, columns_, target_, options_), rows));
  }
  const std::size_t count = block_count(stretch, block_s_);
  const double core_s = static_cast<double>(stretch.core_size()) * stretch.step_s;
  const bool joins = stretch.shares_block && count == 1 && !gram_.blocks.empty() && open_s_ > 0.0 &&
                     open_s_ + core_s <= kFullBlock * block_s_;
  open_s_ = count > 1 ? 0.0 : core_s + (joins ? open_s_ : 0.0);
  const double length = static_cast<double>(stretch.core_size()) / static_cast<double>(count);
  std::size_t begin = 0;
  for (std::size_t b = 0; b < count && begin < rows.index.size(); ++b) {
    std::size_t end = begin;
    while (end < rows.index.size() &&
           (b + 1 == count || static_cast<double>(rows.index[end] - stretch.core_begin) <
                                  static_cast<double>(b + 1) * length)) {
      ++end;
    }
    if (end == begin) continue;
    add_block(stretch, rows, noises, static_cast<Eigen::Index>(begin),
              static_cast<Eigen::Index>(end - begin), joins);
    begin = end;
  }
}

void GramBuilder::add_block(const Signals& stretch, const BandRows& rows, const Differences& noises,
                            Eigen::Index first, Eigen::Index many, bool joins) {
  const Eigen::Index size = gram_.noise.rows();
  Block block;
  block.run = stretch.run;
  block.samples = static_cast<double>(many);
  block.product = Eigen::MatrixXd::Zero(size, size);
  block.product.selfadjointView<Eigen::Lower>().rankUpdate(
      rows.values.middleRows(first, many).transpose());
  Eigen::MatrixXd noise = Eigen::MatrixXd::Zero(size, size);
  for (const Eigen::MatrixXd& difference : noises) {
    noise.selfadjointView<Eigen::Lower>().rankUpdate(difference.middleRows(first, many).transpose(),
                                                     1.0 / static_cast<double>(noises.size()));
  }
  noise = noise.selfadjointView<Eigen::Lower>();
  block.product = block.product.selfadjointView<Eigen::Lower>();
  power_ += block.product;
  gram_.noise += noise;
  block.product -= noise;
  gram_.samples += block.samples;
  if (joins) {
    gram_.blocks.back().samples += block.samples;
    gram_.blocks.back().product += block.product;
  } else {
    gram_.blocks.push_back(std::move(block));
  }
}

Gram GramBuilder::finish() {
  for (Eigen::Index c = 0; c < gram_.noise.rows(); ++c) {
    gram_.is_usable.push_back(power_(c, c) > 0.0 &&
                              power_(c, c) >= kLeastAboveNoise * gram_.noise(c, c));
  }
  return std::move(gram_);
}

Gram build_gram(const std::vector<Signals>& signals,
                const std::vector<std::vector<Signals>>& replicas, const Dictionary& dictionary,
                const Target& target, const BandOptions& options) {
  double total_s = 0.0;
  for (const Signals& stretch : signals) {
    total_s += static_cast<double>(stretch.core_size()) * stretch.step_s;
  }
  GramBuilder builder(dictionary, target, options, total_s);
  for (std::size_t s = 0; s < signals.size(); ++s) {
    std::vector<const Signals*> noisy;
    for (const auto& replica : replicas) noisy.push_back(&replica[s]);
    builder.add(signals[s], noisy);
  }
  return builder.finish();
}

}  // namespace torquewright::identification
