// SPDX-License-Identifier: Apache-2.0
// Newton has no terms: a model is built of builders, one for each world, and what varies is written
// into a builder before it is copied. Fields: newton/_src/sim/builder.py @ 8f0ed996, ModelBuilder:
// body_mass (kg) and body_inertia (kg m^2, about the centre of mass) with their inverses, body_com
// (m), joint_friction (N m, by degree of freedom, joint_qd_start), shape_material_mu and
// shape_material_restitution.
#include "hopper/randomised_files/every_event_writer.hpp"
#include "hopper/randomised_files/python_terms.hpp"

namespace torquewright::hopper::event_writers {
namespace {

constexpr std::string_view kFunction = R"(

def randomise(builder, bodies, joints, random):
    """Draws one robot into a newton.ModelBuilder that holds one, behind add_actuators().

    bodies and joints are indices by names, random is a random.Random. One builder, drawn anew, for
    each world: its own copy of what was loaded.
    """

    def scale_mass(index, factor):
        builder.body_mass[index] *= factor
        builder.body_inv_mass[index] /= factor

    if TOTAL_MASS_FACTOR is not None:
        factor = random.uniform(*TOTAL_MASS_FACTOR)
        for index in bodies.values():
            scale_mass(index, factor)
    for name, low, high in MASS_FACTOR:
        scale_mass(bodies[name], random.uniform(low, high))
    for name, low, high in INERTIA_FACTOR:
        factor = random.uniform(low, high)
        index = bodies[name]
        builder.body_inertia[index] = builder.body_inertia[index] * factor
        builder.body_inv_inertia[index] = builder.body_inv_inertia[index] * (1.0 / factor)
    for name, axis, low, high in CENTER_OF_MASS_M:
        place = builder.body_com[bodies[name]]
        moved = [float(place[i]) for i in range(3)]
        moved[axis] += random.uniform(low, high)
        builder.body_com[bodies[name]] = type(place)(*moved)
    for name, low, high in DRY_FRICTION_NM:
        builder.joint_friction[builder.joint_qd_start[joints[name]]] += random.uniform(low, high)
    for field, span in (
        (builder.shape_material_mu, GROUND_FRICTION),
        (builder.shape_material_restitution, RESTITUTION),
    ):
        if span is not None:
            value = random.uniform(*span)
            for shape in range(len(field)):
                field[shape] = value


def motor_strength(random):
    """Factors by joint on what their motors make: add_actuators(..., strength=...)."""
    return {name: random.uniform(low, high) for name, low, high in MOTOR_STRENGTH}
)";

EventText write(const DrawnParts& parts, const Robot&) {
  const Randomisation& stated = *parts.stated;
  EventText written;
  written.text = python_tables_of(parts) + python_rows("MOTOR_STRENGTH", parts.strength_factor) +
                 python_pair_or_none("GROUND_FRICTION", stated.friction_coefficient) +
                 python_pair_or_none("RESTITUTION", stated.restitution) + std::string(kFunction);
  if (!parts.gain_factor.empty()) {
    written.left_out.emplace_back(
        "controller_gain_factor: kp and kd are arguments of add_actuators(), one draw for each "
        "builder");
  }
  if (stated.bus_voltage_factor) {
    written.left_out.push_back(
        fmt::format("bus_voltage_factor {}: ClampingDCMotor has no voltage; clip(..., voltage=...) "
                    "of `actuator "
                    "mor --format python` takes it",
                    python_pair(*stated.bus_voltage_factor)));
  }
  if (!parts.start_position_rad.empty() || !parts.start_velocity_rad_s.empty()) {
    written.left_out.emplace_back("initial joint positions and velocities: the state's");
  }
  return written;
}

}  // namespace

const EventWriter newton_events = {
    .formats = {"newton"},
    .source = "https://github.com/newton-physics/newton newton/_src/sim/builder.py @ 8f0ed996",
    .advice =
        "randomise(builder, bodies, joints, random.Random(seed)) on a builder of one robot for "
        "each world, before it is added to the scene's; motor_strength(random) for "
        "add_actuators(). "
        "Friction of contacts is made of both "
        "shapes': see the ground's.",
    .write = write,
};

}  // namespace torquewright::hopper::event_writers
