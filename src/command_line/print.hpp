// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace torquewright::command_line {

/// Puts the text on standard output. Throws io::SpecError where that does not take all of it: a
/// full disk may show as late as when the buffer is emptied.
void print(const std::string& text);

}  // namespace torquewright::command_line
