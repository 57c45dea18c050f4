// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace torquewright::io {

/// Insertions, deletions, substitutions and swaps of neighbours that turn one word into the other.
std::size_t edit_distance(std::string_view from, std::string_view to);

/// The known word with the fewest edits from `word`, the first of equals; none if every one is
/// further off than a third of the longer word's letters (and more than one edit).
std::optional<std::string> nearest(std::string_view word, std::span<const std::string> known);

}  // namespace torquewright::io
