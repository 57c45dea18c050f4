// SPDX-License-Identifier: Apache-2.0
// A region as constants of one library, device and precision: what runs in a training loop.
#include "actuator/source_text/python_parts.hpp"

namespace torquewright::actuator {
namespace {

constexpr std::string_view kText = R"(

class RegionOn:
    """A region whose constants are arrays of one library, device and precision: Region.to().

    Nothing is looked up or filled in here, so that a compiler can trace it whole.
    """

    def __init__(self, region, tools):
        self.name = region.name
        self.tools = tools
        self.is_single = "64" not in str(tools.dtype)
        self.voltage_V, self.temperature_K = region.voltage_V, region.temperature_K
        table = region.table
        bounds = (table["least_Nm"], table["greatest_Nm"])
        self.straight = [
            _straight(table["speed_rad_s"], bound, self.is_single) for bound in bounds
        ]
        self.is_straight = None not in self.straight
        self.lines = _LinesOn(_Lines(table["speed_rad_s"], bounds, self.is_single), tools)
        self.rest = [tools.floats(rest) for rest in table["rest_Nm"]]
        self.jumps_at_rest = _jumps_at_rest(table)
        self.conditions = None
        if region.line is not None:
            self.conditions = _ScaledLine(region.line, region.grid, tools)
        elif region.grid is not None:
            self.conditions = _GridOn(region.grid, tools, self.is_single)
        self.drag = None if region.drag is None else _DragOn(region.drag, tools, self.is_single)
        self.launch = _Launch.of(self)

    def _bounds(self, velocity):
        tools = self.tools
        bounds = self.lines.at(tools.clip(velocity, self.lines.least, self.lines.most))
        if not self.jumps_at_rest:
            return bounds
        is_at_rest = velocity == 0.0
        return [tools.xp.where(is_at_rest, rest, of) for rest, of in zip(self.rest, bounds)]

    def limits(self, velocity, voltage=None, temperature=None):
        """Least and greatest torque [Nm] at a velocity [rad/s]; see Region.limits()."""
        if voltage is not None or temperature is not None:
            voltage = self.voltage_V if voltage is None else voltage
            temperature = self.temperature_K if temperature is None else temperature
            return self.conditions.limits(velocity, voltage, temperature)
        if self.is_straight:
            return [
                value + slope * self.tools.clip(velocity - anchor, low, high)
                for anchor, low, high, value, slope in self.straight
            ]
        return self._bounds(velocity)

    def clip(self, torque, velocity, voltage=None, temperature=None, out=None):
        """The torque [Nm] within the limits at a velocity [rad/s]; see Region.clip()."""
        if self.launch is not None and not self.tools.is_traced():
            answer = self.launch.clip(torque, velocity, voltage, temperature, out)
            if answer is not None:
                return answer
        if self.tools.piece:
            return self._clip_in_pieces(torque, velocity, voltage, temperature, out)
        least, greatest = self.limits(velocity, voltage, temperature)
        return self.tools.between(torque, least, greatest, out)

    def _clip_in_pieces(self, torque, velocity, voltage, temperature, out):
        """Long arrays of NumPy a piece after the other, each in the processor's near memory."""
        piece, tools = self.tools.piece, self.tools
        shape = getattr(torque, "shape", None)
        given = [of for of in (voltage, temperature) if hasattr(of, "shape")]
        is_short = shape != velocity.shape or velocity.size <= piece
        is_short = is_short or any(of.size > velocity.size for of in given)
        if is_short or not (out is None or out.flags.c_contiguous):
            return tools.between(torque, *self.limits(velocity, voltage, temperature), out)
        out = tools.xp.empty(shape, tools.dtype) if out is None else out
        parts = [
            tools.xp.broadcast_to(of, shape).reshape(-1) if hasattr(of, "shape") else of
            for of in (torque, velocity, voltage, temperature)
        ]
        answers = out.reshape(-1)
        if voltage is not None or temperature is not None:
            piece //= 8  # a sample takes more numbers
        for i in range(0, velocity.size, piece):
            part = slice(i, i + piece)
            one = [of[part] if hasattr(of, "shape") else of for of in parts]
            tools.between(one[0], *self.limits(*one[1:]), answers[part])
        return out

    def friction(self, velocity):
        """Friction [Nm] at a velocity [rad/s], with its sign; beyond its table it goes on as a line."""
        return self.drag.friction(velocity)

    def torque(self, torque, velocity, voltage=None, temperature=None):
        """The torque [Nm] that reaches the joint; see Region.torque()."""
        if self.launch is not None and not self.tools.is_traced():
            answer = self.launch.torque(torque, velocity, voltage, temperature)
            if answer is not None:
                return answer
        within = self.clip(torque, velocity, voltage, temperature)
        return within if self.drag is None else self.drag.through(within, velocity)


class _LinesOn:
    """_Lines as arrays."""

    def __init__(self, lines, tools):
        self.low, self.high = lines.low, lines.high
        self.least, self.most = lines.low - lines.beyond, lines.high + lines.beyond
        self.per_width, self.last, self.sides = lines.per_width, lines.cells - 1, lines.sides
        self.columns = len(lines.lines[0]) // 2
        self.is_laid_along, self.middle = lines.is_laid_along, 0.5 * (lines.low + lines.high)
        self.tools = tools
        self.breaks = tools.floats(_of_one_axis(lines.breaks))
        rows = [lines.lines[i] for i in lines.numbers]
        self.rows = [tools.floats(of) for of in zip(*rows)] if tools.piece else tools.floats(rows)

    def row(self, place):
        """The number of the line at a place, among those of all cells."""
        tools = self.tools
        if self.is_laid_along:
            xp = tools.xp
            near = xp.minimum(place - self.low, self.high - place)
            root = xp.sqrt(xp.sqrt(tools.at_least(near, 0.0))) * self.per_width
            is_second = tools.count(place > self.middle)
            cell = tools.cell(root, self.last // 2)
            cell = cell + is_second * (self.last - 2 * cell)
        else:
            cell = tools.cell((place - self.low) * self.per_width, self.last)
        return cell * self.sides + self.tools.passed(self.breaks, cell, place)

    def at(self, place):
        """The values of all columns at a place: of one gather, but where columns are quicker, or a
        compiler makes one kernel of what is of one shape."""
        tools, row, count = self.tools, self.row(place), self.columns
        if tools.is_traced():
            x = place - self.rows[:, 0][row]
            columns = range(1, 1 + count)
            return [self.rows[:, i][row] + x * self.rows[:, count + i][row] for i in columns]
        if tools.piece:
            x = place - self.rows[0].take(row)
            values, slopes = self.rows[1 : 1 + count], self.rows[1 + count :]
            return [one.take(row) + slope.take(row) * x for one, slope in zip(values, slopes)]
        line = tools.take(self.rows, row)
        x = place[..., None] - line[..., 0:1]
        found = tools.line(line[..., 1 : 1 + count], line[..., 1 + count :], x)
        return [found[..., i] for i in range(count)]


def _of_one_axis(breaks):
    """The points of cells, as numbers where each has one."""
    return [one for (one,) in breaks] if len(breaks[0]) == 1 else breaks


class _DragOn:
    """Friction between the motor and the load, and what of a torque passes the gear."""

    def __init__(self, drag, tools, is_single):
        self.tools = tools
        self.smoothing_rad_s, self.limit_Nm = drag["smoothing_rad_s"], drag["limit_Nm"]
        self.mean = 0.5 * (drag["driving"] + drag["braking"])
        self.half = 0.5 * (drag["driving"] - drag["braking"])
        both = (drag["forward_Nm"], drag["backward_Nm"])
        lines = _Lines(drag["speed_rad_s"], both, is_single, goes_on=True)
        self.only = lines.lines[0] if len(lines.lines) == 1 else None
        self.lines = None if self.only else _LinesOn(lines, tools)

    def friction(self, velocity):
        size = self.tools.xp.abs(velocity)
        if self.only is not None:
            start, forward, backward, forward_slope, backward_slope = self.only
            forward = forward + forward_slope * (size - start)
            backward = backward + backward_slope * (size - start)
        else:
            forward, backward = self.lines.at(size)
        way = self.tools.xp.tanh(velocity / self.smoothing_rad_s)
        return 0.5 * (backward * (1.0 - way) - forward * (1.0 + way))

    def through(self, within, velocity):
        """What reaches the joint of a torque before friction and gear."""
        before = within + self.friction(velocity)
        way = self.tools.xp.tanh(velocity / self.smoothing_rad_s)
        after = self.mean * before + self.half * self.tools.xp.abs(before) * way
        if self.limit_Nm is None:
            return after
        return self.tools.clip(after, -self.limit_Nm, self.limit_Nm)


def _jumps_at_rest(table):
    """Whether at rest the bounds are other than just above it, which is all that lines know."""
    found = _Lines(table["speed_rad_s"], (table["least_Nm"], table["greatest_Nm"]), False)
    line = found.lines[sum(1 for knot in found.knots if knot <= 0.0)]
    bounds = [line[1] - line[0] * line[3], line[2] - line[0] * line[4]]
    scale = 1e-9 * max(map(abs, table["rest_Nm"]))
    return any(abs(one - rest) > scale for one, rest in zip(bounds, table["rest_Nm"]))


def _straight(points, values, is_single):
    """A bound with one slope, as (anchor, low, high, value, slope) of value + slope *
    clip(speed - anchor, low, high); None for other shapes."""
    slopes, rounding = [], 2e-12 * max(map(abs, values))
    for i in range(len(points) - 1):
        if abs(values[i + 1] - values[i]) <= rounding:
            continue
        if points[i + 1] <= points[i]:
            return None
        slopes.append(i)
    if len(slopes) != 1:
        return None
    i = slopes[0]
    slope = (values[i + 1] - values[i]) / (points[i + 1] - points[i])
    anchor = 0.5 * (points[i] + points[i + 1])
    anchor = _single(anchor) if is_single else anchor
    return (
        anchor,
        points[i] - anchor,
        points[i + 1] - anchor,
        values[i] + slope * (anchor - points[i]),
        slope,
    )


DriveState = collections.namedtuple("DriveState", "winding_K case_K current_A")


def _warmed(thermal, winding_K, case_K, loss_W, dt):
    """Winding and case after a step that is short beside their time constants."""

    def rates(winding, case):
        inner_W = (winding - case) / thermal["winding_to_case_K_W"]
        outer_W = (case - thermal["ambient_K"]) / thermal["case_to_ambient_K_W"]
        return (loss_W - inner_W) / thermal["winding_J_K"], (inner_W - outer_W) / thermal["case_J_K"]

    first = rates(winding_K, case_K)
    middle = rates(winding_K + 0.5 * dt * first[0], case_K + 0.5 * dt * first[1])
    return winding_K + dt * middle[0], case_K + dt * middle[1]
)";

}  // namespace

std::string_view python_tables() { return kText; }

}  // namespace torquewright::actuator
