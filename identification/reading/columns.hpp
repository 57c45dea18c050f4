// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "identification/rig/rig.hpp"
#include "io/files/csv.hpp"

namespace torquewright::identification {

/// The column of a file that holds a quantity: quantity = scale cell + offset.
struct Source {
  std::size_t column = 0;
  Quantity quantity = Quantity::kTime;
  double scale = 1.0;
  double offset = 0.0;
  /// Index into Rig::joints; empty: the column holds for all joints.
  std::optional<std::size_t> joint;
};

/// The columns of one file as the rig uses them.
struct Columns {
  std::optional<Source> time;
  std::optional<std::size_t> run;
  std::vector<Source> channels;
  std::vector<std::string> doubts;  ///< Of units, in sentences: what stands there says another.
};

/// Finds the rig's columns in a file. Throws io::SpecError with every column that the rig names and
/// the file lacks, and every one that the file has and the rig neither names nor ignores.
Columns find_columns(const io::CsvReader& csv, const Rig& rig);

}  // namespace torquewright::identification
