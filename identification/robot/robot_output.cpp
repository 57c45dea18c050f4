// SPDX-License-Identifier: Apache-2.0
// Fields. MuJoCo: XML reference, actuator/general (gain kp, bias -kp and -kv), joint. Isaac Lab:
// DelayedPDActuatorCfg of actuator_pd_cfg.py and ActuatorBaseCfg of actuator_base_cfg.py @ 01ff1d86
// (delays in physics steps). mjlab: BuiltinPositionActuatorCfg of builtin_actuator.py, v1.6, whose
// delay_min_lag and delay_max_lag are physics steps too. Newton: ModelBuilder.joint_target_ke, _kd,
// joint_armature, joint_friction, joint_damping (newton/_src/sim/builder.py). Units are SI.
#include "identification/robot/robot_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "actuator/exporters/text.hpp"
#include "robot/mjcf/mjcf_writer.hpp"
#include "robot/urdf/urdf_writer.hpp"

namespace torquewright::identification {
namespace {

/// What a simulator's joint holds.
struct JointFields {
  std::string name;
  double stiffness_Nm_rad, damping_Nm_s_rad, effort_Nm, delay_s;
  double armature_kg_m2, friction_Nm, viscous_Nm_s_rad;
};

std::vector<JointFields> fields_of(const RobotSubject& subject) {
  std::vector<JointFields> all;
  for (std::size_t i = 0; i < subject.bodies.size(); ++i) {
    const dynamics::Joint& joint = subject.robot.tree.bodies[subject.bodies[i]].joint;
    const JointController& controller = subject.controllers[i];
    all.push_back({joint.name, controller.law.stiffness_Nm_rad, controller.law.damping_Nm_s_rad,
                   std::min(controller.law.torque_limit_Nm, joint.limits.effort_max),
                   controller.delay_s, joint.reflected_inertia, joint.passive.dry_friction,
                   joint.passive.damping});
  }
  return all;
}

/// A number of Python; None where there is no limit.
std::string number(double value) {
  return std::isfinite(value) ? fmt::format("{}", value) : "None";
}

std::string general_text(const JointFields& joint) {
  std::string limit;
  if (std::isfinite(joint.effort_Nm)) {
    limit = fmt::format(" forcelimited=\"true\" forcerange=\"-{0} {0}\"", joint.effort_Nm);
  }
  return fmt::format(
      "        <general name={0} joint={0} gaintype=\"fixed\" biastype=\"affine\" "
      "gainprm=\"{1}\" biasprm=\"0 -{1} -{2}\"{3}/>\n",
      actuator::xml_quoted(joint.name), joint.stiffness_Nm_rad, joint.damping_Nm_s_rad, limit);
}

/// Damping of gains and joints as the laws have it, and dry friction as stiff as steps allow: with
/// MuJoCo's own 0.02 s a coast is off by 1.7 % (docs/simulator_formats.md).
constexpr const char* kSettings =
    "<option timestep=\"0.001\" integrator=\"implicit\"/>\n"
    "    <default>\n        <joint solreffriction=\"0.0001 1\"/>\n    </default>\n    ";

/// With each joint's own loop in the place of its motor: a control is a commanded position.
std::string mujoco_text(const RobotSubject& subject) {
  std::string text = hopper::mjcf_of(subject.robot).text;
  for (std::size_t at = text.find("<actuator>"); at != std::string::npos;
       at = text.find("<actuator>")) {
    const std::string_view end = "</actuator>";
    text.erase(at, text.find(end, at) + end.size() - at);
  }
  text.insert(text.find("<worldbody>"), kSettings);
  std::vector<std::string> lines = subject.origin;
  for (const JointFields& joint : fields_of(subject)) {
    if (joint.delay_s > 0.0) {
      lines.push_back(fmt::format("{}: give the command {:g} s late; no field holds it", joint.name,
                                  joint.delay_s));
    }
  }
  std::string loops = actuator::xml_comment(lines) + "    <actuator>\n";
  for (const JointFields& joint : fields_of(subject)) loops += general_text(joint);
  text.insert(text.rfind("</mujoco>"), loops + "    </actuator>\n");
  return text;
}

std::string urdf_text(const RobotSubject& subject) {
  std::string text = hopper::urdf_of(subject.robot).text;
  std::vector<std::string> lines = subject.origin;
  lines.emplace_back("URDF holds damping and friction (<dynamics>); no rotor, gain or delay:");
  for (const JointFields& each : fields_of(subject)) {
    lines.push_back(fmt::format(
        "{}: armature {:g} kg m2, stiffness {:g} Nm/rad, damping {:g} Nm s/rad, delay {:g} s",
        each.name, each.armature_kg_m2, each.stiffness_Nm_rad, each.damping_Nm_s_rad,
        each.delay_s));
  }
  text.insert(text.rfind("</robot>"), actuator::xml_comment(lines));
  return text;
}

/// What matches the joint's name and nothing else.
std::string expression(const std::string& name) {
  return actuator::python_expressions(std::span(&name, 1));
}

std::string isaac_lab_text(const RobotSubject& subject) {
  std::string text = actuator::line_comment(subject.origin, "# ");
  text +=
      "from isaaclab.actuators import DelayedPDActuatorCfg\n\n\n"
      "def actuators(physics_step_s):\n"
      "    \"\"\"For ArticulationCfg(actuators=...).\"\"\"\n"
      "    return {\n";
  for (const JointFields& each : fields_of(subject)) {
    text += fmt::format(
        "        {0}: DelayedPDActuatorCfg(joint_names_expr=[{8}], stiffness={1}, "
        "damping={2}, effort_limit={3}, armature={4}, friction={5}, dynamic_friction={5}, "
        "viscous_friction={6}, min_delay=round({7} / physics_step_s), "
        "max_delay=round({7} / physics_step_s)),\n",
        actuator::python_string(each.name), each.stiffness_Nm_rad, each.damping_Nm_s_rad,
        number(each.effort_Nm), each.armature_kg_m2, each.friction_Nm, each.viscous_Nm_s_rad,
        each.delay_s, expression(each.name));
  }
  return text + "    }\n";
}

std::string mjlab_text(const RobotSubject& subject) {
  std::string text = actuator::line_comment(subject.origin, "# ");
  text +=
      "from mjlab.actuator import BuiltinPositionActuatorCfg\n\n\n"
      "def actuators(physics_step_s):\n"
      "    \"\"\"For EntityArticulationInfoCfg(actuators=...).\"\"\"\n"
      "    return (\n";
  for (const JointFields& each : fields_of(subject)) {
    text += fmt::format(
        "        BuiltinPositionActuatorCfg(target_names_expr=({0},), stiffness={1}, "
        "damping={2}, effort_limit={3}, armature={4}, frictionloss={5}, viscous_damping={6}, "
        "delay_min_lag=round({7} / physics_step_s), delay_max_lag=round({7} / physics_step_s)),\n",
        expression(each.name), each.stiffness_Nm_rad, each.damping_Nm_s_rad, number(each.effort_Nm),
        each.armature_kg_m2, each.friction_Nm, each.viscous_Nm_s_rad, each.delay_s);
  }
  return text + "    )\n";
}

std::string newton_text(const RobotSubject& subject) {
  std::string text = actuator::line_comment(subject.origin, "# ");
  text +=
      "# target_ke, target_kd, armature, friction, damping, effort limit; a delay of the command "
      "is "
      "the\n# caller's.\nJOINTS = {\n";
  for (const JointFields& each : fields_of(subject)) {
    text += fmt::format("    {}: ({}, {}, {}, {}, {}, {}),\n", actuator::python_string(each.name),
                        each.stiffness_Nm_rad, each.damping_Nm_s_rad, each.armature_kg_m2,
                        each.friction_Nm, each.viscous_Nm_s_rad, number(each.effort_Nm));
  }
  return text +
         "}\n\n\ndef set_joints(builder):\n"
         "    \"\"\"Sets the joints of a newton.ModelBuilder by the last part of their "
         "labels.\"\"\"\n"
         "    for joint, label in enumerate(builder.joint_label):\n"
         "        values = JOINTS.get(label.split(\"/\")[-1])\n"
         "        if values is None:\n"
         "            continue\n"
         "        dof = builder.joint_qd_start[joint]\n"
         "        builder.joint_target_ke[dof] = values[0]\n"
         "        builder.joint_target_kd[dof] = values[1]\n"
         "        builder.joint_armature[dof] = values[2]\n"
         "        builder.joint_friction[dof] = values[3]\n"
         "        builder.joint_damping[dof] = values[4]\n"
         "        if values[5] is not None:\n"
         "            builder.joint_effort_limit[dof] = values[5]\n";
}

constexpr std::array kOutputs = {
    RobotOutput{"mujoco", "a robot as MJCF with its joints' loops", "MuJoCo, XML reference",
                mujoco_text},
    RobotOutput{"urdf", "a robot as URDF", "URDF, joint/dynamics", urdf_text},
    RobotOutput{"isaac-lab", "its actuators for Isaac Lab",
                "IsaacLab, actuator_pd_cfg.py: DelayedPDActuatorCfg", isaac_lab_text},
    RobotOutput{"mjlab", "for mjlab", "mjlab, builtin_actuator.py: BuiltinPositionActuatorCfg",
                mjlab_text},
    RobotOutput{"newton", "for Newton", "Newton, ModelBuilder", newton_text},
};

}  // namespace

std::span<const RobotOutput> robot_outputs() { return kOutputs; }

const RobotOutput* find_robot_output(std::string_view name) {
  for (const RobotOutput& each : kOutputs) {
    if (each.name == name) return &each;
  }
  return nullptr;
}

}  // namespace torquewright::identification
