// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "identification/dictionary.hpp"

namespace torquewright::identification {

/// The band in which residual and columns are compared, and how they are cut up.
struct BandOptions {
  double cutoff_Hz = 8.0;
  double block_s = 1.5;
  std::size_t most_blocks = 400;  ///< Longer blocks where there would be more.
};

/// One block of a run: sums of products of m columns and, last, the target, in the target's unit
/// squared (Nm at the output, V) per units of the coefficients.
struct Block {
  std::size_t run = 0;  ///< Index into Log::runs.
  double samples = 0.0;
  Eigen::MatrixXd product;  ///< ((m+1) x (m+1)) Less what the channels' noise contributes to it.
};

/// All that regression needs to know of a log, whatever its length.
/// docs/derivations/identification.md eq. (7) to (9).
struct Gram {
  std::vector<Block> blocks;
  Eigen::MatrixXd noise;        ///< ((m+1) x (m+1)) What it adds to the whole log's products.
  std::vector<bool> is_usable;  ///< By column: it stands out of its own noise.
  double samples = 0.0;
  Eigen::Index target() const { return noise.rows() - 1; }
};

/// A target's values, one for each sample of the signals.
using Target = std::function<std::vector<double>(const Signals&)>;

/// Signals in the band, thinned: n samples in rows, m columns of the dictionary, the target last.
/// Rows that are not usable are left out; `index` says which sample each row is.
struct BandRows {
  Eigen::MatrixXd values;          ///< (n x (m+1))
  std::vector<std::size_t> index;  ///< (n x 1)
};

/// Builds a Gram from one stretch after the other.
class GramBuilder {
 public:
  /// `total_s`: of all stretches. Keeps references to the dictionary and the target.
  GramBuilder(const Dictionary& dictionary, const Target& target, const BandOptions& options,
              double total_s);

  /// `replicas`: the same stretch with noise added, several times. Stretches shorter than a block
  /// that may share one do.
  void add(const Signals& stretch, const std::vector<const Signals*>& replicas);

  Gram finish();

 private:
  using Differences = std::vector<Eigen::MatrixXd>;  ///< By replica, (n x (m+1)).
  void add_block(const Signals& stretch, const BandRows& rows, const Differences& noises,
                 Eigen::Index first, Eigen::Index many, bool joins);

  std::vector<const Column*> columns_;
  const Target& target_;
  BandOptions options_;
  double block_s_;
  double open_s_ = 0.0;    ///< Of the last block, as far as pieces have filled it.
  Eigen::MatrixXd power_;  ///< ((m+1) x (m+1)) Sum of the products, noise and all.
  Gram gram_;
};

/// Of all stretches; `replicas`: one list for each replica.
Gram build_gram(const std::vector<Signals>& signals,
                const std::vector<std::vector<Signals>>& replicas, const Dictionary& dictionary,
                const Target& target, const BandOptions& options);

/// Of one stretch.
BandRows band_rows(const Signals& signals, const std::vector<const Column*>& columns,
                   const Target& target, const BandOptions& options);

}  // namespace torquewright::identification
