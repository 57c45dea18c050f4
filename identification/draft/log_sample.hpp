// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace torquewright::identification {

/// The first rows of a log as they stand.
struct LogSample {
  std::vector<std::string> names;  ///< The header's.
  std::vector<std::string> units;  ///< As they stand under the header; empty where none stand.
  /// Numbers by column; not a number where a cell holds none.
  std::vector<std::vector<double>> numbers;
  /// By column the rows, from 0, whose cell reads otherwise than that of the row before.
  std::vector<std::vector<std::size_t>> changes;
};

/// Reads the header of a CSV file and at most `most_rows` rows. Throws io::SpecError for a file
/// that is no table.
LogSample read_sample(const std::filesystem::path& file, std::size_t most_rows = 20000);

}  // namespace torquewright::identification
