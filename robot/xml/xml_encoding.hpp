// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace torquewright::hopper {

/// Why text is not read as its bytes are meant, in a sentence that begins with the line; nothing
/// where it is UTF-8, or ASCII whatever it says. `declared`: the encoding that the file states, or
/// "".
std::optional<std::string> encoding_objection(std::string_view text, std::string_view declared);

/// What <?xml ...?> says of the encoding; "" where it says nothing.
std::string declared_encoding(std::string_view declaration);

}  // namespace torquewright::hopper
