// SPDX-License-Identifier: Apache-2.0
// MuJoCo Playground's own form: domain_randomize(model, rng) returns the model with a leading axis
// in the fields that are drawn, and in_axes, 0 for those and None for the others
// (mujoco_playground/_src/locomotion/go1/randomize.py; brax' randomization_fn). The drives of the
// model are MJCF's of `robot export`: ctrl is a voltage, so that ctrlrange is the supply's, and a
// factor on gain, bias and force range is one on the motor's torque.
#include "hopper/randomised_files/every_event_writer.hpp"
#include "hopper/randomised_files/python_terms.hpp"

namespace torquewright::hopper::event_writers {
namespace {

constexpr std::string_view kFunction = R"(

def domain_randomize(model, rng):
    """What differs from one environment to the next: the model, and its in_axes.

    model is an mjx.Model of MJCF, rng holds a key for each environment. Constants that MuJoCo
    derives of masses and places (body_subtreemass, invweight0) stay as they are.
    """
    import jax
    import mujoco

    names = mujoco.MjModel.from_xml_string(MJCF)

    def body(name):
        return names.body(name).id

    def dof(name):
        return names.joint(name).dofadr[0]

    @jax.vmap
    def draw(rng):
        fields = {}

        def number(low, high):
            nonlocal rng
            rng, key = jax.random.split(rng)
            return jax.random.uniform(key, minval=low, maxval=high)

        def field(name):
            return fields.get(name, getattr(model, name))

        if TOTAL_MASS_FACTOR is not None:
            fields["body_mass"] = field("body_mass") * number(*TOTAL_MASS_FACTOR)
        for name, low, high in MASS_FACTOR:
            fields["body_mass"] = field("body_mass").at[body(name)].multiply(number(low, high))
        for name, low, high in INERTIA_FACTOR:
            fields["body_inertia"] = field("body_inertia").at[body(name)].multiply(number(low, high))
        for name, axis, low, high in CENTER_OF_MASS_M:
            fields["body_ipos"] = field("body_ipos").at[body(name), axis].add(number(low, high))
        for name, low, high in MOTOR_STRENGTH:
            factor = number(low, high)
            for key in ("actuator_gainprm", "actuator_biasprm", "actuator_forcerange"):
                fields[key] = field(key).at[names.actuator(name).id].multiply(factor)
        for name, low, high in DRY_FRICTION_NM:
            fields["dof_frictionloss"] = (
                field("dof_frictionloss").at[dof(name)].add(number(low, high))
            )
        if GROUND_FRICTION is not None:
            fields["geom_friction"] = field("geom_friction").at[:, 0].set(number(*GROUND_FRICTION))
        if BUS_VOLTAGE_FACTOR is not None:
            fields["actuator_ctrlrange"] = field("actuator_ctrlrange") * number(*BUS_VOLTAGE_FACTOR)
        return fields

    fields = draw(rng)
    in_axes = jax.tree_util.tree_map(lambda _: None, model)
    in_axes = in_axes.tree_replace({name: 0 for name in fields})
    return model.tree_replace(fields), in_axes
)";

EventText write(const DrawnParts& parts, const Robot&) {
  const Randomisation& stated = *parts.stated;
  EventText written;
  written.text = python_tables_of(parts) + python_rows("MOTOR_STRENGTH", parts.drive_strength) +
                 python_pair_or_none("GROUND_FRICTION", stated.friction_coefficient) +
                 python_pair_or_none("BUS_VOLTAGE_FACTOR", stated.bus_voltage_factor) +
                 std::string(kFunction);
  if (!parts.gain_factor.empty()) {
    written.left_out.emplace_back(
        "controller_gain_factor: gains are the environment's, no field of the model");
  }
  if (stated.restitution) {
    written.left_out.emplace_back(
        "restitution: MuJoCo's contacts have solref and solimp in its place");
  }
  if (!parts.start_position_rad.empty() || !parts.start_velocity_rad_s.empty()) {
    written.left_out.emplace_back("initial joint positions and velocities: reset()'s");
  }
  return written;
}

}  // namespace

const EventWriter playground_events = {
    .formats = {"playground"},
    .source =
        "https://github.com/google-deepmind/mujoco_playground "
        "mujoco_playground/_src/locomotion/go1/randomize.py",
    .advice =
        "randomization_fn=domain_randomize of the training. A fall of the voltage narrows "
        "ctrlrange: "
        "ctrl is a voltage.",
    .write = write,
};

}  // namespace torquewright::hopper::event_writers
