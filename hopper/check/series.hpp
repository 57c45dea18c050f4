// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/check/hopper_check.hpp"

namespace torquewright::hopper {

/// A column of a series: its header, unit included, and one value for each sample, NaN where there
/// is none.
struct SeriesColumn {
  std::string header;
  Eigen::VectorXd values;
};

/// All that a check computed, by time; docs/checks.md lists the columns.
using Series = std::vector<SeriesColumn>;

/// Whether currents, voltages and distances to the regions are wanted too: they cost as much as the
/// check of all drives.
enum class SeriesDetail { kMotion, kDrives };

Series series_of(const Robot& robot, const Motion& motion, const CheckOptions& options,
                 const HopperReport& report, SeriesDetail detail);

/// Writes the series as CSV; an empty cell where a value is NaN or infinite.
std::string series_csv(const Series& series);

/// Finds the column of that header; null where there is none.
const Eigen::VectorXd* find_column(const Series& series, const std::string& header);

}  // namespace torquewright::hopper
