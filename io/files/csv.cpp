// SPDX-License-Identifier: Apache-2.0
#include "io/files/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "io/faults/spec_error.hpp"
#include "io/files/table_begin.hpp"
#include "io/text/cell_number.hpp"
#include "io/text/iso_time.hpp"
#include "io/text/one_line.hpp"
#include "io/text/units.hpp"
#include "io/text/utf8.hpp"

namespace torquewright::io {
namespace {

constexpr std::size_t kMostColumns = 10000;
constexpr std::size_t kMostComments = 1000;  // that are kept, before the header
constexpr std::size_t kLongestCell = 40;

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

/// How often a character stands in a line outside of quotes.
std::size_t count_outside_quotes(std::string_view line, char what) {
  std::size_t count = 0;
  bool is_quoted = false;
  for (const char each : line) {
    if (each == '"') is_quoted = !is_quoted;
    count += !is_quoted && each == what;
  }
  return count;
}

/// Whether nothing stands behind a line's last separator.
bool ends_with_separator(std::string_view line, char separator) {
  const std::size_t last = line.find_last_not_of(' ');
  return last != std::string_view::npos && line[last] == separator;
}

/// Runs of letters that are no blanks.
std::size_t words_in(std::string_view line) {
  std::size_t count = 0;
  bool is_in_word = false;
  for (const char each : line) {
    const bool is_blank = each == ' ' || each == '\t';
    count += !is_blank && !is_in_word;
    is_in_word = !is_blank;
  }
  return count;
}

std::vector<std::string_view> cells_between_blanks(std::string_view line) {
  std::vector<std::string_view> cells;
  for (line = trimmed(line); !line.empty();) {
    const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
    cells.push_back(line.substr(0, end));
    line = trimmed(line.substr(end));
  }
  return cells;
}

/// A row of numbers between blanks, or one of them.
bool is_numbers_between_blanks(std::string_view line) {
  const std::vector<std::string_view> cells = cells_between_blanks(line);
  return std::all_of(cells.begin(), cells.end(),
                     [](std::string_view cell) { return number_of(cell).has_value(); });
}

/// The names that a comment before a table of numbers holds, as NumPy writes them; empty: the
/// table's first line is not one of numbers, or has another number of columns.
std::string names_in_comment(const std::vector<std::string>& comments, std::string_view first) {
  if (comments.empty()) return "";
  const std::size_t begin = comments.back().find_first_not_of("# \t");
  if (begin == std::string::npos) return "";
  const std::string names = comments.back().substr(begin);
  for (const char separator : {',', ';', '\t'}) {
    const std::size_t count = count_outside_quotes(first, separator);
    if (count == 0) continue;
    const std::string_view cell = trimmed(first.substr(0, first.find(separator)));
    const bool is_row = number_of(cell) || (separator != ',' && !with_point(cell).empty());
    return is_row && count_outside_quotes(names, separator) == count ? names : "";
  }
  const bool is_row = is_numbers_between_blanks(first);
  return is_row && words_in(names) == words_in(first) ? names : "";
}

/// "rad/s" of "[rad/s]" or "(rad/s)".
std::string_view without_brackets(std::string_view text) {
  const bool has_brackets = (text.starts_with('[') && text.ends_with(']')) ||
                            (text.starts_with('(') && text.ends_with(')'));
  return has_brackets && text.size() > 1 ? trimmed(text.substr(1, text.size() - 2)) : text;
}

constexpr std::size_t kLinesBeforeTable = 100;

/// The separator of a spreadsheet's first line, "sep=;"; 0 of other lines.
char separator_stated_by(std::string_view line) {
  const std::string_view text = trimmed(line);
  const bool is_one = text.size() == 5 && text.starts_with("sep=") &&
                      std::string_view(",;\t").find(text[4]) != std::string_view::npos;
  return is_one ? text[4] : '\0';
}

/// Comments may stand between rows too, as a recorder writes what it was told.
bool next_behind_comments(LineReader& lines, std::string_view& line) {
  while (lines.next(line)) {
    if (!line.starts_with('#')) return true;
  }
  return false;
}

struct Separator {
  char letter;
  const char* name;
};
constexpr Separator kSeparators[] = {
    {',', "commas"}, {';', "semicolons"}, {'\t', "tabs"}, {'|', "upright lines"}};

std::string names_between(std::size_t count, char separator) {
  if (count == 1) return "one name";
  for (const Separator& one : kSeparators) {
    if (one.letter == separator) return fmt::format("{} names between {}", count, one.name);
  }
  return fmt::format("{} names", count);
}

/// What is wrong with a header whose rows have another separator, so that it names columns that
/// nobody has; empty: nothing.
std::string other_separator(const std::vector<std::string>& header, char separator,
                            std::string_view behind) {
  const std::size_t names = header.size();
  const std::size_t words = names == 1 ? words_in(header.front()) : 0;
  if (separator == ',' && words > 2 && count_outside_quotes(behind, ',') + 1 == words) {
    return fmt::format(
        "the header has {0} names between blanks, the line behind it has {0} between commas; one "
        "table has one separator, commas, semicolons, tabs or blanks",
        words);
  }
  if (separator == ' ' || count_outside_quotes(behind, separator) > 0) return "";
  for (const Separator& other : kSeparators) {
    const std::size_t count = count_outside_quotes(behind, other.letter);
    const bool may_be_decimal = other.letter == ',' && count == 1 && names == 1;
    if (other.letter == separator || count == 0 || may_be_decimal) continue;
    return fmt::format(
        "the header has {}, the line behind it has {} between {}; one table has one separator, "
        "commas, semicolons, tabs or blanks",
        names_between(names, separator), count + 1, other.name);
  }
  return "";
}

std::string in_quotes(std::string_view text) {
  if (text.size() <= kLongestCell) return fmt::format("\"{}\"", text);
  return fmt::format("\"{}...\"", text.substr(0, kLongestCell));
}

}  // namespace

CsvReader::CsvReader(const std::filesystem::path& file, CutEnd cut_end, UnitsRow units_row)
    : lines_(file), cut_end_(cut_end) {
  skipped_lines_ = lines_before_table(lines_.file());
  std::string_view line;
  do {
    if (!lines_.next(line)) {
      throw SpecError({{lines_.file(), "", "is empty; the first line must name the columns"}});
    }
    if (line.starts_with('#') && comments_.size() < kMostComments) comments_.emplace_back(line);
  } while (lines_.line_number() <= skipped_lines_ || line.starts_with('#') ||
           trimmed(line).empty() || separator_stated_by(line) != 0);
  line_ = lines_.line_number();
  check_line_ends(line);
  std::string header = names_in_comment(comments_, line);
  if (!header.empty()) read_ahead_.emplace(line);
  if (header.empty()) header = line;
  is_latin1_ = first_that_is_no_utf8(header) != std::string_view::npos;
  if (is_latin1_) header = utf8_of_latin1(header);
  std::string_view behind;  // By it blanks are known to separate.
  if (!read_ahead_ && next_behind_comments(lines_, behind)) read_ahead_.emplace(behind);
  find_separator(header);
  split(header);
  header_.assign(cells_.begin(), cells_.end());
  const bool ends = read_ahead_ && ends_with_separator(*read_ahead_, separator_);
  if (header_.size() > 1 && header_.back().empty() && ends) header_.pop_back();
  check_header();
  if (read_ahead_ && !trimmed(*read_ahead_).empty()) take_units(units_row);
}

void CsvReader::find_separator(std::string_view header) {
  std::size_t most = count_outside_quotes(header, separator_);
  for (const char other : {';', '\t'}) {
    const std::size_t count = count_outside_quotes(header, other);
    if (count > most) separator_ = other;
    most = std::max(most, count);
  }
  const bool has_blanks = most == 0 && words_in(header) > 1 && header.find('"') == header.npos;
  if (has_blanks && read_ahead_ && words_in(*read_ahead_) == words_in(header) &&
      is_numbers_between_blanks(*read_ahead_)) {
    separator_ = ' ';
  }
}

/// The line behind the header is one of units if no cell is a number and half of them or more are
/// units.
void CsvReader::take_units(UnitsRow units_row) {
  const std::string fault = other_separator(header_, separator_, *read_ahead_);
  if (!fault.empty()) refuse_row(fault);
  line_ = lines_.line_number();
  split(*read_ahead_);
  std::size_t known = 0;
  std::vector<std::string> units;
  for (const std::string_view cell : cells_) {
    if (number_of(cell)) return;
    const std::string_view unit = without_brackets(cell);
    const bool is_utf8 = first_that_is_no_utf8(unit) == std::string_view::npos;
    const bool is_none = unit == "-" || unit == "--" || unit == "n/a";
    units.push_back(is_none ? "" : is_utf8 ? std::string(unit) : utf8_of_latin1(unit));
    known += find_unit(units.back()).has_value();
  }
  if (cells_.size() != header_.size() || 2 * known < cells_.size()) return;
  if (units_row == UnitsRow::kRefused) {
    refuse_row("is a row of units, and units are stated elsewhere here; delete the line");
  }
  units_ = std::move(units);
  read_ahead_.reset();
}

bool CsvReader::next_line(std::string_view& line) {
  if (!read_ahead_) return next_behind_comments(lines_, line);
  present_ = std::move(*read_ahead_);
  read_ahead_.reset();
  line = present_;
  return true;
}

std::string CsvReader::dialect() const {
  std::vector<std::string> parts;
  if (!lines_.form().empty()) parts.push_back(lines_.form());
  if (skipped_lines_ > 0) {
    parts.push_back(
        fmt::format("the names stand in line {}, what a recorder wrote before is "
                    "left out",
                    skipped_lines_ + 1));
  }
  if (is_latin1_) parts.emplace_back("its names are read as Latin-1");
  if (separator_ != ',') {
    parts.push_back(fmt::format("columns are separated by {}{}",
                                separator_ == ';'   ? "semicolons"
                                : separator_ == ' ' ? "blanks"
                                                    : "tabs",
                                decimal_mark_ == ',' ? ", decimals are commas" : ""));
  }
  return fmt::format("{}", fmt::join(parts, "; "));
}

CsvReader::CsvReader(const std::filesystem::path& file, std::vector<std::string> names)
    : lines_(file), header_(std::move(names)), cut_end_(CutEnd::kRefused) {}

std::optional<std::size_t> CsvReader::find(std::string_view name) const {
  const auto found = std::find(header_.begin(), header_.end(), name);
  if (found == header_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - header_.begin());
}

/// What spreadsheets write that is no table of numbers yet, and what to do about it.
void CsvReader::check_line_ends(std::string_view first_line) const {
  if (first_line.find('\r') != std::string_view::npos) {
    refuse_row("its lines end with carriage returns alone; convert it: tr '\\r' '\\n'");
  }
  if (trimmed(first_line).substr(0, 4) == "sep=") {
    refuse_row(
        fmt::format("{} is a spreadsheet's line about separators; columns may be separated by "
                    "commas, semicolons or tabs",
                    in_quotes(trimmed(first_line))));
  }
}

void CsvReader::check_header() const {
  std::set<std::string_view> seen;
  for (std::size_t column = 0; column < header_.size(); ++column) {
    const std::string& name = header_[column];
    if (const auto found = unprintable_in(name)) {
      refuse(column, fmt::format("the name {} holds {}; must be one line of text", in_quotes(name),
                                 *found));
    }
    if (number_of(name)) {
      refuse(column, fmt::format("{} is a number; the first line must name the columns", name));
    }
    if (!name.empty() && !seen.insert(name).second) {
      refuse(column, fmt::format("the name {} stands twice in the header", in_quotes(name)));
    }
  }
}

bool CsvReader::next() {
  std::string_view line;
  if (!next_line(line)) return false;
  line_ = lines_.line_number();
  if (!trimmed(line).empty()) {
    split(line);
    if (cut_end_ == CutEnd::kDropped && cells_.size() < header_.size() && drops_cut_end()) {
      return false;
    }
    check_row();
    return true;
  }
  const std::size_t empty_line = lines_.line_number();
  while (next_behind_comments(lines_, line)) {
    if (trimmed(line).empty()) continue;
    throw SpecError({{file(), "", fmt::format("line {}: empty, between rows", empty_line)}});
  }
  return false;
}

/// Nothing but empty lines may follow. The cells are then those of the dropped line.
bool CsvReader::drops_cut_end() {
  std::string_view line;
  const std::vector<std::string> short_row(cells_.begin(), cells_.end());
  while (next_behind_comments(lines_, line)) {
    if (trimmed(line).empty()) continue;
    cells_.assign(short_row.begin(), short_row.end());
    check_row();
  }
  cut_line_ = line_;
  return true;
}

void CsvReader::check_row() const {
  if (cells_.size() == header_.size()) {
    if (!number_of(cells_.front()) && std::equal(cells_.begin(), cells_.end(), header_.begin())) {
      refuse_row("the header stands here again; one file holds one table");
    }
    return;
  }
  std::string message = fmt::format("has {} cell{}, the header has {}", cells_.size(),
                                    cells_.size() == 1 ? "" : "s", header_.size());
  if (const auto begin = line_ <= kLinesBeforeTable ? find_table_begin(file()) : std::nullopt) {
    refuse_row(
        fmt::format("{}; the table seems to begin with line {} ({}), and the lines before are not "
                    "part of it: tail -n "
                    "+{} {} > table.csv",
                    message, begin->line, begin->names, begin->line, file()));
  }
  const bool has_points = std::any_of(cells_.begin(), cells_.end(), [](std::string_view cell) {
    return cell.find('.') != std::string_view::npos;
  });
  if (separator_ == ',' && cells_.size() > header_.size() && cells_.size() <= 2 * header_.size() &&
      !has_points) {
    message += "; decimal commas? write 1.5, not 1,5, or separate by semicolons";
  }
  const char* others = separator_ == ',' ? ";\t" : separator_ == ';' ? ",\t" : ";,";
  const bool is_separated_otherwise =
      cells_.size() < header_.size() &&
      std::any_of(cells_.begin(), cells_.end(), [others](std::string_view cell) {
        return cell.find_first_of(others) != std::string_view::npos;
      });
  if (is_separated_otherwise) {
    message += "; separated otherwise than the header? one table has one separator";
  }
  refuse_row(message);
}

double CsvReader::number(std::size_t column) const {
  const std::string_view text = cells_[column];
  const std::optional<double> value = number_of(text);
  if (value && std::isfinite(*value)) return *value;
  if (text.empty()) refuse(column, "empty, must be a number");
  if (value) refuse(column, fmt::format("{} is not a finite number", in_quotes(text)));
  if (!with_point(text).empty()) {
    refuse(column, fmt::format("{} has a decimal comma; write 1.5, not 1,5", in_quotes(text)));
  }
  refuse(column, fmt::format("{} is not a number", in_quotes(text)));
}

double CsvReader::time(std::size_t column) const {
  const std::optional<double> since_1970_s = seconds_of_iso_time(cells_[column]);
  return since_1970_s ? *since_1970_s : number(column);
}

bool CsvReader::is_number(std::size_t column) const {
  const std::optional<double> value = number_of(cells_[column]);
  return value && std::isfinite(*value);
}

void CsvReader::refuse(std::size_t column, const std::string& message) const {
  const std::string name =
      column < header_.size() && !header_[column].empty() ? " (" + header_[column] + ")" : "";
  throw SpecError(
      {{file(), "", fmt::format("{}, column {}{}: {}", place(), column + 1, name, message)}});
}

void CsvReader::require_within(std::size_t column, double value, double greatest) const {
  if (std::abs(value) <= greatest) return;
  refuse(column, fmt::format("too large in SI units, in which {:.4g} is the most; is its unit the "
                             "one that is stated?",
                             greatest));
}

void CsvReader::refuse_row(const std::string& message) const {
  throw SpecError({{file(), "", fmt::format("{}: {}", place(), message)}});
}

/// Arrays have rows, and no line of names before them.
std::string CsvReader::place() const {
  return lines_.has_lines() ? fmt::format("line {}", line()) : fmt::format("row {}", line() - 1);
}

void CsvReader::split(std::string_view line) {
  cells_.clear();
  unquoted_.clear();
  if (separator_ == ' ') {
    unquoted_.reserve(words_in(line));
    for (const std::string_view cell : cells_between_blanks(line)) add_cell(cell);
    if (cells_.size() <= kMostColumns) return;
    refuse_row(fmt::format("more than the allowed {} columns", kMostColumns));
  }
  const auto needs_own = [](char each) { return each == '"' || each == ','; };
  unquoted_.reserve(static_cast<std::size_t>(std::count_if(line.begin(), line.end(), needs_own)));
  std::size_t place = 0;
  while (true) {
    if (cells_.size() == kMostColumns) {
      refuse_row(fmt::format("more than the allowed {} columns", kMostColumns));
    }
    while (place < line.size() && line[place] == ' ') ++place;
    std::size_t end = place;
    if (place < line.size() && line[place] == '"') {
      // A quote within quotes is doubled.
      std::string& cell = unquoted_.emplace_back();
      for (end = place + 1; end < line.size(); ++end) {
        if (line[end] == '"' && !(end + 1 < line.size() && line[end + 1] == '"')) break;
        if (line[end] == '"') ++end;
        cell += line[end];
      }
      if (end == line.size()) {
        refuse(cells_.size(),
               "a quote opens here and does not close in this line; a cell must be one line");
      }
      const std::size_t closed = end + 1;
      end = std::min(line.find(separator_, closed), line.size());
      if (!trimmed(line.substr(closed, end - closed)).empty()) {
        refuse(cells_.size(), "text stands behind the closing quote");
      }
      add_cell(trimmed(cell));
    } else {
      end = std::min(line.find(separator_, place), line.size());
      add_cell(trimmed(line.substr(place, end - place)));
    }
    if (end == line.size()) break;
    place = end + 1;
  }
  // LabVIEW's last column has cells where somebody wrote a comment.
  const bool has_no_comment = cells_.size() + 1 == header_.size() && header_.back() == "Comment";
  if (has_no_comment) cells_.emplace_back();
  // A separator at the end of each row begins no cell.
  const bool is_ended = cells_.size() == header_.size() + 1 && cells_.back().empty();
  if (is_ended && !header_.empty()) cells_.pop_back();
}

/// Where commas do not separate, one in a number is its decimal point.
void CsvReader::add_cell(std::string_view cell) {
  if (separator_ == ',') return cells_.push_back(cell);
  std::string pointed = with_point(cell);
  const bool has_point = pointed.empty() && cell.find('.') != cell.npos && number_of(cell);
  if (has_point || !pointed.empty()) {
    const char mark = has_point ? '.' : ',';
    if (decimal_mark_ != 0 && decimal_mark_ != mark) {
      refuse(cells_.size(),
             fmt::format("{} has a decimal {}, and cells before it have {}", in_quotes(cell),
                         has_point ? "point" : "comma", has_point ? "commas" : "points"));
    }
    decimal_mark_ = mark;
  }
  if (pointed.empty()) return cells_.push_back(cell);
  cells_.push_back(unquoted_.emplace_back(std::move(pointed)));
}

}  // namespace torquewright::io
