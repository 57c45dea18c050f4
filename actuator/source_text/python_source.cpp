// SPDX-License-Identifier: Apache-2.0
// What it calls is in the array API standard (data-apis.org/array-api, 2024.12: asarray,
// searchsorted, where, clip, minimum, maximum, indexing by arrays of integers) and in PyTorch 1.13
// and NumPy 1.24 alike.
#include "actuator/source_text/python_source.hpp"

namespace torquewright::actuator {
namespace {

constexpr std::string_view kRegion = R"(
import sys


def _namespace(array):
    """The array's own library. It is loaded, since its array is here: nothing is imported."""
    if hasattr(array, "__array_namespace__"):
        return array.__array_namespace__()
    library = type(array).__module__.partition(".")[0]
    if library == "builtins":
        raise TypeError("velocity must be an array of floats, as of NumPy, PyTorch or JAX")
    return sys.modules["jax.numpy" if library in ("jax", "jaxlib") else library]


class Region:
    """The torques that an actuator can have, by velocity, supply voltage and temperature."""

    def __init__(self, name, peak_torque_Nm, armature_kg_m2, voltage_V, temperature_K, table, grid):
        self.name = name
        self.peak_torque_Nm = peak_torque_Nm
        self.armature_kg_m2 = armature_kg_m2
        self.voltage_V = voltage_V
        self.temperature_K = temperature_K
        self.table = table
        self.grid = grid
        self._lists = {"rest": table["rest_Nm"]}
        self._kept = {}
        self._add_lines("speed", table["speed_rad_s"])
        for bound in ("least", "greatest"):
            self._add_values(bound, table[bound + "_Nm"])
        if grid is None:
            return
        self._lists["voltages"] = grid["voltage_V"]
        self._lists["temperatures"] = grid["temperature_K"]
        for bound in ("least", "greatest"):
            of = grid[bound]
            self._add_lines(bound + " places", of["place"])
            self._lists[bound + " corners"] = [w for row in of["corner_rad_s"] for w in row]
            self._lists[bound + " torques"] = [t for row in of["torque_Nm"] for t in row]

    def _add_lines(self, name, points):
        widths = [after - before for before, after in zip(points, points[1:])]
        self._lists[name] = points
        self._lists[name + " per width"] = [1.0 / w if w > 0.0 else 0.0 for w in widths] + [0.0]

    def _add_values(self, name, values):
        self._lists[name] = values
        changes = [after - before for before, after in zip(values, values[1:])]
        self._lists[name + " change"] = changes + [0.0]

    def _constant(self, xp, name, like):
        """A list as an array beside `like`; kept, but for JAX, whose traces must not meet."""
        if "jax" in xp.__name__:
            return xp.asarray(self._lists[name], dtype=like.dtype)
        key = (name, like.dtype, getattr(like, "device", None))
        if key not in self._kept:
            place = {"device": like.device} if xp.__name__ == "torch" else {}
            self._kept[key] = xp.asarray(self._lists[name], dtype=like.dtype, **place)
        return self._kept[key]

    def _row(self, xp, name, value):
        """Which points lie before a value, and the share of the way to the next."""
        ends = self._lists[name][0], self._lists[name][-1]
        value = xp.clip(value, *ends)
        points = self._constant(xp, name, value)
        row = xp.clip(xp.searchsorted(points, value, side="right") - 1, 0, len(self._lists[name]) - 1)
        per_width = self._constant(xp, name + " per width", value)
        return row, xp.clip((value - points[row]) * per_width[row], 0.0, 1.0)

    def _cell(self, xp, name, value, like):
        """Of an axis of the grid: numbers of the two values around one, and the share between."""
        axis = self._constant(xp, name, like)
        last = len(self._lists[name]) - 1
        if last == 0:
            return 0, 0, 0.0
        if not hasattr(value, "shape"):
            value = 0.0 * axis[0] + value
        row = xp.clip(xp.searchsorted(axis, value, side="right") - 1, 0, last - 1)
        share = (value - axis[row]) / (axis[row + 1] - axis[row])
        return row, row + 1, xp.clip(share, 0.0, 1.0)

    def _mixture(self, xp, voltage, temperature, like):
        """The conditions around one, and how much of each."""
        v0, v1, v = self._cell(xp, "voltages", voltage, like)
        t0, t1, t = self._cell(xp, "temperatures", temperature, like)
        columns = len(self.grid["temperature_K"])
        mixture = [(v0 * columns + t0, (1.0 - v) * (1.0 - t))]
        if columns > 1:
            mixture.append((v0 * columns + t1, (1.0 - v) * t))
        if len(self.grid["voltage_V"]) > 1:
            mixture.append((v1 * columns + t0, v * (1.0 - t)))
            if columns > 1:
                mixture.append((v1 * columns + t1, v * t))
        return mixture

    def _conditions(self, xp, name, count, mixture, like):
        """A list of every condition, `count` numbers each; one mixed list, where all share it."""
        values = self._constant(xp, name, like)
        if any(getattr(condition, "ndim", 0) > 0 for condition, _ in mixture):
            return values, mixture
        rows = xp.reshape(values, (-1, count))
        return sum(weight * rows[condition] for condition, weight in mixture), [(0, 1.0)]

    def _grid_bound(self, xp, name, velocity, mixture, pick):
        """A bound between conditions: corners and the torques at a place are mixed."""
        count = len(self.grid[name]["corner_rad_s"][0])
        places = len(self.grid[name]["place"])
        corners, mixture_of_corners = self._conditions(
            xp, name + " corners", count, mixture, velocity
        )
        torques, mixture = self._conditions(xp, name + " torques", places, mixture, velocity)

        def mixed(values, width, i, mixture):
            return sum(weight * values[condition * width + i] for condition, weight in mixture)

        corner = [mixed(corners, count, i, mixture_of_corners) for i in range(count)]
        one = corner[0] * 0.0 + 1.0
        low, high, place = corner[0], corner[1], 0.0 * one
        for i in range(1, count - 1):
            passed = velocity >= corner[i]
            low = xp.where(passed, corner[i], low)
            high = xp.where(passed, corner[i + 1], high)
            place = xp.where(passed, i * one, place)
        has_width = high > low
        share = (velocity - low) / xp.where(has_width, high - low, one)
        place = place + xp.where(has_width, xp.clip(share, 0.0, 1.0), 0.0 * one)
        row, share = self._row(xp, name + " places", place)
        after = xp.clip(row + 1, 0, places - 1)
        before = mixed(torques, places, row, mixture)
        bound = before + share * (mixed(torques, places, after, mixture) - before)
        at_rest = self.grid[name]["rest_place"]
        from_below = mixed(torques, places, at_rest, mixture)
        rest = pick(from_below, mixed(torques, places, at_rest + 1, mixture))
        return xp.where(velocity == 0.0, rest, bound)

    def limits(self, velocity, voltage=None, temperature=None):
        """Least and greatest torque [Nm] at a velocity [rad/s].

        Without voltage and temperature the region is that of its table. With either, numbers or
        arrays that broadcast, it is interpolated in the grid; beyond the grid its edge holds.
        The voltage is that of the supply without load: its sag is in the region. [V], [K].
        """
        xp = _namespace(velocity)
        if voltage is None and temperature is None:
            row, share = self._row(xp, "speed", velocity)
            rest = self._constant(xp, "rest", velocity)
            is_at_rest = velocity == 0.0
            bounds = []
            for i, name in enumerate(("least", "greatest")):
                change = self._constant(xp, name + " change", velocity)
                bound = self._constant(xp, name, velocity)[row] + share * change[row]
                bounds.append(xp.where(is_at_rest, rest[i], bound))
            return bounds
        if self.grid is None:
            raise ValueError(self.name + ": no grid over voltage and temperature in this file")
        voltage = self.voltage_V if voltage is None else voltage
        temperature = self.temperature_K if temperature is None else temperature
        mixture = self._mixture(xp, voltage, temperature, velocity)
        return [
            self._grid_bound(xp, "least", velocity, mixture, xp.minimum),
            self._grid_bound(xp, "greatest", velocity, mixture, xp.maximum),
        ]

    def clip(self, torque, velocity, voltage=None, temperature=None):
        """The torque [Nm] within the limits at a velocity [rad/s]: arrays of floats, one shape."""
        xp = _namespace(velocity)
        least, greatest = self.limits(velocity, voltage, temperature)
        raised = xp.where(torque < least, least, torque)
        clipped = xp.where(raised > greatest, greatest, raised)
        return xp.where(velocity == velocity, clipped, velocity)  # what is no number stays none
)";

/// Between the motor and the load, where a command is the motor's. The dry part turns over with
/// tanh; what passes the gear depends on the sign of torque times motion, which turns over alike:
/// (d + b)/2 x + (d - b)/2 |x| tanh(velocity / smoothing), d driving and b braking.
constexpr std::string_view kFriction = R"(
    def add_friction(
        self, speed_rad_s, forward_Nm, backward_Nm, driving, braking, limit_Nm, smoothing_rad_s
    ):
        """Friction over the size of the speed, each way, and what of a torque passes the gear."""
        self._add_lines("size", speed_rad_s)
        self._add_values("forward", forward_Nm)
        self._add_values("backward", backward_Nm)
        self.driving = driving
        self.braking = braking
        self.limit_Nm = limit_Nm
        self.smoothing_rad_s = smoothing_rad_s
        self.joint_peak_torque_Nm = braking * (self.peak_torque_Nm + max(forward_Nm + backward_Nm))
        if limit_Nm is not None:
            self.joint_peak_torque_Nm = min(self.joint_peak_torque_Nm, limit_Nm)

    def friction(self, velocity):
        """Friction [Nm] at a velocity [rad/s], with its sign; beyond its table it goes on as a line."""
        xp = _namespace(velocity)
        size = xp.abs(velocity)
        points = self._constant(xp, "size", velocity)
        row = xp.searchsorted(points, size, side="right") - 1
        row = xp.clip(row, 0, len(self._lists["size"]) - 2)
        share = (size - points[row]) * self._constant(xp, "size per width", velocity)[row]
        forward, backward = [
            self._constant(xp, name, velocity)[row]
            + share * self._constant(xp, name + " change", velocity)[row]
            for name in ("forward", "backward")
        ]
        way = xp.tanh(velocity / self.smoothing_rad_s)
        return 0.5 * (backward * (1.0 - way) - forward * (1.0 + way))

    def torque(self, torque, velocity, voltage=None, temperature=None):
        """The torque [Nm] that reaches the joint for one that the motor is commanded, in Nm there.

        The command is clipped as the motor is; friction and the gear's losses are taken off it,
        driving and braking each by its own. Within some smoothing_rad_s of rest all that fades.
        """
        xp = _namespace(velocity)
        before = self.clip(torque, velocity, voltage, temperature) + self.friction(velocity)
        way = xp.tanh(velocity / self.smoothing_rad_s)
        mean = 0.5 * (self.driving + self.braking)
        half = 0.5 * (self.driving - self.braking)
        after = mean * before + half * xp.abs(before) * way
        if self.limit_Nm is None:
            return after
        return xp.clip(after, -self.limit_Nm, self.limit_Nm)
)";

}  // namespace

std::string python_source(bool has_friction) {
  return std::string(kRegion) + (has_friction ? std::string(kFriction) : "");
}

}  // namespace torquewright::actuator
