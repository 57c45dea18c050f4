// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>

#include "identification/recordings/recording.hpp"

namespace torquewright::identification {

/// Opens a recording: MCAP, or a database as ROS 2's bags are. Throws io::SpecError for any other
/// file.
std::unique_ptr<Recording> open_recording(const std::filesystem::path& file);

}  // namespace torquewright::identification
