// SPDX-License-Identifier: Apache-2.0
#include "identification/recordings/unpacked_chunk.hpp"

#include <fmt/format.h>
#include <lz4frame.h>
#include <zstd.h>

#include <algorithm>

namespace torquewright::identification {
namespace {

/// Bytes that came out; any other number than was promised is wrong.
std::size_t unpack_lz4(std::string_view packed, std::string& unpacked) {
  LZ4F_dctx* context = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&context, LZ4F_VERSION)) != 0) return 0;
  std::size_t made = 0;
  while (!packed.empty()) {
    std::size_t out = unpacked.size() - made, in = packed.size();
    const std::size_t more =
        LZ4F_decompress(context, unpacked.data() + made, &out, packed.data(), &in, nullptr);
    made += out;
    packed.remove_prefix(in);
    if (LZ4F_isError(more) != 0) made = unpacked.size() + 1;
    if (LZ4F_isError(more) != 0 || more == 0 || in + out == 0) break;
  }
  LZ4F_freeDecompressionContext(context);
  return packed.empty() ? made : unpacked.size() + 1;
}

}  // namespace

std::string unpack(std::string_view compression, std::string_view packed, std::size_t size,
                   std::string& unpacked) {
  if (compression != "" && compression != "lz4" && compression != "zstd") {
    return fmt::format("is compressed by \"{}\", which is not read; plain, lz4 and zstd are",
                       compression);
  }
  if (size > kMostUnpackedBytes) {
    return fmt::format("holds {} bytes, more than the allowed {}", size, kMostUnpackedBytes);
  }
  unpacked.resize(size);
  std::size_t made = packed.size();
  if (compression == "lz4") {
    made = unpack_lz4(packed, unpacked);
  } else if (compression == "zstd") {
    made = ZSTD_decompress(unpacked.data(), unpacked.size(), packed.data(), packed.size());
  } else if (packed.size() == size) {
    std::copy(packed.begin(), packed.end(), unpacked.begin());
  }
  return made == size ? "" : "is damaged: it does not unpack to the size that stands beside it";
}

}  // namespace torquewright::identification
