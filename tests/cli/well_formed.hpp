// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace torquewright::cli_test {

/// What keeps a text from being well-formed XML below its prolog (every element closed in its turn,
/// attributes quoted, no id twice); empty: nothing.
std::string fault_in(std::string_view text);

}  // namespace torquewright::cli_test
