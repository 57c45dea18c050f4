// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace torquewright::io {

/// Returns what a file is whose first bytes are those of a format that holds tables but is no text
/// (archives, pickles, recordings, databases), and the line that makes a CSV file of it, FILE
/// standing for its name; empty for any other.
std::string foreign_format(std::string_view first_bytes);

}  // namespace torquewright::io
