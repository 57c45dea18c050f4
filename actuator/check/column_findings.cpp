// SPDX-License-Identifier: Apache-2.0
#include "actuator/check/column_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include "actuator/drive_check/drive_rows.hpp"
#include "actuator/trajectory/meant_columns.hpp"
#include "io/files/csv.hpp"
#include "io/text/nearest.hpp"
#include "io/text/unit_in_name.hpp"
#include "io/text/wording.hpp"

namespace torquewright::actuator {
namespace {

constexpr std::size_t kMostUnreadListed = 20;

using Names = std::vector<std::string>;

Finding note(const char* rule, std::string sentence) {
  Finding finding;
  finding.rule = rule;
  finding.sentence = std::move(sentence);
  return finding;
}

/// What the check makes of a header's columns.
class HeaderReading {
 public:
  HeaderReading(const Names& header, const CheckRequest& request, Names joints)
      : header_(header),
        joints_(std::move(joints)),
        stated_(without_patterns(request.columns, joints_, header, request.trajectory.string())) {
    for (const std::string& column : header_) {
      const auto mapping = canonical_mapping(column);
      if (mapping && mapping->quantity != Quantity::kTorque) moving_.insert(mapping->joint);
    }
  }

  std::vector<UnreadColumn> unread() const {
    std::vector<UnreadColumn> unread;
    for (const std::string& column : header_) {
      if (is_stated(column) || is_read(canonical_mapping(column))) continue;
      unread.push_back({column, meant_header(column)});
    }
    return unread;
  }

 private:
  bool is_checked(const std::string& joint) const {
    return std::find(joints_.begin(), joints_.end(), joint) != joints_.end();
  }

  bool is_stated(const std::string& column) const {
    return std::any_of(stated_.begin(), stated_.end(),
                       [&](const ColumnMapping& stated) { return stated.column == column; });
  }

  bool is_stated(const std::string& joint, Quantity quantity) const {
    return std::any_of(stated_.begin(), stated_.end(), [&](const ColumnMapping& stated) {
      return stated.joint == joint && stated.quantity == quantity;
    });
  }

  bool is_read(const std::optional<ColumnMapping>& mapping) const {
    if (!mapping) return false;
    const bool is_known = mapping->quantity == Quantity::kTime || is_checked(mapping->joint);
    return is_known ? !is_stated(mapping->joint, mapping->quantity)
                    : moving_.contains(mapping->joint);
  }

  /// The missing header of its joint that a column may be a misspelling of; empty: none.
  std::string meant_header(const std::string& column) const {
    Names missing;
    for (const std::string& joint : joints_) {
      if (!column.starts_with(joint)) continue;
      for (const char* quantity : {"position_rad", "velocity_rad_s", "torque_Nm"}) {
        const std::string header = fmt::format("{}_{}", joint, quantity);
        const bool is_there = std::find(header_.begin(), header_.end(), header) != header_.end();
        if (!is_there && !is_stated(joint, *find_quantity(quantity))) missing.push_back(header);
      }
    }
    return io::nearest(column, missing).value_or("");
  }

  const Names& header_;
  Names joints_;
  std::vector<ColumnMapping> stated_;
  std::set<std::string> moving_;  ///< Joints whose position or velocity the file has.
};

std::vector<MappingText> stated_on_command_line(const CheckRequest& request) {
  std::vector<MappingText> stated;
  for (const ColumnMapping& mapping : request.columns) {
    if (!mapping.text.empty()) stated.push_back(split_mapping(mapping.text));
  }
  return stated;
}

}  // namespace

std::vector<Finding> unread_findings(std::vector<UnreadColumn> unread) {
  if (unread.empty()) return {};
  std::stable_partition(unread.begin(), unread.end(),
                        [](const UnreadColumn& one) { return !one.meant.empty(); });
  Names names;
  for (const UnreadColumn& one : unread) {
    names.push_back(one.meant.empty() ? fmt::format("\"{}\"", one.column)
                                      : fmt::format("\"{}\" (is near {}, which is missing)",
                                                    one.column, one.meant));
  }
  const bool is_long = names.size() > kMostUnreadListed;
  if (is_long) names.resize(kMostUnreadListed);
  return {note("columns-unread", fmt::format("not read: {}{}; --column says what a column is",
                                             fmt::join(names, ", "), is_long ? ", ..." : ""))};
}

std::vector<Finding> unit_findings(std::span<const MappingText> stated) {
  std::vector<Finding> findings;
  for (const MappingText& mapping : stated) {
    const std::optional<io::Unit> unit = io::find_unit(mapping.unit);
    if (!unit) continue;
    const std::optional<io::Unit> own = io::unit_in_name(mapping.column, unit->dimension);
    if (!own || own->in_SI == unit->in_SI) continue;
    findings.push_back(note("column-unit", fmt::format("\"{}\" is read in {}, as is stated, though "
                                                       "its name ends in {}",
                                                       mapping.column, unit->name, own->name)));
  }
  return findings;
}

std::vector<Finding> table_findings(const io::CsvReader& csv) {
  std::vector<Finding> findings;
  if (csv.skipped_lines() > 0) {
    findings.push_back(note("columns-unread",
                            fmt::format("not read: what stands in the file before line {}, which "
                                        "names the columns",
                                        csv.skipped_lines() + 1)));
  }
  if (csv.units().empty()) return findings;
  findings.push_back(note("column-unit",
                          "the line under the header is read as a row of units; it counts where a "
                          "column's name says none"));
  return findings;
}

std::vector<Finding> column_findings(const CheckRequest& request) {
  std::vector<Finding> findings = unit_findings(stated_on_command_line(request));
  std::error_code unknown;
  if (!std::filesystem::is_regular_file(request.trajectory, unknown)) return findings;
  const io::CsvReader csv(request.trajectory, io::CsvReader::CutEnd::kRefused,
                          io::CsvReader::UnitsRow::kTaken);
  for (Finding& finding : table_findings(csv)) findings.push_back(std::move(finding));
  const DriveRows rows(request.drives, request.parallels, request.trajectory.string());
  for (Finding& finding :
       unread_findings(HeaderReading(csv.header(), request, rows.joints()).unread())) {
    findings.push_back(std::move(finding));
  }
  return findings;
}

}  // namespace torquewright::actuator
