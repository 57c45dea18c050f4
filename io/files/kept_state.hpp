// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace torquewright::io {

/// The bytes of a file that the program itself wrote, to go on with: unlike an input it may be
/// replaced by an output of the same run (file_session.hpp). Throws SpecError where it is missing,
/// unreadable or larger than kMaxFileBytes.
std::string read_kept_state(const std::filesystem::path& file);

}  // namespace torquewright::io
