// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace torquewright::fuzz {

/// Reads a document of kind `rig`.
void read_rig_document(const std::filesystem::path& file);

/// Reads a log with a rig that fits the corpus's log, and examines it against an actuator. What is
/// read must hang together: vectors of one length, finite, in time's order, all runs with a use.
void read_measured_log(const std::filesystem::path& file);

}  // namespace torquewright::fuzz
