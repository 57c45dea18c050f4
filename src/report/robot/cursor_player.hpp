// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "hopper/check/series.hpp"
#include "src/report/robot/shown_violations.hpp"

namespace torquewright::report {

/// What the track under the slider shows.
struct Track {
  double from_s = 0.0;
  double until_s = 0.0;
  const std::vector<ShownViolation>& violations;
  std::vector<Interval> flights = {};
  std::vector<double> impacts_s = {};
};

/// The controls of the time cursor: buttons, and the slider over its track. Hidden until the page's
/// script runs.
std::string cursor_player(const Track& track);

/// A column's value at the cursor; red where the column `bad` is not zero. That may be empty.
struct ShownValue {
  std::string column;
  std::string bad = "";
};
struct DriveValues {
  std::vector<std::string> headings;  ///< Of the values, with their units.
  struct Row {
    std::string drive;
    std::vector<ShownValue> values;  ///< As many as there are headings.
  };
  std::vector<Row> rows;
};
struct Quantity {
  std::string column;
  std::string words;
};

/// What stands at the cursor: drive by drive, and quantities that the series has; hidden like the
/// player.
std::string cursor_values(const hopper::Series& series, const DriveValues& drives,
                          const std::vector<Quantity>& quantities);

}  // namespace torquewright::report
