// SPDX-License-Identifier: Apache-2.0
#include "actuator/trajectory/trajectory_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "actuator/trajectory/meant_columns.hpp"
#include "actuator/trajectory/one_time.hpp"
#include "io/columns/units_row.hpp"
#include "io/faults/refusal.hpp"
#include "io/text/nearest.hpp"
#include "io/text/wording.hpp"

namespace torquewright::actuator {
namespace {

constexpr std::size_t kMostNamesListed = 20;

std::string hint(const std::string& word, std::vector<std::string> known) {
  if (known.empty()) return "";
  if (const auto near = io::nearest(word, known)) {
    return fmt::format("; did you mean \"{}\"?", *near);
  }
  const bool is_long = known.size() > kMostNamesListed;
  if (is_long) known.resize(kMostNamesListed);
  return fmt::format("; there are {}{}", io::listed(known), is_long ? ", ..." : "");
}

std::vector<std::string> joints_of(const std::vector<ColumnMapping>& mappings) {
  std::vector<std::string> names;
  for (const ColumnMapping& mapping : mappings) {
    const bool is_new = std::find(names.begin(), names.end(), mapping.joint) == names.end();
    if (!mapping.joint.empty() && is_new) names.push_back(mapping.joint);
  }
  return names;
}

bool same_quantity(const ColumnMapping& one, const ColumnMapping& other) {
  return one.quantity == other.quantity && one.joint == other.joint;
}

/// A name that says degrees is not read as radians, nor left aside where it is a joint's: there the
/// quantity would be missing, and nobody would know.
void refuse_foreign_units(const io::CsvReader& csv, const std::vector<ColumnMapping>& mappings,
                          const std::vector<std::string>& joints) {
  const auto refuse_if_foreign = [&](const std::string& column, Quantity quantity,
                                     const std::string& joint) {
    const std::optional<io::Unit> unit = foreign_unit(column, dimension_of(quantity));
    if (!unit) return;
    io::refuse(csv.file(), fmt::format("the column \"{0}\" says {1}; state its unit, --column "
                                       "{0}={2}{3}:{1}",
                                       column, unit->name, joint.empty() ? "" : joint + ".",
                                       name_of(quantity)));
  };
  for (const ColumnMapping& mapping : mappings) {
    if (!mapping.has_unit) refuse_if_foreign(mapping.column, mapping.quantity, mapping.joint);
  }
  for (const std::string& column : csv.header()) {
    const bool is_read = std::any_of(mappings.begin(), mappings.end(),
                                     [&](const auto& mapping) { return mapping.column == column; });
    if (is_read) continue;
    for (const std::string& joint : joints) {
      for (const Quantity quantity :
           {Quantity::kPosition, Quantity::kVelocity, Quantity::kTorque}) {
        const std::string before_unit = fmt::format("{}_{}_", joint, name_of(quantity));
        const bool is_its_own =
            column.starts_with(before_unit) && io::find_unit(column.substr(before_unit.size()));
        const bool is_known = std::any_of(mappings.begin(), mappings.end(), [&](const auto& other) {
          return other.joint == joint && other.quantity == quantity;
        });
        if (is_its_own && !is_known) refuse_if_foreign(column, quantity, joint);
      }
    }
  }
}

std::string target_of(const ColumnMapping& mapping) {
  const std::string quantity(name_of(mapping.quantity));
  return mapping.joint.empty() ? quantity : mapping.joint + "." + quantity;
}

/// A document may describe a whole robot; what the command line says is meant for this check.
void require_checked_joint(const ColumnMapping& mapping, const std::vector<std::string>& joints) {
  const bool is_checked = mapping.joint.empty() ||
                          std::find(joints.begin(), joints.end(), mapping.joint) != joints.end();
  if (mapping.text.empty() || is_checked) return;
  io::refuse("--column", fmt::format("\"{}\": no joint \"{}\" is checked{}", mapping.text,
                                     mapping.joint, hint(mapping.joint, joints)));
}

/// One column is one quantity; that of several joints it may be, as of a left and a right leg that
/// move alike.
void require_apart(const std::string& file, const ColumnMapping& one, const ColumnMapping& other) {
  if (same_quantity(one, other)) {
    io::refuse(file, one.column == other.column
                         ? fmt::format("\"{}\" is mapped to {} twice", one.column, target_of(one))
                         : fmt::format("\"{}\" and \"{}\" are both mapped to {}", one.column,
                                       other.column, target_of(one)));
  }
  if (one.column == other.column && one.quantity != other.quantity) {
    io::refuse(file, fmt::format("\"{}\" is mapped to {} and to {}; one column is one quantity",
                                 one.column, target_of(one), target_of(other)));
  }
}

/// The stated mappings, and the canonical ones for what no mapping is stated, of columns that none
/// says to be something else.
std::vector<ColumnMapping> complete(const io::CsvReader& csv,
                                    const std::vector<ColumnMapping>& stated,
                                    const std::vector<std::string>& joints) {
  for (std::size_t i = 0; i < stated.size(); ++i) {
    const ColumnMapping& mapping = stated[i];
    if (!csv.find(mapping.column)) {
      io::refuse(csv.file(), fmt::format("no column \"{}\"{}", mapping.column,
                                         hint(mapping.column, csv.header())));
    }
    require_checked_joint(mapping, joints);
    for (std::size_t j = 0; j < i; ++j) require_apart(csv.file(), stated[j], mapping);
  }
  const bool has_stated_time =
      std::any_of(stated.begin(), stated.end(),
                  [](const ColumnMapping& mapping) { return mapping.quantity == Quantity::kTime; });
  if (!has_stated_time) require_one_time(csv);
  std::vector<ColumnMapping> all = stated;
  for (const std::string& column : csv.header()) {
    const std::optional<ColumnMapping> mapping = canonical_mapping(column);
    if (!mapping) continue;
    const bool is_taken = std::any_of(all.begin(), all.end(), [&](const ColumnMapping& other) {
      return same_quantity(other, *mapping) || other.column == column;
    });
    if (!is_taken) all.push_back(*mapping);
  }
  return all;
}

}  // namespace

std::string no_rows_within(const Window& window, double first_s, double last_s) {
  const bool has_from = std::isfinite(window.from_s), has_until = std::isfinite(window.until_s);
  const std::string within =
      has_from && has_until
          ? fmt::format("between --from {} s and --until {} s", window.from_s, window.until_s)
      : has_from ? fmt::format("from --from {} s on", window.from_s)
                 : fmt::format("up to --until {} s", window.until_s);
  return fmt::format("no rows lie {}; the file's go from {} s to {} s", within, first_s, last_s);
}

TrajectoryReader::TrajectoryReader(const std::filesystem::path& file,
                                   const std::vector<ColumnMapping>& mappings,
                                   const std::vector<std::string>& joints, const Window& window)
    : csv_(file, io::CsvReader::CutEnd::kRefused, io::CsvReader::UnitsRow::kTaken),
      window_(window),
      joints_(joints.size()),
      unwraps_(joints.size()) {
  const std::vector<ColumnMapping> all =
      complete(csv_, without_patterns(mappings, joints, csv_.header(), csv_.file()), joints);
  refuse_foreign_units(csv_, all, joints);
  assign(all, joints);
  require_complete(all, joints);
}

void TrajectoryReader::assign(const std::vector<ColumnMapping>& mappings,
                              const std::vector<std::string>& joints) {
  for (const ColumnMapping& mapping : mappings) {
    const std::size_t column = *csv_.find(mapping.column);
    const double factor = io::with_units_row(csv_, column, dimension_of(mapping.quantity),
                                             mapping.factor, mapping.has_unit);
    const JointColumns::Source source{column, factor};
    if (mapping.quantity == Quantity::kTime) time_ = source;
    for (std::size_t i = 0; i < joints.size(); ++i) {
      if (joints[i] != mapping.joint) continue;
      if (mapping.quantity == Quantity::kPosition) joints_[i].position = source;
      if (mapping.quantity == Quantity::kVelocity) joints_[i].velocity = source;
      if (mapping.quantity == Quantity::kTorque) joints_[i].torque = source;
    }
  }
}

void TrajectoryReader::require_complete(const std::vector<ColumnMapping>& found,
                                        const std::vector<std::string>& joints) const {
  if (!time_) {
    io::refuse(csv_.file(), "no column time_s; name the time with --column NAME=time[:unit]");
  }
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const JointColumns& columns = joints_[i];
    if (!columns.position && !columns.velocity && !columns.torque) {
      io::refuse(csv_.file(),
                 fmt::format("no joint \"{}\"{}", joints[i], hint(joints[i], joints_of(found))));
    }
    if (!columns.position && !columns.velocity) {
      io::refuse(
          csv_.file(),
          fmt::format("joint \"{0}\" has neither {0}_position_rad nor {0}_velocity_rad_s; its "
                      "torque alone cannot be checked",
                      joints[i]));
    }
  }
}

double TrajectoryReader::read_time_s() {
  const double time_s = csv_.time(time_->column) * time_->factor;
  csv_.require_within(time_->column, time_s, Clock::kLatest_s);
  if (previous_s_ && time_s <= *previous_s_) {
    csv_.refuse(time_->column, fmt::format("time {}: {} s follows {} s of line {}",
                                           time_s == *previous_s_ ? "repeats" : "runs backwards",
                                           time_s, *previous_s_, previous_line_));
  }
  if (previous_s_ && time_s - *previous_s_ < Clock::kShortestStep_s) {
    csv_.refuse(time_->column,
                fmt::format("{} s follow {} s of line {}: closer than the {} s that a log's rows "
                            "can be apart; state the unit, --column {}=time:ms",
                            time_s, *previous_s_, previous_line_, Clock::kShortestStep_s,
                            csv_.header()[time_->column]));
  }
  if (!first_s_) first_s_ = time_s;
  previous_s_ = time_s;
  previous_line_ = csv_.line();
  return time_s;
}

bool TrajectoryReader::next(Row& row) {
  row.values.assign(kPlaces * joints_.size(), 0.0);
  while (csv_.next()) {
    const double stamp_s = read_time_s();
    row.time_s = clock_.since_origin_s(stamp_s);
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      const auto read = [&](const std::optional<JointColumns::Source>& source, Place place) {
        if (!source) return;
        const double value = csv_.number(source->column) * source->factor;
        csv_.require_within(source->column, value, kGreatestValue);
        row.values[kPlaces * i + place] = value;
      };
      read(joints_[i].position, kPositionAt);
      if (joints_[i].position) {
        double& angle_rad = row.values[kPlaces * i + kPositionAt];
        angle_rad = unwraps_[i].next(row.time_s, angle_rad);
      }
      read(joints_[i].velocity, kVelocityAt);
      read(joints_[i].torque, kTorqueAt);
    }
    if (stamp_s < window_.from_s || stamp_s > window_.until_s) continue;
    has_found_row_ = true;
    return true;
  }
  if (first_s_ && !has_found_row_) {
    io::refuse(csv_.file(), no_rows_within(window_, *first_s_, *previous_s_));
  }
  return false;
}

}  // namespace torquewright::actuator
