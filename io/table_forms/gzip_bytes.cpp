// SPDX-License-Identifier: Apache-2.0
#include "io/table_forms/gzip_bytes.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <new>
#include <utility>
#include <vector>

#include "io/faults/refusal.hpp"

namespace torquewright::io {
namespace {

constexpr std::size_t kCompressedChunk_bytes = std::size_t{1} << 16;
constexpr int kLargestWindowOfGzip = 15 + 16;  // zlib's: a window of 32 KiB, and gzip's header

class GzipBytes : public ByteSource {
 public:
  GzipBytes(std::unique_ptr<ByteSource> compressed, std::string file)
      : compressed_(std::move(compressed)), file_(std::move(file)), chunk_(kCompressedChunk_bytes) {
    if (inflateInit2(&stream_, kLargestWindowOfGzip) != Z_OK) throw std::bad_alloc();
  }
  ~GzipBytes() override { inflateEnd(&stream_); }
  GzipBytes(const GzipBytes&) = delete;
  GzipBytes& operator=(const GzipBytes&) = delete;

  std::size_t read(char* to, std::size_t most) override {
    stream_.next_out = reinterpret_cast<Bytef*>(to);
    stream_.avail_out = static_cast<uInt>(most);
    while (stream_.avail_out == most && has_input()) inflate_some();
    return most - stream_.avail_out;
  }
  double share_read() const override { return compressed_->share_read(); }
  std::string sha256() override { return compressed_->sha256(); }
  std::string form() const override { return "compressed by gzip"; }

 private:
  /// False at the end of the file, which must be that of a member.
  bool has_input() {
    if (stream_.avail_in > 0) return true;
    const std::size_t count = compressed_->read(chunk_.data(), chunk_.size());
    stream_.next_in = reinterpret_cast<Bytef*>(chunk_.data());
    stream_.avail_in = static_cast<uInt>(count);
    if (count == 0 && is_in_member_) {
      refuse(file_,
             "ends in the middle of what gzip compressed; what there is of it: zcat FILE > "
             "FILE.csv");
    }
    return count > 0;
  }

  void inflate_some() {
    is_in_member_ = true;
    const int result = inflate(&stream_, Z_NO_FLUSH);
    if (result == Z_MEM_ERROR) throw std::bad_alloc();
    if (result == Z_STREAM_END) {
      is_in_member_ = false;
      inflateReset(&stream_);
    } else if (result != Z_OK && result != Z_BUF_ERROR) {
      refuse(file_, fmt::format("is damaged: gzip's data do not fit their own description ({})",
                                stream_.msg != nullptr ? stream_.msg : "no reason known"));
    }
  }

  std::unique_ptr<ByteSource> compressed_;
  std::string file_;
  std::vector<char> chunk_;
  z_stream stream_{};
  bool is_in_member_ = false;
};

}  // namespace

bool begins_as_gzip(std::string_view first_bytes) { return first_bytes.starts_with("\x1f\x8b"); }

std::unique_ptr<ByteSource> gzip_bytes(std::unique_ptr<ByteSource> compressed, std::string file) {
  return std::make_unique<GzipBytes>(std::move(compressed), std::move(file));
}

}  // namespace torquewright::io
