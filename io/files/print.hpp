// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace torquewright::io {

/// Puts the text on standard output. Throws SpecError where that does not take all of it (a
/// full disk may show as late as when the buffer is emptied), or is a file that was read.
void print(const std::string& text);

}  // namespace torquewright::io
