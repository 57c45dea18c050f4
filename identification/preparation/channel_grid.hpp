// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "identification/preparation/preparation_options.hpp"

namespace torquewright::identification {

/// The raw channels of one joint in one stretch, brought to a uniform grid and filtered. Where the
/// recorder paused the grid goes on, over what a cubic makes of the channels, and is masked. In a
/// map without time the samples are taken as they are. Each read of a channel draws its added noise
/// anew, so the order of reads is part of what a seed means.
class ChannelGrid {
 public:
  /// Keeps references to all four. Requires at least two samples of ascending time, or a map.
  ChannelGrid(const Run& run, std::size_t joint, const PreparationOptions& options,
              std::mt19937_64& random);

  double step_s() const { return step_s_; }    ///< Step of the grid; 0 in a map.
  double start_s() const { return start_s_; }  ///< First time of the grid; 0 in a map.
  std::size_t count() const { return count_; }
  bool is_map() const { return is_map_; }
  /// 1: a row of the log there is masked, or the grid bridges a gap.
  const std::vector<std::uint8_t>& masked() const { return masked_; }
  /// First sample of the grid at or behind the time of a row of the log; `count()` behind the last.
  std::size_t sample_of(std::size_t row) const;
  bool has(Quantity quantity) const { return channels_.has(quantity); }

  /// Reads a channel that was logged, in its unit, on the grid and through the low-pass.
  std::vector<double> read(Quantity quantity);

  /// Reads a logged channel on the grid without the low-pass.
  std::vector<double> read_unfiltered(Quantity quantity);
  std::vector<double> filtered(std::vector<double> values) const;

  /// Reads a channel, or returns a constant where it was not logged.
  std::vector<double> read_or(Quantity quantity, double otherwise);

  /// Reads a channel; empty where it was not logged.
  std::vector<double> read_if_any(Quantity quantity);

 private:
  std::vector<std::uint8_t> masked_with_gaps(double usual_s) const;

  const Run& run_;
  const Channels& channels_;
  const PreparationOptions& options_;
  std::mt19937_64& random_;
  bool is_map_ = false;
  double step_s_ = 0.0, start_s_ = 0.0;
  std::size_t count_ = 0;
  bool is_bridged_ = false;
  std::vector<std::uint8_t> masked_;
};

}  // namespace torquewright::identification
