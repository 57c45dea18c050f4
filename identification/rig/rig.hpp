// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "identification/rig/joint_controller.hpp"
#include "identification/rig/quantity.hpp"
#include "identification/rig/robot_load.hpp"

namespace torquewright::io {
struct Document;
}

namespace torquewright::identification {

/// The meaning of a column of the log: quantity = scale column + offset, in the quantity's unit. A
/// unit that the document states for the column is already in both.
struct ColumnUse {
  std::string column;
  Quantity quantity = Quantity::kTime;
  double scale = 1.0;
  double offset = 0.0;
  /// Joint of a serial arm; empty: the column holds for all joints, or there is only one.
  std::string joint;
  bool has_unit = false;  ///< The document states the column's unit, or a scale.
  bool has_sign = true;   ///< False: the column is a magnitude.
};

enum class LoadType { kDynamometer, kFree, kPendulum, kLinearAxis, kSerialArm, kRobot };
std::string_view name_of(LoadType type);

/// A link of a serial arm; position 0 hangs down, angles are relative to the link before.
struct Link {
  double mass_kg = 0.0;
  double length_m = 0.0;
  /// Distance of the centre of mass from its joint, along the link.
  double center_of_mass_m = 0.0;
  double inertia_kg_m2 = 0.0;  ///< Inertia about its centre of mass.
  friend bool operator==(const Link&, const Link&) = default;
};

/// The load that the actuator moves.
struct Load {
  LoadType type = LoadType::kDynamometer;
  double mass_kg = 0.0;        ///< Mass of a pendulum or a linear axis.
  double length_m = 0.0;       ///< Pendulum: from the axis to the centre of mass.
  double inertia_kg_m2 = 0.0;  ///< Inertia of a free load; of a pendulum about its centre of mass.
  std::vector<Link> links;     ///< Links of a serial arm, from the base on.
  double roll_rad = 0.0;       ///< Robot: how its base is turned about the world's x,
  double pitch_rad = 0.0;      ///< and before that about the world's y.
  std::shared_ptr<const RobotLoad> robot;
  /// Dynamometer: rows are steady states, each by itself, in no order of time.
  bool is_steady = false;
  friend bool operator==(const Load&, const Load&) = default;
};

/// A document of kind `rig`: how a log was taken.
struct Rig {
  std::string file;  ///< File name for messages.
  std::string name;
  std::vector<ColumnUse> columns;
  std::vector<std::string> ignore;
  Load load;                ///< Load of the runs that `loads` does not name.
  bool states_load = true;  ///< False: every run's load stands in `loads`; `load` is one of them.
  std::map<std::string, Load, std::less<>> loads;  ///< Loads by run, all of the type of `load`.
  /// Joints of a serial arm, from the base on; of a robot in its order; else {""}.
  std::vector<std::string> joints;
  /// The links did not name the joints; their order is that of the columns.
  bool joints_by_columns = false;
  /// Each joint's controller, where it is stated; empty: none is.
  std::vector<std::optional<JointController>> controllers;
  /// Indices of joints that have the same hardware, group by group.
  std::vector<std::vector<std::size_t>> alike;
  std::vector<std::string> holdout_runs;  ///< Names of runs to hold out; empty: none stated.
  /// Pointers to values that a fit may correct: /load/..., /loads/RUN/..., /motor/...,
  /// /gearbox/..., /controller/..., /controllers/PATTERN/...
  std::vector<std::string> uncertain;
};

/// Whether the load has joints by name: a serial arm's or a robot's.
inline bool has_joints(LoadType type) {
  return type == LoadType::kSerialArm || type == LoadType::kRobot;
}

/// Returns the load of a run of this name, or of a part of it that was held out.
const Load& load_of(const Rig& rig, std::string_view run);

/// Reads a rig. Throws io::SpecError, with all faults at once, for what the schema cannot say:
/// unknown quantities (naming the nearest), a quantity twice, a joint without a link, a load
/// without its values, loads of several types, no time where the log is no map, pointers that lead
/// to nothing.
Rig read_rig(const io::Document& document);

}  // namespace torquewright::identification
