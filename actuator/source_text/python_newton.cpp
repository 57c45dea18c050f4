// SPDX-License-Identifier: Apache-2.0
// Isaac Lab 3 writes explicit actuators as prims of USD by default (SimulationCfg's
// use_newton_actuators, pull request 7713), and only those whose configuration and class are its
// own: _is_newton_native_actuator_cfg of isaaclab/sim/schemas/schemas_actuators.py @ 0120677c. A
// DCMotorCfg becomes NewtonPDControlAPI and NewtonDCMotorClampingAPI, with newton:saturationEffort,
// newton:velocityLimit and newton:maxMotorEffort. Newton's parser asks its registry who reads a
// schema: register_actuator_component(schema_name, component_class, kind) of
// newton/_src/actuators/usd_parser.py as of Newton 1.6, where component_class may be a callable
// that takes the parsed arguments and returns the class, and a schema that is known is replaced
// with a warning. So the DC motor's schema is read by whoever its three numbers belong to. A
// component: ClampingDCMotor of newton/_src/actuators/clamping/clamping_dc_motor.py @ 1f5efb33
// (resolve_arguments, arrays of one value for each degree of freedom) and Clamping in base.py @
// 081a5a0c (finalize, modify_forces). Prims hold single precision.
#include "actuator/source_text/python_newton.hpp"

#include <string_view>

namespace torquewright::actuator {
namespace {

constexpr std::string_view kNewton = R"(
    def warp_clip(self):
        """A wp.func for kernels of one's own: clip(torque, velocity, shape, breaks, rows).

        The last three are warp_tables(device): the packed tables of to(), in single precision. What
        is no number stays none.
        """
        if "clip" in self._warp:
            return self._warp["clip"]
        import warp as wp

        @wp.func
        def clip_to_region(
            torque: float,
            velocity: float,
            shape: wp.array(dtype=float),
            breaks: wp.array(dtype=float),
            rows: wp.array(dtype=float),
        ):
            place = wp.clamp(velocity, shape[2], shape[3])
            last = int(shape[5])
            most = int(shape[6])
            cell = int(0)
            if shape[7] > 0.0:
                near = wp.max(wp.min(place - shape[0], shape[1] - place), 0.0)
                cell = wp.min(int(wp.sqrt(wp.sqrt(near)) * shape[4]), last // 2)
                if place > shape[8]:
                    cell = last - cell
            else:
                cell = wp.clamp(int((place - shape[0]) * shape[4]), 0, last)
            row = int(cell * (most + 1))
            for i in range(most):
                if place >= breaks[cell * most + i]:
                    row += 1
            x = place - rows[5 * row]
            least = rows[5 * row + 1] + x * rows[5 * row + 3]
            greatest = rows[5 * row + 2] + x * rows[5 * row + 4]
            if velocity == 0.0:
                least = shape[9]
                greatest = shape[10]
            clipped = wp.min(wp.max(torque, least), greatest)
            if wp.isnan(torque) or wp.isnan(velocity):
                clipped = torque + velocity
            return clipped

        self._warp["clip"] = clip_to_region
        return clip_to_region

    def warp_tables(self, device=None):
        """What the function of warp_clip() reads, as arrays of Warp."""
        import warp as wp

        bounds = self.table["least_Nm"], self.table["greatest_Nm"]
        lines = _Lines(self.table["speed_rad_s"], bounds, True)
        shape = [lines.low, lines.high, lines.low - lines.beyond, lines.high + lines.beyond]
        shape += [lines.per_width, lines.cells - 1, lines.most, lines.is_laid_along]
        shape += [0.5 * (lines.low + lines.high), *self.table["rest_Nm"]]
        breaks = [one for cell in lines.breaks for one in cell]
        rows = [one for number in lines.numbers for one in lines.lines[number]]
        return [
            wp.array([float(one) for one in of], dtype=wp.float32, device=device)
            for of in (shape, breaks, rows)
        ]

    def _newton_kernel(self):
        """What Warp compiles: the table's clip, then friction and gear where they are known."""
        import warp as wp

        clip = self.warp_clip()

        @wp.func
        def between(x: float, points: wp.array(dtype=float), values: wp.array(dtype=float), most: float):
            low = int(0)
            high = int(points.shape[0] - 1)
            while high - low > 1:
                middle = (low + high) // 2
                if points[middle] <= x:
                    low = middle
                else:
                    high = middle
            width = points[high] - points[low]
            share = float(0.0)
            if width > 0.0:
                share = wp.clamp((x - points[low]) / width, 0.0, most)
            return values[low] + share * (values[high] - values[low])

        @wp.kernel
        def clamp_to_region(
            velocities: wp.array(dtype=float),
            vel_indices: wp.array(dtype=wp.uint32),
            shape: wp.array(dtype=float),
            breaks: wp.array(dtype=float),
            rows: wp.array(dtype=float),
            size: wp.array(dtype=float),
            forward: wp.array(dtype=float),
            backward: wp.array(dtype=float),
            passing: wp.array(dtype=float),
            src: wp.array(dtype=float),
            dst: wp.array(dtype=float),
        ):
            i = wp.tid()
            velocity = velocities[vel_indices[i]]
            torque = clip(src[i], velocity, shape, breaks, rows)
            if size.shape[0] > 1:
                way = wp.tanh(velocity / passing[3])
                ahead = between(wp.abs(velocity), size, forward, 1.0e30)
                behind = between(wp.abs(velocity), size, backward, 1.0e30)
                before = torque + 0.5 * (behind * (1.0 - way) - ahead * (1.0 + way))
                mean = 0.5 * (passing[0] + passing[1])
                half = 0.5 * (passing[0] - passing[1])
                torque = wp.clamp(mean * before + half * wp.abs(before) * way, -passing[2], passing[2])
            dst[i] = torque

        return clamp_to_region

    def _newton_arrays(self, device):
        import warp as wp

        drag = self.drag or {}
        limit = drag.get("limit_Nm")
        lists = [drag.get(name, [0.0]) for name in ("speed_rad_s", "forward_Nm", "backward_Nm")]
        lists.append(
            [
                drag.get("driving", 1.0),
                drag.get("braking", 1.0),
                3.0e38 if limit is None else limit,
                drag.get("smoothing_rad_s", 1.0),
            ]
        )
        arrays = [wp.array(of, dtype=wp.float32, device=device) for of in lists]
        return self.warp_tables(device) + arrays

    def newton_arguments(self):
        """The arguments of Newton's ClampingDCMotor by which this region is known."""
        return {
            "saturation_effort": self.peak_torque_Nm,
            "velocity_limit": self.table["speed_rad_s"][-1],
            "max_motor_effort": self.peak_torque_Nm,
        }

    def newton_clamping(self):
        """A clamping component of Newton's actuators that holds to this region.

        builder.add_actuator(..., clamping=[(REGION.newton_clamping(), REGION.newton_arguments())]).
        It is the region at the voltage and temperature of its table, in single precision.
        """
        if "clamping" in self._warp:
            return self._warp["clamping"]
        import warp as wp
        from newton.actuators import ClampingDCMotor

        of_region = self
        kernel = self._newton_kernel()

        class RegionClamping(ClampingDCMotor):
            region = of_region

            def finalize(self, device, num_actuators):
                super().finalize(device, num_actuators)
                self._region_arrays = self.region._newton_arrays(device)

            def modify_forces(
                self,
                src_forces,
                dst_forces,
                positions,
                velocities,
                pos_indices,
                vel_indices,
                device=None,
            ):
                wp.launch(
                    kernel=kernel,
                    dim=len(src_forces),
                    inputs=[velocities, vel_indices, *self._region_arrays, src_forces],
                    outputs=[dst_forces],
                    device=device,
                )

        self._warp["clamping"] = RegionClamping
        return RegionClamping

    def register_with_newton(self):
        """Has Newton read a DC motor of this region's three numbers as this region.

        A DC motor of other numbers stays what it was. Single precision is all that USD keeps.
        """
        import warnings

        from newton import actuators

        def is_same(one, other):
            return all(abs(one.get(name, 0.0) - of) <= 1e-6 * abs(of) for name, of in other.items())

        known = getattr(actuators, "torquewright_regions", None)
        if known is None:
            known = actuators.torquewright_regions = []
            own = actuators.ClampingDCMotor

            def component_of(arguments):
                for region in known:
                    if is_same(arguments, region.newton_arguments()):
                        return region.newton_clamping()
                return own

            with warnings.catch_warnings():
                warnings.simplefilter("ignore")  # that the schema is known already
                actuators.register_actuator_component(
                    "NewtonDCMotorClampingAPI", component_of, actuators.ComponentKind.CLAMPING
                )
        for other in list(known):
            if not is_same(other.newton_arguments(), self.newton_arguments()):
                continue
            if other.table != self.table:
                raise ValueError(
                    self.name + " and " + other.name + ": Newton cannot tell their regions apart"
                )
            known.remove(other)
        known.append(self)

    def isaac_lab_native(self, joint_names_expr, stiffness, damping, **more):
        """Isaac Lab's configuration of joints that this actuator drives, for its native actuators.

        Those are the default of Isaac Lab 3. With SimulationCfg(use_newton_actuators=False), and in
        older versions, isaac_lab() is the one: of this Isaac Lab would then know three numbers.
        """
        from isaaclab.actuators import DCMotorCfg

        self.register_with_newton()
        known_by = self.newton_arguments()
        given = {
            "joint_names_expr": joint_names_expr,
            "stiffness": stiffness,
            "damping": damping,
            "saturation_effort": known_by["saturation_effort"],
            "actuator_velocity_limit": known_by["velocity_limit"],
            "actuator_effort_limit": known_by["max_motor_effort"],
            "joint_effort_limit": JOINT_EFFORT_LIMIT,
            "armature": self.armature_kg_m2,
            "friction": 0.0,
            "dynamic_friction": 0.0,
            "viscous_friction": 0.0,
        }
        given.update(more)
        return DCMotorCfg(**given)
)";

}  // namespace

std::string python_newton(bool has_friction) {
  constexpr std::string_view kPlace = "JOINT_EFFORT_LIMIT";
  std::string text(kNewton);
  text.replace(text.find(kPlace), kPlace.size(),
               has_friction ? "self.joint_peak_torque_Nm" : "self.peak_torque_Nm");
  return text;
}

}  // namespace torquewright::actuator
