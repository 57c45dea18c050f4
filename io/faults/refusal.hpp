// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace torquewright::io {

/// Throws SpecError: one fault of a file (or of an option of the command line) as a whole.
[[noreturn]] void refuse(const std::string& file, const std::string& message);

/// Throws SpecError: a file that cannot be opened or read, and why, by its errno.
[[noreturn]] void refuse_unreadable(const std::string& file, int error);

/// Throws SpecError: that output cannot be written, and why.
[[noreturn]] void refuse_output(const std::filesystem::path& file, const std::string& why);

}  // namespace torquewright::io
