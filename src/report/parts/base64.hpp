// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace torquewright::report {

/// RFC 4648, with the padding.
std::string base64(std::string_view bytes);

}  // namespace torquewright::report
