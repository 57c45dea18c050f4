// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace torquewright::cli_test {

/// A file's name that holds all that a shell would take apart or replace.
inline const std::string kAwkwardName = "it's $5 \"a\" `b` *.json";

/// The words that /bin/sh makes of the rest of the line of `text` that begins with `start`, the
/// name of the program not among them. Throws where there is no such line.
std::vector<std::string> suggested_words(const std::string& text, const std::string& start);

}  // namespace torquewright::cli_test
