// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "identification/rig/quantity.hpp"

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
};

enum class LoadType { kDynamometer, kFree, kPendulum, kLinearAxis, kSerialArm };
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
  std::vector<std::string> joints;  ///< Joints of a serial arm, from the base on; else {""}.
  /// The links did not name the joints; their order is that of the columns.
  bool joints_by_columns = false;
  std::vector<std::string> holdout_runs;  ///< Names of runs to hold out; empty: none stated.
  /// Pointers to values that a fit may correct: /load/..., /loads/RUN/..., /motor/..., /gearbox/...
  std::vector<std::string> uncertain;
};

/// Returns the load of a run of this name, or of a part of it that was held out.
const Load& load_of(const Rig& rig, std::string_view run);

/// Reads a rig. Throws io::SpecError, with all faults at once, for what the schema cannot say:
/// unknown quantities (naming the nearest), a quantity twice, a joint without a link, a load
/// without its values, loads of several types, no time where the log is no map, pointers that lead
/// to nothing.
Rig read_rig(const io::Document& document);

}  // namespace torquewright::identification
