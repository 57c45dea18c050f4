// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace torquewright::io {

/// The number of a descriptor that this process holds, where the path names one: /dev/stdout,
/// /dev/stderr, /dev/fd/N, /proc/self/fd/N. What stands behind it is written into from where it
/// is, as by the shell's `>>`, be it a file, a pipe or a device.
std::optional<int> named_descriptor(const std::filesystem::path& file);

/// "standard output" or "standard error", where that leads into the file at this path: replaced,
/// the file would lose what is said there.
std::optional<std::string> stream_into(const std::filesystem::path& file);

/// Throws SpecError where the path names a descriptor that is not open for writing.
void require_open(const std::filesystem::path& file);

/// Seconds for which a named pipe's reader is waited for.
inline constexpr int kReaderPatience_s = 5;

/// Writes into a pipe, a device or a named descriptor, which cannot be replaced. Throws SpecError
/// where it fails, or where nobody opens a named pipe for reading within kReaderPatience_s.
void write_into(const std::filesystem::path& file, std::string_view content);

/// Writes all of it: 0, or the errno of what failed.
int write_all(int descriptor, std::string_view content);

}  // namespace torquewright::io
