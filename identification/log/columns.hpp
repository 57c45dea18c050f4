// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "identification/rig/rig.hpp"
#include "io/files/csv.hpp"

namespace torquewright::identification {

/// Where a file keeps a quantity: quantity = scale cell + offset.
struct Source {
  std::size_t column = 0;
  Quantity quantity = Quantity::kTime;
  double scale = 1.0;
  double offset = 0.0;
  std::optional<std::size_t> joint;  ///< Index into Rig::joints; empty: all of them.
};

/// The columns of one file as the rig uses them.
struct Columns {
  std::optional<Source> time;
  std::optional<std::size_t> run;
  std::vector<Source> channels;
};

/// Throws io::SpecError with every column that the rig names and the file lacks, and every one that
/// the file has and the rig neither names nor ignores.
Columns find_columns(const io::CsvReader& csv, const Rig& rig);

}  // namespace torquewright::identification
