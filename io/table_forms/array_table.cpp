// SPDX-License-Identifier: Apache-2.0
#include "io/table_forms/array_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <utility>

#include "io/faults/refusal.hpp"
#include "io/text/one_line.hpp"
#include "io/text/wording.hpp"

namespace torquewright::io {
namespace {

constexpr std::size_t kMostArrayColumns = 10000;

bool is_vector(const NamedArray& array) { return array.length <= 1 || array.width == 1; }

std::size_t rows_of(const std::vector<NamedArray>& arrays) {
  std::size_t of_vectors = 0, of_any = 0;
  for (const NamedArray& each : arrays) {
    if (!each.is_no_column.empty()) continue;
    if (is_vector(each)) of_vectors = std::max(of_vectors, each.length * each.width);
    of_any = std::max(of_any, each.length);
  }
  // A lone number beside matrices is no column of a table.
  return of_vectors > 1 ? of_vectors : of_any;
}

std::string size_of(const NamedArray& array) {
  if (array.length * array.width == 1) return "one number";
  return is_vector(array) ? fmt::format("{} numbers", array.length * array.width)
                          : fmt::format("{} x {} numbers", array.length, array.width);
}

/// In quotes, so that no letter of it means anything.
std::string in_double_quotes(const std::string& name) {
  std::string text = "\"";
  for (const char letter : name) {
    text += letter;
    if (letter == '"') text += letter;
  }
  return text + '"';
}

void require_one_line(const ArrayTable& table) {
  for (const std::string& name : table.names) {
    if (const auto found = unprintable_in(name)) {
      refuse(table.file,
             fmt::format("the name of an array holds {}; must be one line of text", *found));
    }
  }
}

}  // namespace

ArrayTable table_of_arrays(std::string file, std::string format,
                           const std::vector<NamedArray>& arrays, int first_number) {
  ArrayTable table{std::move(file), std::move(format), rows_of(arrays), {}, {}, ""};
  std::vector<std::string> others;
  for (std::size_t i = 0; i < arrays.size(); ++i) {
    const NamedArray& array = arrays[i];
    const bool lies_across = array.length != table.rows;
    const std::size_t count = lies_across ? array.length : array.width;
    if (!array.is_no_column.empty() || (lies_across && array.width != table.rows)) {
      others.push_back(fmt::format(
          "{} ({})", array.name, array.is_no_column.empty() ? size_of(array) : array.is_no_column));
      continue;
    }
    if (count > kMostArrayColumns - table.parts.size()) {
      refuse(table.file, fmt::format("has more than the allowed {} columns", kMostArrayColumns));
    }
    for (std::size_t column = 0; column < count; ++column) {
      table.parts.push_back({i, column, lies_across});
      table.names.push_back(
          count == 1
              ? array.name
              : fmt::format("{}_{}", array.name, column + static_cast<std::size_t>(first_number)));
    }
  }
  table.left_out = listed(others);
  if (table.parts.empty() || table.rows == 0) {
    refuse(table.file, fmt::format("is {} without an array of numbers{}", table.format,
                                   others.empty() ? "" : "; it holds " + table.left_out));
  }
  require_one_line(table);
  return table;
}

ArrayText::ArrayText(ArrayTable table, std::unique_ptr<ByteSource> bytes)
    : table_(std::move(table)), bytes_(std::move(bytes)) {
  for (const std::string& name : table_.names) {
    text_ += in_double_quotes(name);
    text_ += ',';
  }
  text_.back() = '\n';
}

std::size_t ArrayText::read(char* to, std::size_t most) {
  if (given_ == text_.size()) {
    text_.clear();
    given_ = 0;
    while (text_.size() < most && rows_made_ < table_.rows) append_row();
    if (text_.empty() && !is_at_end_) check_end();
    is_at_end_ = text_.empty();
  }
  const std::size_t count = std::min(most, text_.size() - given_);
  std::memcpy(to, text_.data() + given_, count);
  given_ += count;
  return count;
}

void ArrayText::append_row() {
  for (std::size_t column = 0; column < table_.parts.size(); ++column) {
    append_number(column, text_);
    text_ += ',';
  }
  text_.back() = '\n';
  ++rows_made_;
}

double ArrayText::share_read() const {
  return static_cast<double>(rows_made_) / static_cast<double>(table_.rows);
}

std::string ArrayText::sha256() {
  std::string chunk(std::size_t{1} << 16, '\0');
  while (bytes_->read(chunk.data(), chunk.size()) > 0) {
  }
  return bytes_->sha256();
}

std::string ArrayText::form() const {
  return table_.format + (table_.left_out.empty() ? "" : "; left out: " + table_.left_out);
}

}  // namespace torquewright::io
