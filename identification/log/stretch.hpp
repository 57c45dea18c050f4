// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "identification/log/run.hpp"

namespace torquewright::identification {

/// A step longer than this many times the median of its stretch is a gap (docs/logs.md: jitter of
/// real logs stays below 2.2 medians).
constexpr double kGapFactor = 5.0;

/// A gap up to this does not cut: one period of 8 Hz, the band in which equations are judged, so
/// that either side of it holds what the motion does in the band. What lies in it is masked.
constexpr double kLongestBridge_s = 0.125;

/// A step in time so much longer than the run's others that what lay between is unknown.
struct Gap {
  double at_s = 0.0;  ///< Time of the sample before the gap.
  double length_s = 0.0;
  double median_s = 0.0;  ///< Median of the run's steps.
};

/// Median of the steps between times. Requires two or more.
double median_step_s(const std::vector<double>& time_s);

/// The gaps of runs that do not cut.
class Pauses {
 public:
  /// Adds the gaps of a run's stretch. Stretches of one run follow one another.
  void add(const Run& stretch);

  /// Says of each run that has any how many there are, and where the longest is.
  std::vector<std::string> sentences() const;

 private:
  struct OfRun {
    std::string run;
    std::size_t count = 0;
    Gap longest;
  };
  std::vector<OfRun> runs_;
};

/// A part of one run as it stands in a file, without a gap that is not bridged.
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
