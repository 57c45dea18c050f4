// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

#include "identification/log/run.hpp"

namespace torquewright::identification {

/// A step in time so much longer than the run's others that nothing is known of what lay between.
struct Gap {
  double at_s = 0.0;  ///< Time of the sample before it.
  double length_s = 0.0;
  double median_s = 0.0;  ///< Of the run's steps.
};

/// A part of one run as it stands in a file.
struct Stretch {
  Run run;                 ///< Its name as the file states it.
  std::size_t file = 0;    ///< Index.
  std::optional<Gap> gap;  ///< That cut it from the stretch before.
};

/// Samples of a run, of its time or, in a map, of its channels.
std::size_t sample_count(const Run& run);

/// The samples from `begin` to before `end`.
Run part_of(const Run& run, std::size_t begin, std::size_t end);

/// Takes the last rows off. Requires so many.
void drop_last(Run& run, std::size_t rows);

/// Adds the samples of a piece that follows. Requires the same channels.
void append(Run& run, const Run& piece);

/// Names the runs: as their files state them, and with the file's stem and a slash before it where
/// several files hold one of that name. Throws io::SpecError where that leaves two alike.
void give_names(std::vector<Stretch>& stretches, const std::vector<std::filesystem::path>& files);

}  // namespace torquewright::identification
