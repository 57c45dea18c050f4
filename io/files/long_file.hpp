// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>
#include <vector>

namespace torquewright::io {

struct FileContent;

/// Takes a text piece by piece.
using TextSink = std::function<void(std::string_view piece)>;
/// Gives a text that is too long to be held, the same each time.
using TextSource = std::function<void(const TextSink& sink)>;

/// Whether the file holds that text. Throws as read_file_bytes does.
bool holds(const std::filesystem::path& file, const TextSource& text);

/// Writes a long file and others as write_whole_files of atomic_file.hpp does: all or none.
void write_whole_files(const std::filesystem::path& file, const TextSource& text,
                       const std::vector<FileContent>& others);

}  // namespace torquewright::io
