// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "actuator/check/check.hpp"
#include "io/files/csv.hpp"

namespace torquewright::actuator {

/// A column that a check does not read, and the missing one that it may be meant as.
struct UnreadColumn {
  std::string column;
  std::string meant;  ///< Name of the missing column; empty: none is near.
};

/// Returns one note that names the columns, those that seem misspelt first; none where all are
/// read.
std::vector<Finding> unread_findings(std::vector<UnreadColumn> unread);

/// Returns a note for each column that is read in another unit than its own name ends in.
std::vector<Finding> unit_findings(std::span<const MappingText> stated);

/// Returns a note where lines before the names are left out, and where a row of units stands under
/// them.
std::vector<Finding> table_findings(const io::CsvReader& csv);

/// Returns all kinds of notes for a check of actuators. Columns of joints that are not checked
/// count as read where the file has their motion. None where the trajectory comes through a pipe,
/// which is read once. Requires what check() does.
std::vector<Finding> column_findings(const CheckRequest& request);

}  // namespace torquewright::actuator
