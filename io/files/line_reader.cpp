// SPDX-License-Identifier: Apache-2.0
#include "io/files/line_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "io/faults/refusal.hpp"
#include "io/files/foreign_format.hpp"
#include "io/files/table_bytes.hpp"

namespace torquewright::io {
namespace {

constexpr std::size_t kBufferBytes = std::size_t{1} << 18;
constexpr std::size_t kLooksAt = 256;  // bytes, for what the file is

}  // namespace

LineReader::LineReader(const std::filesystem::path& file)
    : file_(file.string()), bytes_(table_bytes(file)), buffer_(kBufferBytes) {}

/// Makes room behind the unread bytes and reads more; false at the end of the file.
bool LineReader::fill() {
  std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
  end_ -= begin_;
  begin_ = 0;
  if (end_ > kLongestLine) {
    refuse(file_, fmt::format("line {}: longer than the allowed 1 MiB; this is no table of numbers",
                              line_number_ + 1));
  }
  if (buffer_.size() - end_ < kBufferBytes) buffer_.resize(end_ + kBufferBytes);
  const std::size_t count = bytes_->read(buffer_.data() + end_, kBufferBytes);
  end_ += count;
  if (!is_begun_) refuse_foreign({buffer_.data(), std::min(end_, kLooksAt)});
  is_begun_ = true;
  return count > 0;
}

void LineReader::refuse_foreign(std::string_view first_bytes) const {
  const std::string what = foreign_format(first_bytes);
  if (!what.empty()) refuse(file_, "is not CSV but " + what);
}

bool LineReader::next(std::string_view& line) {
  std::size_t looked_at = begin_;
  while (true) {
    const char* from = buffer_.data() + looked_at;
    const auto* found = static_cast<const char*>(std::memchr(from, '\n', end_ - looked_at));
    if (found != nullptr) {
      const auto length = static_cast<std::size_t>(found - (buffer_.data() + begin_));
      ++line_number_;
      line = cleaned({buffer_.data() + begin_, length});
      begin_ += length + 1;
      return true;
    }
    const std::size_t unread = end_ - begin_;
    if (fill()) {
      looked_at = unread;
      continue;
    }
    if (unread == 0) return false;
    ++line_number_;
    line = cleaned({buffer_.data() + begin_, unread});
    begin_ = end_;
    return true;
  }
}

std::string_view LineReader::cleaned(std::string_view line) const {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (line_number_ == 1 && line.starts_with(kByteOrderMark)) line.remove_prefix(3);
  const bool is_utf16 = line.starts_with("\xFF\xFE") || line.starts_with("\xFE\xFF");
  if (is_utf16 || line.find('\0') != std::string_view::npos) {
    refuse(file_,
           fmt::format("line {}: holds bytes that are no text; save it as UTF-8", line_number_));
  }
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

}  // namespace torquewright::io
