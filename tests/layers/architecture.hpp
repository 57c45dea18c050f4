// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace torquewright::layers {

/// The part of docs/architecture.md that the table of layers and the sources themselves say: every
/// folder and room, what it may include, how many files on how many floors it has.
std::string architecture_tables(const std::filesystem::path& root);

/// The folders as a drawing, each above those that it may include.
std::string architecture_picture();

}  // namespace torquewright::layers
