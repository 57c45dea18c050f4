// SPDX-License-Identifier: Apache-2.0
#include "identification/reading/columns.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/faults/spec_error.hpp"
#include "io/text/nearest.hpp"
#include "io/text/unit_in_name.hpp"
#include "io/text/units.hpp"
#include "io/text/wording.hpp"

namespace torquewright::identification {
namespace {

constexpr std::size_t kMostNamesListed = 20;

const ColumnUse* find_use(const Rig& rig, const std::string& column) {
  const auto found = std::find_if(rig.columns.begin(), rig.columns.end(),
                                  [&](const ColumnUse& use) { return use.column == column; });
  return found == rig.columns.end() ? nullptr : &*found;
}

/// Those that the rig does not use otherwise are the ones that may be meant.
std::string missing(const ColumnUse& use, const io::CsvReader& csv, const Rig& rig) {
  const std::string what =
      fmt::format("no column \"{}\", which the rig names as {}", use.column, name_of(use.quantity));
  std::vector<std::string> free;
  for (const std::string& name : csv.header()) {
    if (find_use(rig, name) == nullptr) free.push_back(name);
  }
  if (const auto near = io::nearest(use.column, free)) {
    return fmt::format("{}; did you mean \"{}\"?", what, *near);
  }
  std::vector<std::string> known = csv.header();
  const bool is_long = known.size() > kMostNamesListed;
  if (is_long) known.resize(kMostNamesListed);
  return fmt::format("{}; there are {}{}", what, io::listed(known), is_long ? ", ..." : "");
}

std::string unknown(const std::string& column) {
  return fmt::format(
      "column \"{}\" is not in the rig; say under \"columns\" what it is, or list it "
      "under \"ignore\"",
      column);
}

/// What the row under the header says against the column's use; empty if nothing. A number or a run
/// has no unit.
std::string objection_to_unit(const ColumnUse& use, const std::string& written) {
  const std::optional<io::Unit> own = io::find_unit(unit_of(use.quantity));
  const std::optional<io::Unit> unit = io::find_unit(written);
  if (written.empty() || !own) return "";
  if (!unit) {
    return use.has_unit ? ""
                        : fmt::format(
                              "the unit under the header, \"{}\", is not known; state one "
                              "in the rig ({})",
                              written, io::either(io::unit_names(own->dimension)));
  }
  if (unit->dimension != own->dimension) {
    return fmt::format("the unit under the header, {}, is not one of {}, which the rig says it is",
                       written, name_of(use.quantity));
  }
  return "";
}

/// The unit that the rig states, by what it makes of a column; empty: none, or a scale that is no
/// unit's.
std::optional<io::Unit> stated_unit(const ColumnUse& use, io::Dimension dimension) {
  if (!use.has_unit) return std::nullopt;
  for (const std::string& name : io::unit_names(dimension)) {
    const io::Unit unit = io::find_unit(name).value();
    if (unit.in_SI == use.scale) return unit;
  }
  return std::nullopt;
}

/// That the column's name, or the row under the header, says another unit than the one in which it
/// is read; empty where none does, or where a scale is stated, which may hold whatever it is for.
std::string doubt_of_unit(const ColumnUse& use, const std::string& written) {
  const std::optional<io::Unit> own = io::find_unit(unit_of(use.quantity));
  if (!own) return "";
  const std::optional<io::Unit> stated = stated_unit(use, own->dimension);
  const std::optional<io::Unit> in_row = io::find_unit(written);
  if (use.has_unit && !stated) return "";
  const io::Unit read_in = stated ? *stated : in_row.value_or(*own);
  const std::string words =
      fmt::format("\"{}\" is read in {}, {}, though", use.column, read_in.name,
                  stated   ? "as the rig says"
                  : in_row ? "as the row under the header says"
                           : "since the rig states no unit");
  const auto in_name = io::unit_in_name(use.column, own->dimension);
  if (in_name && in_name->in_SI != read_in.in_SI) {
    return fmt::format("{} its name ends in {}", words, in_name->name);
  }
  if (in_row && in_row->in_SI != read_in.in_SI) {
    return fmt::format("{} the row under the header says {}", words, in_row->name);
  }
  return "";
}

Source source_of(const ColumnUse& use, std::size_t column, const std::string& written,
                 const Rig& rig) {
  Source source{column, use.quantity, use.scale, use.offset, {}};
  if (const auto unit = io::find_unit(written); unit && !use.has_unit) {
    source.scale *= unit->in_SI;
    source.offset += use.scale * unit->zero_in_SI;
  }
  if (!use.joint.empty()) {
    const auto joint = std::find(rig.joints.begin(), rig.joints.end(), use.joint);
    source.joint = static_cast<std::size_t>(joint - rig.joints.begin());
  }
  return source;
}

}  // namespace

Columns find_columns(const io::CsvReader& csv, const Rig& rig) {
  std::vector<io::Fault> faults;
  for (const ColumnUse& use : rig.columns) {
    if (!csv.find(use.column)) faults.push_back({csv.file(), "", missing(use, csv, rig)});
  }
  Columns columns;
  for (std::size_t i = 0; i < csv.header().size(); ++i) {
    const std::string& name = csv.header()[i];
    const ColumnUse* use = find_use(rig, name);
    const std::string written = csv.units().empty() ? "" : csv.units()[i];
    if (use != nullptr) {
      const std::string objection = objection_to_unit(*use, written);
      if (!objection.empty()) {
        faults.push_back({csv.file(), "", fmt::format("column \"{}\": {}", name, objection)});
      }
      std::string doubt = doubt_of_unit(*use, written);
      if (!doubt.empty()) columns.doubts.push_back(std::move(doubt));
    }
    if (use == nullptr) {
      if (std::find(rig.ignore.begin(), rig.ignore.end(), name) == rig.ignore.end()) {
        faults.push_back({csv.file(), "", unknown(name)});
      }
    } else if (use->quantity == Quantity::kTime) {
      columns.time = source_of(*use, i, written, rig);
    } else if (use->quantity == Quantity::kRun) {
      columns.run = i;
    } else {
      columns.channels.push_back(source_of(*use, i, written, rig));
    }
  }
  if (!faults.empty()) throw io::SpecError(std::move(faults));
  return columns;
}

}  // namespace torquewright::identification
