// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace torquewright::cli_test {

/// What keeps a text from being one that every program reads: bytes that are no UTF-8, control
/// characters but tab and line breaks, surrogates, U+FFFE, U+FFFF; empty: nothing.
std::string fault_of_characters_in(std::string_view text);

/// What keeps a text from being well-formed XML below its prolog (every element closed in its turn,
/// attributes quoted, no id twice, legal characters); empty: nothing. HTML's scripts are not looked
/// into.
std::string fault_in(std::string_view text);

}  // namespace torquewright::cli_test
