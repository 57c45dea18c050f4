// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace torquewright::io {

/// The files that a document names under the keys of specs/schema that hold names of files, as they
/// would be found: relative to the document, and, as results name what they have read, relative to
/// the current folder. They need not be there. None where the text is no JSON.
std::vector<std::filesystem::path> files_named_in(std::string_view text,
                                                  const std::filesystem::path& document);

}  // namespace torquewright::io
