// SPDX-License-Identifier: Apache-2.0
// Fields, methods and shapes of the simulators' classes: Isaac Lab,
// source/isaaclab/isaaclab/actuators/actuator_pd.py @ eafe554d (IdealPDActuator.compute of the
// action, position and velocity, then _clip_effort of the effort, all (num_envs, num_joints)) and
// actuator_base_cfg.py @ 01ff1d86 (the names of Isaac Lab 3); mjlab, src/mjlab/actuator/actuator.py
// @ 018e7ee3 (ActuatorCmd; build), pd_actuator.py @ 6624f2b0 (IdealPdActuator) and fused_group.py @
// 95f44d89 (an actuator with a compute of its own is not fused).
#include "actuator/source_text/python_classes.hpp"

#include <array>
#include <string_view>
#include <utility>

namespace torquewright::actuator {
namespace {

constexpr std::string_view kSimulators = R"(
    def isaac_lab_class(self):
        """Isaac Lab's IdealPDActuator with its clip replaced by this region's.

        Set voltage_V or temperature_K of an object of it to (num_envs, 1) tensors to train over
        supplies and temperatures.
        """
        from isaaclab.actuators import IdealPDActuator

        region = self

        class RegionActuator(IdealPDActuator):
            voltage_V = None
            temperature_K = None

            def compute(self, control_action, joint_pos, joint_vel):
                self._velocity_rad_s = joint_vel
                return super().compute(control_action, joint_pos, joint_vel)

            def _clip_effort(self, effort):
                within = super()._clip_effort(effort)
                return region.clip(
                    within, self._velocity_rad_s, self.voltage_V, self.temperature_K
                )

        return RegionActuator

    def isaac_lab(self, joint_names_expr, stiffness, damping, **more):
        """Isaac Lab's configuration of joints that this actuator drives."""
        from isaaclab.actuators import IdealPDActuatorCfg

        peak = self.peak_torque_Nm
        given = {
            "class_type": self.isaac_lab_class(),
            "joint_names_expr": joint_names_expr,
            "stiffness": stiffness,
            "damping": damping,
            "armature": self.armature_kg_m2,
            "friction": 0.0,
            "dynamic_friction": 0.0,
            "viscous_friction": 0.0,
        }
        fields = IdealPDActuatorCfg.__dataclass_fields__
        if "actuator_effort_limit" in fields:  # Isaac Lab 3
            given.update(actuator_effort_limit=peak, joint_effort_limit=peak)
        else:
            given.update(effort_limit=peak, effort_limit_sim=peak)
        given = {name: value for name, value in given.items() if name in fields}
        given.update(more)
        return IdealPDActuatorCfg(**given)

    def mjlab_class(self):
        """mjlab's IdealPdActuator with its clip replaced by this region's."""
        from mjlab.actuator import IdealPdActuator

        region = self

        class RegionActuator(IdealPdActuator):
            voltage_V = None
            temperature_K = None

            def compute(self, cmd):
                torque = self.stiffness * (cmd.position_target - cmd.pos)
                torque = torque + self.damping * (cmd.velocity_target - cmd.vel)
                torque = torque + cmd.effort_target
                limit = self.force_limit
                torque = torque.clip(-limit, limit)
                return region.clip(torque, cmd.vel, self.voltage_V, self.temperature_K)

        return RegionActuator

    def mjlab(self, target_names_expr, stiffness, damping, **more):
        """mjlab's configuration of joints that this actuator drives."""
        from mjlab.actuator import IdealPdActuatorCfg

        actuator = self.mjlab_class()

        class RegionActuatorCfg(IdealPdActuatorCfg):
            def build(self, entity, target_ids, target_names):
                return actuator(self, entity, target_ids, target_names)

        given = {"effort_limit": self.peak_torque_Nm, "frictionloss": 0.0}
        if self.armature_kg_m2 is not None:
            given["armature"] = self.armature_kg_m2
        given.update(more)
        return RegionActuatorCfg(
            target_names_expr=target_names_expr, stiffness=stiffness, damping=damping, **given
        )
)";

/// What the simulators' classes do otherwise where a command is the motor's.
constexpr std::array<std::pair<std::string_view, std::string_view>, 7> kOfMotor = {{
    {"IdealPDActuator with its clip replaced by this region's.",
     "IdealPDActuator with its clip replaced by what reaches the joint."},
    {"IdealPdActuator with its clip replaced by this region's.",
     "IdealPdActuator with its clip replaced by what reaches the joint."},
    {"return region.clip(", "return region.torque("},
    {"return region.clip(torque, ", "return region.torque(torque, "},
    {"joint_effort_limit=peak", "joint_effort_limit=self.joint_peak_torque_Nm"},
    {"effort_limit_sim=peak", "effort_limit_sim=self.joint_peak_torque_Nm"},
    {"{\"effort_limit\": self.peak_torque_Nm",
     "{\"effort_limit\": max(self.peak_torque_Nm, self.joint_peak_torque_Nm)"},
}};

std::string with_all_replaced(std::string text) {
  for (const auto& [old_words, new_words] : kOfMotor) {
    const std::size_t at = text.find(old_words);
    if (at != std::string::npos) text.replace(at, old_words.size(), new_words);
  }
  return text;
}

}  // namespace

std::string python_classes(bool has_friction) {
  const std::string text(kSimulators);
  return has_friction ? with_all_replaced(text) : text;
}

}  // namespace torquewright::actuator
