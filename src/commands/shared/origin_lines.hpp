// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/documents/document.hpp"

namespace torquewright::cli {

/// What heads a file that is no document of ours: the tool, the command, and what was read.
std::vector<std::string> origin_of(std::string_view command,
                                   std::span<const io::Document> documents);

}  // namespace torquewright::cli
