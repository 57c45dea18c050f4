// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace torquewright::io {

/// Throws SpecError: one fault of a file (or of an option of the command line) as a whole.
[[noreturn]] void refuse(const std::string& file, const std::string& message);

/// Throws SpecError: a file that cannot be opened or read, and why, by its errno.
[[noreturn]] void refuse_unreadable(const std::string& file, int error);

}  // namespace torquewright::io
