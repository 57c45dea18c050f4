// SPDX-License-Identifier: Apache-2.0
// Fields, methods and shapes of the simulators' classes: Isaac Lab,
// source/isaaclab/isaaclab/actuators/actuator_pd.py @ eafe554d (IdealPDActuator.compute of the
// action, position and velocity, then _clip_effort of the effort, all (num_envs, num_joints)),
// actuator_base_cfg.py @ 01ff1d86 (the names of Isaac Lab 3) and of v2.3.2 (those of Isaac Lab 2),
// utils/_callable.py @ e075b5ac (__call__, which follows compute); how a configuration travels:
// utils/string.py @ 00186c03 (callable_to_string, string_to_callable: "module:name", by import and
// getattr). mjlab, src/mjlab/actuator/actuator.py and pd_actuator.py @ 018e7ee3 (ActuatorCmd with
// pos and vel; build(entity, target_ids, target_names); at 6624f2b0 they were joint_pos, joint_vel
// and joint_ids, and this does not run) and fused_group.py @ 95f44d89 (an actuator with a compute
// of its own is not fused).
#include "actuator/source_text/python_classes.hpp"

#include <array>
#include <string_view>
#include <utility>

namespace torquewright::actuator {
namespace {

constexpr std::string_view kConfigurations = R"(
    def isaac_lab(self, joint_names_expr, stiffness, damping, **more):
        """Isaac Lab's configuration of joints that this actuator drives."""
        from isaaclab.actuators import IdealPDActuatorCfg

        peak = self.peak_torque_Nm
        given = {
            "class_type": _made("IsaacLabActuator"),
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

    def mjlab(self, target_names_expr, stiffness, damping, **more):
        """mjlab's configuration of joints that this actuator drives."""
        given = {"effort_limit": self.peak_torque_Nm, "frictionloss": 0.0}
        if self.armature_kg_m2 is not None:
            given["armature"] = self.armature_kg_m2
        given.update(more)
        return _made("MjlabActuatorCfg")(
            target_names_expr=target_names_expr, stiffness=stiffness, damping=damping, **given
        )
)";

constexpr std::string_view kClasses = R"(

def _isaac_lab_actuator():
    from isaaclab.actuators import IdealPDActuator

    class IsaacLabActuator(IdealPDActuator):
        """Isaac Lab's IdealPDActuator with its clip replaced by this region's.

        Set voltage_V or temperature_K of an object of it to (num_envs, 1) tensors to train over
        supplies and temperatures.
        """

        voltage_V = None
        temperature_K = None
        _on = None

        def compute(self, control_action, joint_pos, joint_vel):
            self._velocity_rad_s = joint_vel
            return super().compute(control_action, joint_pos, joint_vel)

        def __call__(self, control_action, joint_pos, joint_vel):
            self._velocity_rad_s = joint_vel  # what follows compute() in Isaac Lab
            return super().__call__(control_action, joint_pos, joint_vel)

        def _clip_effort(self, effort):
            within = super()._clip_effort(effort)
            if self._on is None:  # of one device and type for as long as it lives
                self._on = REGION.beside(self._velocity_rad_s)
            return self._on.clip(
                within, self._velocity_rad_s, self.voltage_V, self.temperature_K
            )

    return IsaacLabActuator


def _mjlab_actuator():
    from mjlab.actuator import IdealPdActuator

    class MjlabActuator(IdealPdActuator):
        """mjlab's IdealPdActuator with its clip replaced by this region's."""

        voltage_V = None
        temperature_K = None
        _on = None

        def compute(self, cmd):
            torque = self.stiffness * (cmd.position_target - cmd.pos)
            torque = torque + self.damping * (cmd.velocity_target - cmd.vel)
            torque = torque + cmd.effort_target
            limit = self.force_limit
            torque = torque.clip(-limit, limit)
            if self._on is None:
                self._on = REGION.beside(cmd.vel)
            return self._on.clip(torque, cmd.vel, self.voltage_V, self.temperature_K)

    return MjlabActuator


def _mjlab_actuator_cfg():
    from mjlab.actuator import IdealPdActuatorCfg

    class MjlabActuatorCfg(IdealPdActuatorCfg):
        def build(self, entity, target_ids, target_names):
            return _made("MjlabActuator")(self, entity, target_ids, target_names)

    return MjlabActuatorCfg


#: Classes that need a simulator: made on first use, and then of this module as if written in it, so
#: that "module:IsaacLabActuator" (hydra), pickle and deepcopy find them.
_CLASSES = {
    "IsaacLabActuator": _isaac_lab_actuator,
    "MjlabActuator": _mjlab_actuator,
    "MjlabActuatorCfg": _mjlab_actuator_cfg,
}


def _made(name):
    if name not in globals():
        made = _CLASSES[name]()
        made.__module__, made.__qualname__ = __name__, name
        globals()[name] = made
    return globals()[name]


def __getattr__(name):
    if name in _CLASSES:
        return _made(name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
)";

/// What the simulators' classes do otherwise where a command is the motor's.
constexpr std::array<std::pair<std::string_view, std::string_view>, 7> kOfMotor = {{
    {"IdealPDActuator with its clip replaced by this region's.",
     "IdealPDActuator with its clip replaced by what reaches the joint."},
    {"IdealPdActuator with its clip replaced by this region's.",
     "IdealPdActuator with its clip replaced by what reaches the joint."},
    {"return self._on.clip(\n", "return self._on.torque(\n"},
    {"return self._on.clip(torque, ", "return self._on.torque(torque, "},
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

std::string of(std::string_view text, bool has_friction) {
  return has_friction ? with_all_replaced(std::string(text)) : std::string(text);
}

}  // namespace

std::string python_configurations_of(bool has_friction) {
  return of(kConfigurations, has_friction);
}

std::string python_classes(bool has_friction) { return of(kClasses, has_friction); }

}  // namespace torquewright::actuator
