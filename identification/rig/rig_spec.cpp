// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>

#include "identification/rig/controller_spec.hpp"
#include "identification/rig/load_spec.hpp"
#include "identification/rig/rig.hpp"
#include "identification/rig/rig_parts_spec.hpp"
#include "identification/rig/robot_load_spec.hpp"
#include "io/documents/document.hpp"
#include "io/faults/json_text.hpp"
#include "io/text/column_patterns.hpp"
#include "io/text/nearest.hpp"
#include "io/text/one_line.hpp"
#include "io/text/units.hpp"
#include "io/text/wording.hpp"

namespace torquewright::identification {
namespace {

using nlohmann::json;

constexpr double kLeastScale = 1e-15;  ///< Of a column in any unit; less would leave no numbers.

std::vector<std::string> quantity_names() {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < kQuantityCount; ++i) {
    names.emplace_back(name_of(static_cast<Quantity>(i)));
  }
  return names;
}

bool is_of_the_whole_log(Quantity quantity) {
  return quantity == Quantity::kTime || quantity == Quantity::kRun;
}

/// What one supply or one housing states for all joints.
bool may_be_shared(Quantity quantity) {
  return quantity == Quantity::kBusVoltage || quantity == Quantity::kWindingTemperature ||
         quantity == Quantity::kCaseTemperature || quantity == Quantity::kEnabled;
}

bool may_lack_sign(Quantity quantity) {
  return quantity == Quantity::kMotorCurrent || quantity == Quantity::kReportedTorque ||
         quantity == Quantity::kOutputTorque;
}

bool needs_time(Quantity quantity) {
  return quantity == Quantity::kOutputVelocity || quantity == Quantity::kMotorVelocity ||
         quantity == Quantity::kLinearVelocity;
}

bool is_position(Quantity quantity) {
  return quantity == Quantity::kOutputPosition || quantity == Quantity::kMotorPosition ||
         quantity == Quantity::kLinearPosition;
}

class RigReader {
 public:
  explicit RigReader(const io::Document& document) : document_(document), root_(document.root) {}

  Rig read() {
    rig_.file = document_.file;
    rig_.name = root_.value("name", io::stem_in_text(document_.file));
    read_loads();
    read_robot();
    read_columns(root_["columns"]);
    read_ignored();
    find_joints();
    read_controllers();
    read_alike();
    find_doubles();
    require_time();
    rig_.holdout_runs = root_.value("holdout_runs", std::vector<std::string>());
    find_repeated(rig_.holdout_runs, "/holdout_runs");
    read_uncertain();
    if (!faults_.empty()) throw io::SpecError(std::move(faults_));
    return std::move(rig_);
  }

 private:
  void report(const std::string& path, std::string message) {
    faults_.push_back({document_.file, document_.path + path, std::move(message)});
  }

  void read_loads() {
    const json loads = root_.value("loads", json::object());
    rig_.states_load = root_.contains("load");
    if (!rig_.states_load && loads.empty()) {
      report("/load",
             "missing; what does the actuator move? (or, by run, \"loads\"; of a robot --robot "
             "FILE says it too)");
      return;
    }
    first_load_ = rig_.states_load ? root_["load"] : *loads.begin();
    if (rig_.states_load) rig_.load = read_load("/load", first_load_);
    for (const auto& [run, load] : loads.items()) {
      const std::string path = io::child_path("/loads", run);
      rig_.loads[run] = read_load(path, load);
      if (load["type"] != first_load_["type"]) {
        report(path + "/type",
               "all loads of a rig must be of one type; another type is another rig");
      } else if (joints_of_links(load) != joints_of_links(first_load_) ||
                 load.value("links", json()).size() != first_load_.value("links", json()).size()) {
        report(path + "/links", "its joints are not those of the other loads");
      }
    }
    if (!rig_.states_load) rig_.load = rig_.loads.begin()->second;
  }

  /// One robot for all runs: what it carries by run is another document.
  void read_robot() {
    if (rig_.load.type != LoadType::kRobot || !first_load_.contains("file")) return;
    if (!rig_.loads.empty()) {
      report("/loads", "a rig of a robot has one \"load\" for all runs");
      return;
    }
    robot_ = robot_load_of_json(first_load_, document_.file,
                                [&](const std::string& key, std::string message) {
                                  report("/load" + key, std::move(message));
                                });
    for (std::size_t body = 1; body < robot_.tree.bodies.size(); ++body) {
      if (robot_.held_rad.contains(body)) continue;
      robot_joints_.push_back(robot_.tree.bodies[body].joint.name);
    }
  }

  void read_controllers() {
    rig_.controllers = controllers_of_json(
        root_, rig_.joints,
        [&](const std::string& key, std::string message) { report(key, std::move(message)); });
  }

  /// Names, or patterns of them.
  void read_alike() {
    const json groups = root_.value("alike", json::array());
    for (std::size_t number = 0; number < groups.size(); ++number) {
      rig_.alike.push_back(joints_of_patterns(
          groups[number], rig_.joints, [&](std::size_t place, std::string message) {
            report(fmt::format("/alike/{}/{}", number, place), std::move(message));
          }));
    }
  }

  Load read_load(const std::string& path, const json& load) {
    return load_of_json(load, [&](const std::string& key, std::string message) {
      report(path + key, std::move(message));
    });
  }

  void read_columns(const json& columns) {
    if (columns.empty()) report("/columns", "is empty; which column is which quantity?");
    for (const auto& [column, entry] : columns.items()) {
      const std::string path = io::child_path("/columns", column);
      const std::string name = entry.is_string() ? entry : entry["quantity"];
      const std::optional<Quantity> quantity = find_quantity(name);
      if (!quantity) {
        const auto near = io::nearest(name, quantity_names());
        report(entry.is_string() ? path : path + "/quantity",
               fmt::format("\"{}\" is no quantity; {}", name,
                           near ? fmt::format("did you mean \"{}\"?", *near)
                                : "known are " + io::listed(quantity_names())));
        continue;
      }
      const json fields = entry.is_string() ? json::object() : entry;
      const double scale = fields.value("scale", 1.0);
      const io::Unit unit = unit_of_column(*quantity, fields, path);
      const ColumnUse use{column,
                          *quantity,
                          scale * unit.in_SI,
                          scale * unit.zero_in_SI + fields.value("offset", 0.0),
                          fields.value("joint", ""),
                          fields.contains("unit") || fields.contains("scale"),
                          !fields.contains("sign")};
      if (rig_.load.type == LoadType::kRobot && io::is_pattern(column)) {
        read_pattern(use, path);
        continue;
      }
      rig_.columns.push_back(use);
      check_column(rig_.columns.back(), fields, path);
    }
  }

  /// A column for each joint that the pattern fits.
  void read_pattern(ColumnUse use, const std::string& path) {
    const std::string joint = use.joint.empty() ? "{joint}" : use.joint;
    if (robot_joints_.empty()) return;  // the robot itself was refused
    const auto columns = io::columns_of_pattern(use.column, joint, robot_joints_);
    if (columns.empty()) {
      report(path,
             fmt::format("fits no joint: \"joint\" ({}) must hold the word in braces that the "
                         "column's name holds, and what is around it must be as in a joint's "
                         "name; the robot's joints are {}",
                         joint, io::listed(robot_joints_)));
    }
    for (const io::PatternColumn& one : columns) {
      use.column = one.column;
      use.joint = one.joint;
      rig_.columns.push_back(use);
    }
  }

  /// That the column is in; the quantity's own where the document says none.
  io::Unit unit_of_column(Quantity quantity, const json& fields, const std::string& path) {
    const std::optional<io::Unit> own = io::find_unit(unit_of(quantity));
    const io::Dimension dimension = own ? own->dimension : io::Dimension::kNumber;
    const io::Unit none{"", dimension, 1.0};
    if (!fields.contains("unit")) return none;
    const std::string name = fields["unit"];
    const std::optional<io::Unit> unit = io::find_unit(name);
    if (unit && own && unit->dimension == dimension) return *unit;
    report(path + "/unit",
           own ? fmt::format("\"{}\" is no unit of {}, which must be {}", name, name_of(quantity),
                             io::either(io::unit_names(dimension)))
               : fmt::format("{} has no unit", name_of(quantity)));
    return none;
  }

  void check_column(const ColumnUse& use, const json& fields, const std::string& path) {
    if (fields.value("scale", 1.0) == 0.0)
      report(path + "/scale", "0 would leave nothing of the column");
    if (const double size = std::abs(fields.value("scale", 1.0)); size > 0.0 && size < kLeastScale)
      report(path + "/scale",
             fmt::format("{:g} is less than {:g} in magnitude", size, kLeastScale));
    if (!use.has_sign && !may_lack_sign(use.quantity)) {
      report(path + "/sign", fmt::format("{} is never logged without a sign; motor_current_A, "
                                         "reported_torque_Nm and output_torque_Nm may be",
                                         name_of(use.quantity)));
    }
    if (use.quantity == Quantity::kTime && use.scale < 0.0) {
      report(path + "/scale", "is negative; time must run forward");
    }
    if (use.quantity == Quantity::kRun && (fields.contains("scale") || fields.contains("offset"))) {
      report(path, "names of runs have neither scale nor offset");
    }
    if (!has_joints(rig_.load.type)) {
      if (!use.joint.empty()) {
        report(path + "/joint", "only a serial_arm and a robot have several joints");
      }
    } else if (is_of_the_whole_log(use.quantity)) {
      if (!use.joint.empty()) report(path + "/joint", "is no joint's; leave it out");
    } else if (use.joint.empty() && !may_be_shared(use.quantity)) {
      report(path, fmt::format("which joint's? write {{\"quantity\": \"{}\", \"joint\": ...}}",
                               name_of(use.quantity)));
    }
  }

  void read_ignored() {
    rig_.ignore = root_.value("ignore", std::vector<std::string>());
    find_repeated(rig_.ignore, "/ignore");
    for (std::size_t i = 0; i < rig_.ignore.size(); ++i) {
      if (!root_["columns"].contains(rig_.ignore[i])) continue;
      report(fmt::format("/ignore/{}", i),
             fmt::format("\"{}\" stands under \"columns\" too", rig_.ignore[i]));
    }
  }

  void find_repeated(const std::vector<std::string>& names, const std::string& path) {
    for (std::size_t i = 1; i < names.size(); ++i) {
      const auto end = names.begin() + static_cast<std::ptrdiff_t>(i);
      if (std::find(names.begin(), end, names[i]) == end) continue;
      report(fmt::format("{}/{}", path, i), fmt::format("\"{}\" stands twice", names[i]));
    }
  }

  void find_joints() {
    rig_.joints = {""};
    if (rig_.load.type == LoadType::kRobot) return find_robots_joints();
    if (rig_.load.type != LoadType::kSerialArm) return;
    const json links = first_load_.value("links", json::array());
    const std::vector<std::string> named = joints_of_links(first_load_);
    const auto order = columns_as_written(document_);
    const std::vector<std::string> used = joints_of(order.value_or(column_names()));
    if (named.empty()) {
      rig_.joints = used;
      rig_.joints_by_columns = true;
      if (!order) report("/load/links", "which joint moves each? name it in the link: \"joint\"");
    } else if (named.size() < links.size()) {
      report("/load/links", "some links name their \"joint\", some do not; all must, or none");
      return;
    } else {
      rig_.joints = named;
      find_repeated(named, "/load/links");
      find_strangers(used);
    }
    if (rig_.joints.size() == links.size()) return;
    report("/load/links",
           fmt::format("{} link{}, but the columns name {} joint{}{}{}", links.size(),
                       links.size() == 1 ? "" : "s", used.size(), used.size() == 1 ? "" : "s",
                       used.empty() ? "" : ": ", io::listed(used)));
  }

  void find_robots_joints() {
    rig_.joints = joints_in_log(
        joints_of(column_names()), robot_, [&](const std::string& key, std::string message) {
          report((key.empty() ? "/columns" : "/load") + key, std::move(message));
        });
    rig_.load.robot = std::make_shared<const RobotLoad>(robot_);
  }

  /// Joints that columns name and no link.
  void find_strangers(const std::vector<std::string>& used) {
    for (const std::string& joint : used) {
      if (std::find(rig_.joints.begin(), rig_.joints.end(), joint) != rig_.joints.end()) continue;
      const auto near = io::nearest(joint, rig_.joints);
      report("/columns", fmt::format("no link's joint is named \"{}\"; {}", joint,
                                     near ? fmt::format("did you mean \"{}\"?", *near)
                                          : "there are " + io::listed(rig_.joints)));
    }
  }

  std::vector<std::string> column_names() const {
    std::vector<std::string> names;
    for (const ColumnUse& use : rig_.columns) names.push_back(use.column);
    return names;
  }

  /// In the order in which the columns first mention them.
  std::vector<std::string> joints_of(const std::vector<std::string>& columns) const {
    std::vector<std::string> joints;
    for (const std::string& column : columns) {
      const auto use = std::find_if(rig_.columns.begin(), rig_.columns.end(),
                                    [&](const ColumnUse& one) { return one.column == column; });
      if (use == rig_.columns.end() || use->joint.empty()) continue;
      if (std::find(joints.begin(), joints.end(), use->joint) == joints.end()) {
        joints.push_back(use->joint);
      }
    }
    return joints;
  }

  void find_doubles() {
    for (std::size_t i = 0; i < rig_.columns.size(); ++i) {
      const ColumnUse& use = rig_.columns[i];
      for (std::size_t j = 0; j < i; ++j) {
        const ColumnUse& other = rig_.columns[j];
        const bool meet = other.joint == use.joint || other.joint.empty() || use.joint.empty();
        if (other.quantity != use.quantity || !meet) continue;
        report(io::child_path("/columns", use.column),
               fmt::format("is {}{}{} as \"{}\" is; name one, list the other under \"ignore\"",
                           name_of(use.quantity), use.joint.empty() ? "" : " of ", use.joint,
                           other.column));
      }
    }
  }

  /// No row of a steady log has a before: its time is not read.
  void leave_out_time() {
    const auto is_time = [](const ColumnUse& use) { return use.quantity == Quantity::kTime; };
    for (const ColumnUse& use : rig_.columns) {
      if (is_time(use)) rig_.ignore.push_back(use.column);
    }
    std::erase_if(rig_.columns, is_time);
  }

  /// A log without time is a quasi-static map: holding values over positions; or its rows are
  /// steady states.
  void require_time() {
    const auto has = [&](auto&& predicate) {
      return std::any_of(rig_.columns.begin(), rig_.columns.end(),
                         [&](const ColumnUse& use) { return predicate(use.quantity); });
    };
    if (rig_.load.is_steady) {
      leave_out_time();
      if (!has(needs_time) && !has(is_position)) {
        report("/columns", "no column is a velocity or a position; steady states are states of it");
      }
      return;
    }
    if (rig_.columns.empty() || has([](Quantity one) { return one == Quantity::kTime; })) return;
    if (has(needs_time)) {
      report(
          "/columns",
          "no column is time_s, but one is a velocity; a log without time is a map "
          "of holding values over positions, or its rows are steady states: say \"steady\": true "
          "in the load of a dynamometer");
    } else if (!has(is_position)) {
      report("/columns",
             "no column is time_s, and none is a position; without time a log must be a "
             "map of holding values over positions");
    }
  }

  void read_uncertain() {
    rig_.uncertain = root_.value("uncertain", std::vector<std::string>());
    find_repeated(rig_.uncertain, "/uncertain");
    for (std::size_t i = 0; i < rig_.uncertain.size(); ++i) {
      const std::string objection = objection_to_pointer(rig_.uncertain[i], root_);
      if (!objection.empty()) report(fmt::format("/uncertain/{}", i), objection);
    }
  }

  const io::Document& document_;
  const json& root_;
  json first_load_ = json::object();  ///< Of those that stand in the document.
  RobotLoad robot_;
  std::vector<std::string> robot_joints_;  ///< Those that move: a pattern means no other.
  Rig rig_;
  std::vector<io::Fault> faults_;
};

}  // namespace

Rig read_rig(const io::Document& document) { return RigReader(document).read(); }

}  // namespace torquewright::identification
