// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/files/line_reader.hpp"

namespace torquewright::io {

/// A table of numbers with a header line, row by row, in flat memory; of text, or as
/// table_bytes.hpp reads it. Cells are separated by what separates the header's most: commas,
/// semicolons or tabs (a first line sep=; says it too), else blanks where the row behind has as
/// many numbers; they may stand in double quotes. Without commas between them, decimals may have
/// commas; then all have. Lines that start with #, and empty lines at the end, are skipped; where
/// numbers begin behind one, it has the names. A separator at each line's end begins no column.
/// What a recorder wrote before the names is skipped (table_begin.hpp); names that are no UTF-8 are
/// Latin-1. Faults are SpecErrors.
class CsvReader {
 public:
  /// What a last line is that ends within the row, as that of a recorder that was stopped.
  enum class CutEnd { kRefused, kDropped };

  /// What a row of units under the header is for those who read the table.
  enum class UnitsRow { kRefused, kTaken };

  /// Reads the header. Throws for an empty file, names that stand twice and numbers in place of
  /// names.
  explicit CsvReader(const std::filesystem::path& file, CutEnd cut_end = CutEnd::kRefused,
                     UnitsRow units_row = UnitsRow::kRefused);

  /// Reads a table without a header line, whose columns have these names; rows begin at the first
  /// line.
  CsvReader(const std::filesystem::path& file, std::vector<std::string> names);

  const std::vector<std::string>& header() const { return header_; }
  /// The lines that start with # before the header, in order, as they stand; the first 1000.
  const std::vector<std::string>& comments() const { return comments_; }
  std::optional<std::size_t> find(std::string_view name) const;
  /// The units that stand under the header, by column; empty where no such row stands there, or it
  /// names none.
  const std::vector<std::string>& units() const { return units_; }
  /// How many lines before the names are not read (table_begin.hpp).
  std::size_t skipped_lines() const { return skipped_lines_; }
  /// How the table differs from a text of commas and points, in a sentence; empty if it does not.
  std::string dialect() const;

  /// Goes to the next row; false at the end. Throws for a row of another length than the header,
  /// the header standing again, and an empty line between rows.
  bool next();

  /// The number in a cell of the present row, columns from 0. Throws if it is none: empty, a word,
  /// NaN or infinite, too large, with a decimal comma.
  double number(std::size_t column) const;

  /// The same of a time, which may be a date with a clock's time too (2026-11-28T18:00:00.5Z): then
  /// in s since 1970.
  double time(std::size_t column) const;

  /// Whether number() would give one.
  bool is_number(std::size_t column) const;

  /// A cell of the present row as it stands, without quotes; valid until the next row.
  std::string_view text(std::size_t column) const { return cells_[column]; }

  /// The last line, if it was dropped; 0: it was not.
  std::size_t cut_line() const { return cut_line_; }

  /// Line of the present row in the file, from 1.
  std::size_t line() const { return line_; }
  const std::string& file() const { return lines_.file(); }
  std::string sha256() { return lines_.sha256(); }  ///< Of the file; at its end, once.
  double share_read() const { return lines_.share_read(); }

  /// Throws a SpecError at a cell of the present row, or at the row.
  [[noreturn]] void refuse(std::size_t column, const std::string& message) const;
  /// Refuses the cell where its value, in SI units, is greater than that in size.
  void require_within(std::size_t column, double value, double greatest) const;
  [[noreturn]] void refuse_row(const std::string& message) const;

 private:
  void find_separator(std::string_view header);
  void take_units(UnitsRow units_row);
  bool next_line(std::string_view& line);
  void split(std::string_view line);
  void add_cell(std::string_view cell);
  void check_line_ends(std::string_view first_line) const;
  void check_header() const;
  void check_row() const;
  std::string place() const;
  bool drops_cut_end();

  LineReader lines_;
  std::vector<std::string> header_;
  std::vector<std::string> comments_;
  std::vector<std::string_view> cells_;  ///< Of the present row, trimmed, without quotes.
  CutEnd cut_end_;
  char separator_ = ',';
  char decimal_mark_ = 0;  ///< As cells had it so far; 0: none had one.
  std::vector<std::string> units_;
  std::optional<std::string> read_ahead_;  ///< The line behind the header, where it is a row.
  std::string present_;                    ///< That line, once it is the present row.
  std::size_t line_ = 0, cut_line_ = 0;
  std::size_t skipped_lines_ = 0;  ///< Before the names.
  bool is_latin1_ = false;
  std::vector<std::string> unquoted_;  ///< What cells with quotes or decimal commas refer to.
};

}  // namespace torquewright::io
