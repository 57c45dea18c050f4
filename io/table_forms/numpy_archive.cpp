// SPDX-License-Identifier: Apache-2.0
#include "io/table_forms/numpy_archive.hpp"

#include <fmt/format.h>
#include <minizip/unzip.h>

#include <algorithm>
#include <cstring>
#include <utility>
#include <vector>

#include "io/faults/refusal.hpp"
#include "io/table_forms/array_table.hpp"
#include "io/table_forms/npy_header.hpp"

namespace torquewright::io {
namespace {

using namespace std::string_view_literals;

constexpr std::size_t kChunkBytes = std::size_t{1} << 14;
constexpr std::size_t kLongestHeader = std::size_t{1} << 16;
constexpr std::size_t kLongestName = 1024;
constexpr std::string_view kMagic = "\x93NUMPY";
constexpr std::string_view kEnding = ".npy";

/// The bytes of one file of a zip archive, from its beginning. Each has the archive open for
/// itself, so that many can be read side by side.
class Member {
 public:
  Member(const std::string& file, const unz64_file_pos& place, std::string name)
      : file_(file), name_(std::move(name)), archive_(unzOpen64(file.c_str())) {
    unz64_file_pos at = place;
    if (archive_ == nullptr || unzGoToFilePos64(archive_, &at) != UNZ_OK ||
        unzOpenCurrentFile(archive_) != UNZ_OK) {
      close();
      refuse(file_, fmt::format("its array {} cannot be unpacked: another compression, or a "
                                "password",
                                name_));
    }
  }
  Member(Member&& other) noexcept
      : file_(std::move(other.file_)),
        name_(std::move(other.name_)),
        archive_(std::exchange(other.archive_, nullptr)),
        chunk_(std::move(other.chunk_)),
        given_(other.given_) {}
  Member(const Member&) = delete;
  Member& operator=(const Member&) = delete;
  Member& operator=(Member&&) = delete;
  ~Member() { close(); }

  /// The next bytes; valid until the next call.
  const char* take(std::size_t count) {
    if (chunk_.size() - given_ < count) refill(count);
    given_ += count;
    return chunk_.data() + given_ - count;
  }
  void skip(std::size_t count) {
    while (count > 0) {
      const std::size_t step = std::min(count, kChunkBytes);
      take(step);
      count -= step;
    }
  }
  /// Where all bytes were taken, they must have the sum that the archive states.
  void check_sum() {
    char more = 0;
    unzReadCurrentFile(archive_, &more, 1);
    if (unzCloseCurrentFile(archive_) != UNZ_CRCERROR) return;
    refuse(file_,
           fmt::format("is damaged: its array {} has not the sum that stands beside it", name_));
  }

 private:
  void close() {
    if (archive_ != nullptr) unzClose(archive_);
    archive_ = nullptr;
  }

  void refill(std::size_t count) {
    chunk_.erase(chunk_.begin(), chunk_.begin() + static_cast<std::ptrdiff_t>(given_));
    given_ = 0;
    std::size_t held = chunk_.size();
    const std::size_t wanted = std::max(count, kChunkBytes);
    chunk_.resize(wanted);
    while (held < count) {
      const int read =
          unzReadCurrentFile(archive_, chunk_.data() + held, static_cast<unsigned>(wanted - held));
      if (read <= 0) {
        refuse(file_, fmt::format("ends within its array {}, or is damaged there", name_));
      }
      held += static_cast<std::size_t>(read);
    }
    chunk_.resize(held);
  }

  std::string file_, name_;
  unzFile archive_;
  std::vector<char> chunk_;
  std::size_t given_ = 0;
};

struct Array {
  unz64_file_pos place{};
  std::string name;
  NpyHeader header;
  std::size_t begin = 0;  ///< Bytes before its first number.

  std::size_t length() const { return header.shape.empty() ? 1 : header.shape[0]; }
  std::size_t width() const { return header.shape.size() < 2 ? 1 : header.shape[1]; }
};

void read_header(const std::string& file, Array& array) {
  Member member(file, array.place, array.name);
  if (std::string_view(member.take(kMagic.size()), kMagic.size()) != kMagic) {
    array.header.is_no_number = "no array";
    return;
  }
  // Version 1 has two bytes for the header's length, the others have four.
  const std::size_t digits = member.take(2)[0] == 1 ? 2 : 4;
  const char* bytes = member.take(digits);
  std::size_t length = 0;
  for (std::size_t i = digits; i-- > 0;) {
    length = 256 * length + static_cast<unsigned char>(bytes[i]);
  }
  if (length > kLongestHeader) {
    array.header.is_no_number = "no array";
    return;
  }
  array.header = npy_header({member.take(length), length});
  array.begin = kMagic.size() + 2 + digits + length;
}

/// The arrays of an archive, in its order, by their headers.
std::vector<Array> arrays_of(const std::string& file) {
  const unzFile archive = unzOpen64(file.c_str());
  if (archive == nullptr) {
    refuse(file, "begins as a NumPy archive and has no list of its arrays at the end: it was cut");
  }
  std::vector<Array> arrays;
  for (int found = unzGoToFirstFile(archive); found == UNZ_OK; found = unzGoToNextFile(archive)) {
    char name[kLongestName] = "";
    Array& array = arrays.emplace_back();
    unzGetCurrentFileInfo64(archive, nullptr, name, sizeof name - 1, nullptr, 0, nullptr, 0);
    unzGetFilePos64(archive, &array.place);
    array.name = name;
    if (array.name.ends_with(kEnding)) array.name.resize(array.name.size() - kEnding.size());
  }
  unzClose(archive);
  for (Array& array : arrays) read_header(file, array);
  return arrays;
}

NamedArray described(const Array& array) {
  NamedArray named{array.name, array.length(), array.width(), array.header.is_no_number};
  if (array.header.shape.size() > 2) named.is_no_column = "of more than two dimensions";
  return named;
}

class NumpyArchive : public ArrayText {
 public:
  NumpyArchive(ArrayTable table, std::unique_ptr<ByteSource> bytes, std::vector<Array> arrays)
      : ArrayText(std::move(table), std::move(bytes)), arrays_(std::move(arrays)) {
    for (const ArrayTable::Part& part : this->table().parts) {
      const Array& array = arrays_[part.array];
      const bool shares = lies_by_rows(part) && part.column > 0;
      if (!shares) {
        members_.emplace_back(this->table().file, array.place, array.name);
        members_.back().skip(array.begin + bytes_before(part));
      }
      member_of_.push_back(members_.size() - 1);
    }
  }

 private:
  /// Whether the numbers of one row of the table stand side by side in the file.
  bool lies_by_rows(const ArrayTable::Part& part) const {
    return arrays_[part.array].header.is_by_column == part.lies_across;
  }
  std::size_t bytes_before(const ArrayTable::Part& part) const {
    return lies_by_rows(part) ? 0 : part.column * table().rows * arrays_[part.array].header.bytes;
  }

  void append_number(std::size_t column, std::string& text) override {
    const NpyHeader& header = arrays_[table().parts[column].array].header;
    io::append_number(header, members_[member_of_[column]].take(header.bytes), text);
  }

  void check_end() override {
    for (Member& member : members_) member.check_sum();
  }

  std::vector<Array> arrays_;
  std::vector<Member> members_;
  std::vector<std::size_t> member_of_;  ///< By the table's column.
};

}  // namespace

bool begins_as_numpy_archive(std::string_view first_bytes) {
  return first_bytes.starts_with("PK\x03\x04"sv) && first_bytes.find(kEnding) != std::string::npos;
}

std::unique_ptr<ByteSource> numpy_archive(std::unique_ptr<ByteSource> bytes,
                                          const std::string& file) {
  std::vector<Array> arrays = arrays_of(file);
  std::vector<NamedArray> named;
  for (const Array& array : arrays) named.push_back(described(array));
  return std::make_unique<NumpyArchive>(table_of_arrays(file, "a NumPy archive", named, 0),
                                        std::move(bytes), std::move(arrays));
}

}  // namespace torquewright::io
