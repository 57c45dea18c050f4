// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

namespace torquewright::cli {

/// The records of a library as a help text lists them: name and sentence of each by `form`.
template <typename Records>
std::string named_sentences(const Records& records, std::string_view form,
                            std::string_view between) {
  std::string text;
  for (const auto* record : records) {
    if (!text.empty()) text += between;
    text += fmt::format(fmt::runtime(form), record->name, record->sentence);
  }
  return text;
}

}  // namespace torquewright::cli
