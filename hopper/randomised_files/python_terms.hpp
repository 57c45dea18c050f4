// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "actuator/exporters/text.hpp"
#include "hopper/randomised_files/drawn_parts.hpp"

namespace torquewright::hopper {

/// "(0.9, 1.1)"
inline std::string python_pair(const Range& range) {
  return fmt::format("({}, {})", range.least, range.greatest);
}

/// `[("thigh", 0.9, 1.1), ...]`, a row for each name.
inline std::string python_rows(std::string_view name, const std::vector<PartsRange>& ranges) {
  std::string text = fmt::format("{} = [\n", name);
  for (const PartsRange& each : ranges) {
    for (const std::string& part : each.names) {
      text += fmt::format("    ({}, {}, {}),\n", actuator::python_string(part), each.range.least,
                          each.range.greatest);
    }
  }
  return text + "]\n";
}

/// `[("thigh", 0, -0.03, 0.03), ...]`, a row for each body and axis.
inline std::string python_shift_rows(const std::vector<BodyShift>& shifts) {
  std::string text = "CENTER_OF_MASS_M = [\n";
  for (const BodyShift& each : shifts) {
    text += fmt::format("    ({}, {}, {}, {}),\n", actuator::python_string(each.body), each.axis,
                        each.range_m.least, each.range_m.greatest);
  }
  return text + "]\n";
}

/// `NAME = (0.9, 1.1)`, or None.
inline std::string python_pair_or_none(std::string_view name, const std::optional<Range>& range) {
  return fmt::format("{} = {}\n", name, range ? python_pair(*range) : "None");
}

/// How a simulator's actuators are reached and named, and what their compute() then does; Python.
struct ActuatorsInPython {
  std::string_view all;      ///< Of `asset`.
  std::string_view names;    ///< Of the joints of `actuator`.
  std::string_view compute;  ///< Lines of a function that calls plain(*arguments, **named).
};

/// A term that Isaac Lab and mjlab lack: scale_motor_strength().
inline std::string scale_motor_strength(const ActuatorsInPython& of) {
  return fmt::format(R"(

def scaled(actuator):
    """The actuator's compute(), whose torque is then the motor's of another strength."""
    plain = actuator.compute

    def compute(*arguments, **named):
{}
    return compute


def scale_motor_strength(env, env_ids, asset_cfg, strength_range):
    """A factor on what each joint's motor makes within its actuator's law; once, at startup."""
    import torch

    asset = env.scene[asset_cfg.name]
    if env_ids is None:
        env_ids = torch.arange(env.scene.num_envs, device=asset.device)
    joint_ids = asset_cfg.joint_ids
    wanted = asset.joint_names[joint_ids] if isinstance(joint_ids, slice) else [
        asset.joint_names[i] for i in joint_ids
    ]
    low, high = strength_range
    for actuator in {}:
        names = list({})
        columns = [i for i, name in enumerate(names) if name in wanted]
        if not columns:
            continue
        if not hasattr(actuator, "motor_strength"):
            actuator.motor_strength = torch.ones(
                (env.scene.num_envs, len(names)), device=asset.device
            )
            actuator.compute = scaled(actuator)
        drawn = low + (high - low) * torch.rand(len(env_ids), len(columns), device=asset.device)
        actuator.motor_strength[env_ids[:, None], torch.tensor(columns, device=asset.device)] = drawn


)",
                     of.compute, of.all, of.names);
}

/// Of bodies and joints, by Python's names: TOTAL_MASS_FACTOR, MASS_FACTOR, INERTIA_FACTOR,
/// CENTER_OF_MASS_M, DRY_FRICTION_NM.
inline std::string python_tables_of(const DrawnParts& parts) {
  return python_pair_or_none("TOTAL_MASS_FACTOR", parts.stated->total_mass_factor) +
         python_rows("MASS_FACTOR", parts.mass_factor) +
         python_rows("INERTIA_FACTOR", parts.inertia_factor) +
         python_shift_rows(parts.center_of_mass_m) +
         python_rows("DRY_FRICTION_NM", parts.dry_friction_Nm);
}

/// The shifts of one body as a dictionary of Python: `{"x": (-0.01, 0.01), "z": (0, 0.01)}`.
struct BodyRanges {
  std::string body;
  std::string ranges;
};

/// Shifts by body, all axes of one together; `keys` are what Python calls the three axes.
inline std::vector<BodyRanges> ranges_by_body(const std::vector<BodyShift>& shifts,
                                              const std::array<std::string_view, 3>& keys) {
  std::vector<BodyRanges> all;
  for (const BodyShift& each : shifts) {
    const bool is_new = all.empty() || all.back().body != each.body;
    if (is_new) all.push_back({each.body, "{"});
    all.back().ranges +=
        fmt::format("{}{}: {}", is_new ? "" : ", ", keys[each.axis], python_pair(each.range_m));
  }
  for (BodyRanges& each : all) each.ranges += "}";
  return all;
}

/// A dictionary of terms, whose names are of no other.
class PythonTerms {
 public:
  /// `parameters`: lines "key": value, without commas.
  void add(const std::string& name, std::string_view function, std::string_view mode,
           const std::vector<std::string>& parameters) {
    text_ += fmt::format("    \"{}_{}\": EventTermCfg(\n        func={},\n        mode=\"{}\",\n",
                         name, count_++, function, mode);
    text_ += "        params={\n";
    for (const std::string& each : parameters) text_ += "            " + each + ",\n";
    text_ += "        },\n    ),\n";
  }
  std::string text() const { return "EVENTS = {\n" + text_ + "}\n"; }

 private:
  std::string text_;
  int count_ = 0;
};

/// `"asset_cfg": SceneEntityCfg("robot", body_names=[...])`
inline std::string asset(std::string_view of, const std::vector<std::string>& names) {
  return fmt::format("\"asset_cfg\": SceneEntityCfg(\"robot\", {}=[{}])", of,
                     actuator::python_expressions(names));
}

}  // namespace torquewright::hopper
