// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace torquewright::report {

/// A text as JSON that may stand inside an HTML element: in ASCII, without what HTML reads as the
/// begin of something; U+2028 becomes an escape as well.
std::string json_in_page(const std::string& text);

}  // namespace torquewright::report
