// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace torquewright::io {

/// Throws SpecError where an option's values, NAME=VALUE, give a name twice: the last would win,
/// and nobody would know. `mark` stands behind the name.
void require_each_once(const std::string& option, const std::vector<std::string>& values,
                       char mark = '=');

}  // namespace torquewright::io
