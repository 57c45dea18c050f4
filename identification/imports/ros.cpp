// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <map>
#include <regex>
#include <set>

#include "identification/imports/every_importer.hpp"
#include "identification/imports/named_columns.hpp"
#include "io/faults/spec_error.hpp"
#include "io/files/csv.hpp"
#include "io/text/wording.hpp"

namespace torquewright::identification::imports {
namespace {

constexpr double kPerNanosecond = 1e-9;

/// A column of a JointState: which joint's, and what of it.
struct JointColumn {
  std::string joint;
  Meaning meaning;
};

/// field.position0, /joint_states/position[0], /joint_states/knee/position.
std::optional<JointColumn> joint_column(const std::string& column) {
  static const std::regex kIndexed(R"((?:.*[./])?(position|velocity|effort)\[?(\d+)\]?)");
  static const std::regex kNamed(R"((?:.*/)?([^/]+)/(position|velocity|effort))");
  std::smatch found;
  std::string joint, what;
  if (std::regex_match(column, found, kIndexed)) {
    joint = found[2];
    what = found[1];
  } else if (std::regex_match(column, found, kNamed)) {
    joint = found[1];
    what = found[2];
  } else {
    return std::nullopt;
  }
  const Quantity quantity = what == "position"   ? Quantity::kOutputPosition
                            : what == "velocity" ? Quantity::kOutputVelocity
                                                 : Quantity::kReportedTorque;
  return JointColumn{joint, {quantity}};
}

/// Names of joints by their indices, where a file has them: field.name0, /joint_states/name[0].
using NamesByIndex = std::map<std::string, std::string>;

/// Throws io::SpecError where an index is another joint's in another row or file: each publisher of
/// a topic has an order of its own.
NamesByIndex names_by_index(const ImportRequest& request) {
  static const std::regex kName(R"((?:.*[./])?name\[?(\d+)\]?)");
  NamesByIndex names;
  for (const std::filesystem::path& file : request.files) {
    io::CsvReader csv(file, io::CsvReader::CutEnd::kDropped);
    std::vector<std::pair<std::size_t, std::string>> columns;
    for (std::size_t i = 0; i < csv.header().size(); ++i) {
      std::smatch found;
      if (std::regex_match(csv.header()[i], found, kName)) columns.emplace_back(i, found[1]);
    }
    while (!columns.empty() && csv.next()) {
      for (const auto& [column, index] : columns) {
        const std::string name(csv.text(column));
        if (name.empty() || names.try_emplace(index, name).first->second == name) continue;
        csv.refuse(column, fmt::format("\"{}\", before \"{}\": the joints' order changes", name,
                                       names[index]));
      }
    }
  }
  return names;
}

/// The joint that is read, as columns call it.
std::string only_joint(const ImportRequest& request) {
  const io::CsvReader csv(request.files.front());
  const NamesByIndex names = names_by_index(request);
  std::set<std::string> joints;
  std::string only;
  for (const std::string& column : csv.header()) {
    const auto found = joint_column(column);
    if (!found) continue;
    const auto name = names.find(found->joint);
    joints.insert(name == names.end() ? found->joint : name->second);
    const bool is_asked_for = name != names.end() && name->second == request.joint;
    if (is_asked_for || found->joint == request.joint) return found->joint;
    if (request.joint.empty()) only = found->joint;
  }
  if (request.joint.empty() && joints.size() == 1) return only;
  throw io::SpecError(
      {{csv.file(), "",
        joints.empty()
            ? "no column is a position, velocity or effort of a joint: " + io::listed(csv.header())
            : fmt::format(
                  "{}; say --joint, one of {}",
                  request.joint.empty() ? "holds several joints" : "has no joint " + request.joint,
                  io::listed({joints.begin(), joints.end()}))}});
}

/// Nanoseconds since 1970 do not fit a double: they become seconds since the first.
void count_from_first(ImportedLog& log, const std::string& file) {
  const auto time = std::find(log.header.begin(), log.header.end(), "%time");
  if (time == log.header.end()) return;
  const auto column = static_cast<std::size_t>(time - log.header.begin());
  for (ImportedLog::Run& run : log.runs) {
    std::optional<std::int64_t> first_ns;
    for (std::vector<std::string>& row : run.rows) {
      std::string& cell = row[column];
      std::int64_t stamp_ns = 0;
      const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), stamp_ns);
      if (error != std::errc() || end != cell.data() + cell.size()) {
        throw io::SpecError({{file, "", fmt::format("%time: \"{}\" is no count of ns", cell)}});
      }
      if (!first_ns) first_ns = stamp_ns;
      cell = fmt::format("{:.9f}", kPerNanosecond * static_cast<double>(stamp_ns - *first_ns));
    }
  }
}

ImportedLog read_ros(const ImportRequest& request) {
  const std::string joint = only_joint(request);
  ImportedLog log = read_named_columns(request, [&](const std::string& column) {
    if (column == "%time" || column == "__time" || column == "time" || column == "timestamp") {
      return std::optional(Meaning{});
    }
    const auto found = joint_column(column);
    return found && found->joint == joint ? std::optional(found->meaning) : std::nullopt;
  });
  count_from_first(log, request.files.front().string());
  const bool has_effort =
      std::any_of(log.columns.begin(), log.columns.end(),
                  [](const ColumnUse& use) { return use.quantity == Quantity::kReportedTorque; });
  if (has_effort) {
    log.notes.emplace_back("effort is taken for the driver's own estimate of the output's torque");
  }
  return log;
}

}  // namespace

const Importer ros = {
    "ros", "CSV of joint states: rostopic echo -p (%time, field.position0) or PlotJuggler",
    "http://wiki.ros.org/rostopic; "
    "https://docs.ros.org/en/api/sensor_msgs/html/msg/JointState.html",
    read_ros, true};

}  // namespace torquewright::identification::imports
