// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "actuator/trajectory/angle_unwrap.hpp"
#include "actuator/trajectory/clock.hpp"
#include "actuator/trajectory/columns.hpp"
#include "actuator/trajectory/slope_filter.hpp"
#include "io/files/csv.hpp"

namespace torquewright::actuator {

/// A window of time; rows outside of it are read but not used.
struct Window {
  double from_s = -std::numeric_limits<double>::infinity();
  double until_s = std::numeric_limits<double>::infinity();
};

/// Returns a sentence that a file, whose rows go from the first to the last time, has none in that
/// window.
std::string no_rows_within(const Window& window, double first_s, double last_s);

/// Places in a row, counted from kPlaces times the joint's index. What the file does not hold is 0;
/// the slope of the position is left for a SlopeFilter.
enum Place : std::size_t { kPositionAt, kVelocityAt, kTorqueAt, kSlopeAt, kPlaces };

/// Columns of one joint.
struct JointColumns {
  struct Source {
    std::size_t column;
    double factor;
  };
  std::optional<Source> position;
  std::optional<Source> velocity;
  std::optional<Source> torque;
};

/// Reads a trajectory from a CSV file, row by row.
class TrajectoryReader {
 public:
  /// Finds the columns of the joints: those that `mappings` say, then those with canonical headers.
  /// Throws io::SpecError: a mapped column or a joint that is not there (naming the nearest), two
  /// columns for one quantity, no time, a joint with neither position nor velocity.
  TrajectoryReader(const std::filesystem::path& file, const std::vector<ColumnMapping>& mappings,
                   const std::vector<std::string>& joints, const Window& window);

  const JointColumns& columns(std::size_t joint) const { return joints_[joint]; }

  /// How a joint's position was unwrapped, if the file keeps it within a turn.
  const AngleUnwrap& unwrap(std::size_t joint) const { return unwraps_[joint]; }

  const Clock& clock() const { return clock_; }

  /// Reads the next row inside the window; false at the end. Throws for what CsvReader throws for,
  /// where time repeats or runs backwards, and at the end of rows of which none lies in the window.
  bool next(Row& row);

  /// Whether any row was read, inside the window or not.
  bool has_read_rows() const { return previous_s_.has_value(); }
  const std::string& file() const { return csv_.file(); }
  double share_read() const { return csv_.share_read(); }
  std::string sha256() { return csv_.sha256(); }  ///< Hash of the file; at its end, once.

 private:
  void assign(const std::vector<ColumnMapping>& mappings, const std::vector<std::string>& joints);
  void require_complete(const std::vector<ColumnMapping>& found,
                        const std::vector<std::string>& joints) const;
  double read_time_s();

  io::CsvReader csv_;
  Window window_;
  std::optional<JointColumns::Source> time_;
  std::vector<JointColumns> joints_;
  std::vector<AngleUnwrap> unwraps_;
  Clock clock_;
  std::optional<double> first_s_;
  std::optional<double> previous_s_;
  bool has_found_row_ = false;  ///< A row inside the window was found.
  std::size_t previous_line_ = 0;
};

}  // namespace torquewright::actuator
