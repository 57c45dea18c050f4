// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "identification/recordings/recording.hpp"

namespace torquewright::identification {

/// Whether the file begins as an MCAP file (https://mcap.dev/spec).
bool begins_as_mcap(std::string_view first_bytes);

/// Opens an MCAP file: chunks plain, or compressed by lz4 or zstd; record by record, in the order
/// of the file. Its index is not used, so that a file without its end is read as far as it goes.
std::unique_ptr<Recording> open_mcap(const std::filesystem::path& file);

}  // namespace torquewright::identification
