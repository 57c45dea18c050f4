// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace torquewright::io {

/// Whether a name is as a pattern says, in which each "*" stands for any letters or none.
bool fits_pattern(std::string_view name, std::string_view pattern);

}  // namespace torquewright::io
