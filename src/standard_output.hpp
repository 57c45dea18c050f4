// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace torquewright::cli {

/// Writes a command's result to stdout. Throws SpecError if not all of it gets there.
void print_result(const std::string& text);

/// The same to the file of -o, whole or not at all, where one was named.
void deliver_result(const std::string& text, const std::string& file);

}  // namespace torquewright::cli
