// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace torquewright::identification {

/// Unpacks what was compressed as "", "lz4" (frames) or "zstd" says, into `unpacked`, whose size
/// must be that. Returns what is wrong, as the end of a sentence; empty where nothing is.
std::string unpack(std::string_view compression, std::string_view packed, std::size_t size,
                   std::string& unpacked);

/// Most bytes of one chunk or message, unpacked.
inline constexpr std::size_t kMostUnpackedBytes = std::size_t{256} << 20;

}  // namespace torquewright::identification
