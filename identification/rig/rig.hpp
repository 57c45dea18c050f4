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

/// Which column of the log is which quantity: quantity = scale column + offset, in the quantity's
/// unit; what a document says of the column's own unit is in both.
struct ColumnUse {
  std::string column;
  Quantity quantity = Quantity::kTime;
  double scale = 1.0;
  double offset = 0.0;
  std::string joint;  ///< Of a serial arm; empty: of all joints, or there is one only.
};

enum class LoadType { kDynamometer, kFree, kPendulum, kLinearAxis, kSerialArm };
std::string_view name_of(LoadType type);

/// A link of a serial arm; position 0 hangs down, angles are relative to the link before.
struct Link {
  double mass_kg = 0.0;
  double length_m = 0.0;
  double center_of_mass_m = 0.0;  ///< From its joint, along the link.
  double inertia_kg_m2 = 0.0;     ///< About its centre of mass.
  friend bool operator==(const Link&, const Link&) = default;
};

/// What the actuator moves.
struct Load {
  LoadType type = LoadType::kDynamometer;
  double mass_kg = 0.0;        ///< Pendulum, linear axis.
  double length_m = 0.0;       ///< Pendulum: from the axis to the centre of mass.
  double inertia_kg_m2 = 0.0;  ///< Free; pendulum: about its centre of mass.
  std::vector<Link> links;     ///< Serial arm, from the base on.
  friend bool operator==(const Load&, const Load&) = default;
};

/// A document of kind `rig`: how a log was taken.
struct Rig {
  std::string file;  ///< For messages.
  std::string name;
  std::vector<ColumnUse> columns;
  std::vector<std::string> ignore;
  Load load;                ///< Of the runs that `loads` does not name.
  bool states_load = true;  ///< False: every run's load stands in `loads`; `load` is one of them.
  std::map<std::string, Load, std::less<>> loads;  ///< By run; all of one type, `load` too.
  std::vector<std::string> joints;        ///< Of a serial arm, from the base on; else {""}.
  bool joints_by_columns = false;         ///< The links did not name them: in the columns' order.
  std::vector<std::string> holdout_runs;  ///< Empty: none stated.
  /// Pointers: /load/..., /loads/RUN/..., /motor/..., /gearbox/...
  std::vector<std::string> uncertain;
};

/// What the actuator moves in a run of this name, or in a part of it that was held out.
const Load& load_of(const Rig& rig, std::string_view run);

/// Throws io::SpecError, with all faults at once, for what the schema cannot say: unknown
/// quantities (naming the nearest), a quantity twice, a joint without a link, a load without its
/// values, loads of several types, no time where the log is no map, pointers to nothing.
Rig read_rig(const io::Document& document);

}  // namespace torquewright::identification
