// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace torquewright::report {

/// A word as a shell takes it: quoted where it holds more than letters, digits and a few signs.
std::string shell_word(const std::string& word);

}  // namespace torquewright::report
