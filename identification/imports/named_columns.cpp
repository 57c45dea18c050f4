// SPDX-License-Identifier: Apache-2.0
#include "identification/imports/named_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "io/faults/spec_error.hpp"
#include "io/files/csv.hpp"
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

/// Columns, from 0, in which something stood that is no finite number.
using NoNumbers = std::set<std::size_t>;

/// The cells as they are written; those that are read must be finite numbers.
std::vector<std::string> cells_of(const io::CsvReader& csv, const ImportedLog& log,
                                  NoNumbers& no_numbers) {
  std::vector<std::string> row;
  for (std::size_t i = 0; i < log.header.size(); ++i) {
    const auto is_this = [&](const ColumnUse& use) { return use.column == log.header[i]; };
    if (std::any_of(log.columns.begin(), log.columns.end(), is_this)) csv.number(i);
    if (!csv.is_number(i)) no_numbers.insert(i);
    row.emplace_back(csv.text(i));
  }
  return row;
}

/// A log is a table of numbers: states, words and sensors that are not there stay behind.
void leave_out(const NoNumbers& no_numbers, ImportedLog& log) {
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
  std::erase_if(log.ignore, [&](const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  });
  log.notes.push_back("left out, for not all that they hold are numbers: " + io::listed(names));
}

}  // namespace

ImportedLog read_named_columns(
    const ImportRequest& request,
    const std::function<std::optional<Meaning>(const std::string&)>& meaning_of) {
  ImportedLog log;
  NoNumbers no_numbers;
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
    while (csv.next()) run.rows.push_back(cells_of(csv, log, no_numbers));
    log.runs.push_back(std::move(run));
  }
  leave_out(no_numbers, log);
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
