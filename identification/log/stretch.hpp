// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

#include "identification/log/run.hpp"

namespace torquewright::identification {

/// A step in time so much longer than the run's others that what lay between is unknown.
struct Gap {
  double at_s = 0.0;  ///< Time of the sample before the gap.
  double length_s = 0.0;
  double median_s = 0.0;  ///< Median of the run's steps.
};

/// A part of one run as it stands in a file, without a gap.
struct Stretch {
  Run run;                 ///< Samples; its name is as the file states it.
  std::size_t file = 0;    ///< Index of the file.
  std::optional<Gap> gap;  ///< The gap that cut it from the stretch before.
};

/// Number of samples of a run: of its time or, in a map, of its channels.
std::size_t sample_count(const Run& run);

/// Returns the samples from `begin` to before `end`.
Run part_of(const Run& run, std::size_t begin, std::size_t end);

/// Removes the last rows. Requires that there are so many.
void drop_last(Run& run, std::size_t rows);

/// Appends the samples of a piece that follows. Requires the same channels.
void append(Run& run, const Run& piece);

/// Names the runs as their files state them, with the file's stem and a slash in front where
/// several files hold one of that name. Throws io::SpecError where that leaves two alike.
void give_names(std::vector<Stretch>& stretches, const std::vector<std::filesystem::path>& files);

}  // namespace torquewright::identification
