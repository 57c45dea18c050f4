// SPDX-License-Identifier: Apache-2.0
// Calls: Isaac Gym Preview 4: load_asset(sim, root, file, options), get_asset_dof_names,
// get_asset_dof_properties, set_actor_dof_properties, set_dof_actuation_force_tensor, as
// leggedrobotics/legged_gym, legged_gym/envs/base/legged_robot.py @ c95c80ff uses them
// (_create_envs, step: dof_pos and dof_vel are views of all degrees of freedom of each environment,
// the last axis). Law: actuator/exporters/isaac_gym.cpp. Damping of the joint itself acts in the
// simulator, friction and springs in what efforts() answers.
#include "actuator/exporters/every_exporter.hpp"
#include "robot/simulators/every_region_module.hpp"

namespace torquewright::hopper::region_modules {

const RegionModule isaac_gym = {
    .exporter = &actuator::exporters::isaac_gym,
    .source =
        "https://github.com/leggedrobotics/legged_gym legged_gym/envs/base/legged_robot.py @ "
        "c95c80ff; "
        "https://forums.developer.nvidia.com/t/carb-gymdofproperties-documentation/196552",
    .advice =
        "asset = load(gym, sim, FOLDER, FILE), set_dof_properties(gym, asset) for "
        "set_actor_dof_properties; before each simulate hand efforts(names, torques, positions, "
        "velocities) to set_dof_actuation_force_tensor, all with an axis of "
        "gym.get_asset_dof_names(asset). Explicit friction needs steps shorter than the joint's "
        "inertia times SMOOTHING_RAD_S over the dry torque.",
    .functions = R"(

SMOOTHING_RAD_S = max(
    [getattr(drive, "smoothing_rad_s", 0.0) for group in GROUPS for drive in group["drives"]]
    + [0.01]
)  # over which dry friction of joints turns over
FASTEST_RAD_S = 1e4  # no limit of the motor's: PhysX would hold the joint to it


def load(gym, sim, folder, file, **options):
    """Loads the robot's URDF or MJCF, driven by efforts and without the asset's own damping."""
    from isaacgym import gymapi

    of_asset = gymapi.AssetOptions()
    plain = {
        "default_dof_drive_mode": int(gymapi.DOF_MODE_EFFORT),
        "armature": 0.0,
        "linear_damping": 0.0,
        "angular_damping": 0.0,
    }
    for name, value in {**plain, **options}.items():
        setattr(of_asset, name, value)
    return gym.load_asset(sim, str(folder), str(file), of_asset)


def set_dof_properties(gym, asset):
    """What the simulator's joints have themselves and of their drives: for
    set_actor_dof_properties."""
    from isaacgym import gymapi

    properties = gym.get_asset_dof_properties(asset)
    names = list(gym.get_asset_dof_names(asset))
    for name, joint in JOINTS.items():
        dof = names.index(name)
        properties["driveMode"][dof] = int(gymapi.DOF_MODE_EFFORT)
        properties["stiffness"][dof] = 0.0
        properties["friction"][dof] = 0.0  # a coefficient, no torque
        properties["damping"][dof] = joint["viscous_Nm_s_rad"]
        if joint["armature_kg_m2"] is not None:
            properties["armature"][dof] = joint["armature_kg_m2"]
        if joint["peak_torque_Nm"] is not None:
            properties["velocity"][dof] = FASTEST_RAD_S
            spring = 0.0 if joint["spring"] is None else 1e9
            properties["effort"][dof] = 2.0 * joint["peak_torque_Nm"] + joint["dry_Nm"] + spring
    return properties


def efforts(names, torques, positions, velocities, voltage=None, temperature=None):
    """What set_dof_actuation_force_tensor is to have [Nm] of torques [Nm] that are commanded.

    Tensors of one shape, whose last axis is names, those of the asset's degrees of freedom.
    """
    places = [list(names).index(name) for name in DRIVEN]
    xp = _namespace(velocities)
    reached = within(torques[..., places], velocities[..., places], voltage, temperature)
    columns = []
    for i, name in enumerate(names):
        column = reached[..., DRIVEN.index(name)] if name in DRIVEN else 0.0 * velocities[..., i]
        joint = JOINTS.get(name)
        if joint is not None:
            if joint["dry_Nm"] > 0.0:
                column = column - joint["dry_Nm"] * xp.tanh(velocities[..., i] / SMOOTHING_RAD_S)
            if joint["spring"] is not None:
                stiffness, rest = joint["spring"]
                column = column - stiffness * (positions[..., i] - rest)
        columns.append(column)
    return xp.stack(columns, -1)
)",
};

}  // namespace torquewright::hopper::region_modules
