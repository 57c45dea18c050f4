// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "identification/recordings/recording.hpp"

namespace torquewright::identification {

/// Whether the file begins as a database of SQLite.
bool begins_as_sqlite(std::string_view first_bytes);

/// Opens a bag of ROS 2 as rosbag2's plugin sqlite3 writes it (tables `topics` and `messages`), its
/// messages plain or each compressed by zstd; in the order of the recorder's times. Throws
/// io::SpecError for a database without these tables.
std::unique_ptr<Recording> open_sqlite_bag(const std::filesystem::path& file);

}  // namespace torquewright::identification
