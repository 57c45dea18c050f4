// SPDX-License-Identifier: Apache-2.0
#include "identification/imports/named_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <set>
#include <utility>

#include "io/faults/spec_error.hpp"
#include "io/files/csv.hpp"
#include "io/text/letter_case.hpp"
#include "io/text/one_line.hpp"
#include "io/text/wording.hpp"

namespace torquewright::identification::imports {
namespace {

void find_meanings(const io::CsvReader& csv,
                   const std::function<std::optional<Meaning>(const std::string&)>& meaning_of,
                   ImportedLog& log) {
  for (const std::string& name : csv.header()) {
    const std::optional<Meaning> meaning = meaning_of(name);
    if (!meaning) {
      log.ignore.push_back(name);
      continue;
    }
    for (const ColumnUse& use : log.columns) {
      if (use.quantity != meaning->quantity) continue;
      throw io::SpecError(
          {{csv.file(), "",
            fmt::format("the columns \"{}\" and \"{}\" are both {}; say --joint, or "
                        "leave one out",
                        use.column, name, name_of(use.quantity))}});
    }
    log.columns.push_back({name, meaning->quantity, meaning->scale, meaning->offset, ""});
  }
}

bool is_read(const ImportedLog& log, const std::string& column) {
  return std::any_of(log.columns.begin(), log.columns.end(),
                     [&](const ColumnUse& use) { return use.column == column; });
}

void require_meanings(const std::string& file, const ImportedLog& log) {
  const auto is_time = [](const ColumnUse& use) { return use.quantity == Quantity::kTime; };
  const bool has_time = std::any_of(log.columns.begin(), log.columns.end(), is_time);
  if (has_time && log.columns.size() > 1) return;
  throw io::SpecError(
      {{file, "",
        fmt::format("{} among its columns: {}; of another program's table `torquewright init rig "
                    "--from {}` drafts what the columns are",
                    has_time ? "nothing known but the time" : "no time", io::listed(log.header),
                    file)}});
}

/// What the cells of a column hold.
struct Cells {
  bool has_numbers = false;
  std::exception_ptr first_other;  ///< Refuses the first that is no finite number; none: none is.
};

/// Columns, from 0, that are read, but for the time.
std::vector<std::size_t> measured(const ImportedLog& log) {
  std::vector<std::size_t> found;
  for (const ColumnUse& use : log.columns) {
    const auto column = std::find(log.header.begin(), log.header.end(), use.column);
    if (use.quantity == Quantity::kTime) continue;
    found.push_back(static_cast<std::size_t>(column - log.header.begin()));
  }
  return found;
}

bool is_word(std::string_view cell) {
  const std::string small = io::in_small_letters(std::string(cell));
  return !small.empty() && small != "nan" && small != "-nan";
}

/// The cells as they are written. What is read may be missing, but is no word.
std::vector<std::string> cells_of(const io::CsvReader& csv, const ImportedLog& log,
                                  std::vector<Cells>& columns) {
  std::vector<std::string> row;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    row.emplace_back(csv.text(i));
    if (csv.is_number(i)) {
      columns[i].has_numbers = true;
      continue;
    }
    if (is_read(log, csv.header()[i]) && is_word(csv.text(i))) csv.number(i);
    if (columns[i].first_other) continue;
    try {
      csv.number(i);
    } catch (const io::SpecError&) {
      columns[i].first_other = std::current_exception();
    }
  }
  return row;
}

/// Columns, from 0, that stay behind: in which something stands that is no number. Of those that
/// are read, a sensor that is not there; one that is there at times is refused.
std::set<std::size_t> no_numbers_of(const std::vector<Cells>& columns, const ImportedLog& log) {
  std::set<std::size_t> no_numbers;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (!columns[i].first_other) continue;
    if (is_read(log, log.header[i]) && columns[i].has_numbers) {
      std::rethrow_exception(columns[i].first_other);
    }
    no_numbers.insert(i);
  }
  return no_numbers;
}

/// A log is a table of numbers: states, words and sensors that are not there stay behind.
void leave_out(const std::set<std::size_t>& no_numbers, ImportedLog& log) {
  std::vector<std::string> names;
  for (const std::size_t i : no_numbers) names.push_back(log.header[i]);
  if (names.empty()) return;
  const auto without = [&](std::vector<std::string>& list) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (!no_numbers.contains(i)) std::swap(list[kept++], list[i]);
    }
    list.resize(kept);
  };
  without(log.header);
  for (ImportedLog::Run& run : log.runs) {
    for (std::vector<std::string>& row : run.rows) without(row);
  }
  const auto is_left_out = [&](const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  std::erase_if(log.ignore, is_left_out);
  std::erase_if(log.columns, [&](const ColumnUse& use) { return is_left_out(use.column); });
  log.notes.push_back("left out, for not all that they hold are numbers: " + io::listed(names));
}

}  // namespace

ImportedLog read_named_columns(
    const ImportRequest& request,
    const std::function<std::optional<Meaning>(const std::string&)>& meaning_of) {
  ImportedLog log;
  std::vector<Cells> columns;
  std::size_t others_rows = 0;
  for (const std::filesystem::path& file : request.files) {
    io::CsvReader csv(file, io::CsvReader::CutEnd::kDropped);
    if (log.header.empty()) {
      log.header = csv.header();
      find_meanings(csv, meaning_of, log);
      require_meanings(csv.file(), log);
    } else if (csv.header() != log.header) {
      throw io::SpecError({{csv.file(), "", "has other columns than the file before it"}});
    }
    ImportedLog::Run run{io::stem_in_text(file), {}};
    columns.resize(log.header.size());
    const std::vector<std::size_t> read = measured(log);
    while (csv.next()) {
      // A row of a table of several topics that another topic wrote.
      if (std::all_of(read.begin(), read.end(), [&](auto i) { return csv.text(i).empty(); })) {
        ++others_rows;
      } else {
        run.rows.push_back(cells_of(csv, log, columns));
      }
    }
    log.runs.push_back(std::move(run));
  }
  leave_out(no_numbers_of(columns, log), log);
  require_meanings(request.files.front().string(), log);
  if (others_rows > 0) {
    log.notes.push_back(
        fmt::format("{} rows, in which nothing stands that is read, are left out", others_rows));
  }
  if (!log.ignore.empty()) log.notes.push_back("not read: " + io::listed(log.ignore));
  return log;
}

std::optional<Meaning> by_ending(const std::string& column, std::span<const Ending> endings) {
  const Ending* longest = nullptr;
  for (const Ending& ending : endings) {
    if (!column.ends_with(ending.name)) continue;
    const std::size_t before = column.size() - ending.name.size();
    if (before > 0 && std::string_view("./_").find(column[before - 1]) == std::string_view::npos) {
      continue;
    }
    if (longest == nullptr || ending.name.size() > longest->name.size()) longest = &ending;
  }
  return longest == nullptr ? std::nullopt : std::optional(longest->meaning);
}

}  // namespace torquewright::identification::imports
