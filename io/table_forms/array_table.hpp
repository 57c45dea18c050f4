// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "io/table_forms/byte_source.hpp"

namespace torquewright::io {

/// An array of a file that holds several.
struct NamedArray {
  std::string name;
  std::size_t length = 0;    ///< Of its first dimension.
  std::size_t width = 1;     ///< Of its second; 1 for a vector.
  std::string is_no_column;  ///< Why it is none, as "text"; empty for numbers of two dimensions.
};

/// One table made of arrays. It has as many rows as the longest vector has numbers; without a
/// vector, as the longest array has rows.
struct ArrayTable {
  struct Part {
    std::size_t array = 0;   ///< Index of the array.
    std::size_t column = 0;  ///< Of the array; its row where the array lies across.
    bool lies_across = false;
  };
  std::string file;
  std::string format;  ///< "a NumPy archive".
  std::size_t rows = 0;
  std::vector<std::string> names;  ///< Of the columns, in order: q, or q_0, q_1 of one of several.
  std::vector<Part> parts;         ///< Where each column stands.
  std::string left_out;            ///< What is no column, and why; empty: nothing.
};

/// Makes the table; columns of one array are counted from `first_number`. Throws SpecError where no
/// array holds a column.
ArrayTable table_of_arrays(std::string file, std::string format,
                           const std::vector<NamedArray>& arrays, int first_number);

/// A table of arrays as the text of a table. Who derives prints the numbers.
class ArrayText : public ByteSource {
 public:
  /// `bytes` are the file's, for its digest.
  ArrayText(ArrayTable table, std::unique_ptr<ByteSource> bytes);

  std::size_t read(char* to, std::size_t most) override;
  double share_read() const override;
  std::string sha256() override;
  std::string form() const override;
  bool has_lines() const override { return false; }

 protected:
  /// Appends the next row's number of a column; columns come in order.
  virtual void append_number(std::size_t column, std::string& text) = 0;
  /// Is called behind the last row: all that the file says of its arrays has been read.
  virtual void check_end() {}
  const ArrayTable& table() const { return table_; }

 private:
  void append_row();

  ArrayTable table_;
  std::unique_ptr<ByteSource> bytes_;
  std::string text_;  ///< What was not given yet begins at given_.
  std::size_t given_ = 0, rows_made_ = 0;
  bool is_at_end_ = false;
};

}  // namespace torquewright::io
