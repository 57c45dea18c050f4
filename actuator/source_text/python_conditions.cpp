// SPDX-License-Identifier: Apache-2.0
// The region over supply voltage and winding temperature, as arrays.
#include "actuator/source_text/python_parts.hpp"

namespace torquewright::actuator {
namespace {

constexpr std::string_view kText = R"(

class _ScaledLine:
    """A winding's line over voltage and temperature, exactly: it moves with the voltage, and tilts
    with the resistance. The current's limit stays."""

    def __init__(self, line, grid, tools):
        self.tools = tools
        self.torque_Nm_V, self.V_s_rad = line["torque_Nm_V"], line["V_s_rad"]
        self.greatest_Nm = line["greatest_Nm"]
        self.per_K, self.at_K = line["per_K"], line["at_K"]
        self.voltages = grid["voltage_V"][0], grid["voltage_V"][-1]
        self.temperatures = grid["temperature_K"][0], grid["temperature_K"][-1]

    def limits(self, velocity, voltage, temperature):
        tools = self.tools
        voltage = _within(tools, voltage, self.voltages)
        warmer = _within(tools, temperature, self.temperatures) - self.at_K
        torque_Nm_V = self.torque_Nm_V / (1.0 + self.per_K * warmer)
        lost = self.V_s_rad * velocity
        most = self.greatest_Nm
        return [
            tools.clip(torque_Nm_V * (-voltage - lost), -most, most),
            tools.clip(torque_Nm_V * (voltage - lost), -most, most),
        ]


def _within(tools, value, ends):
    """The value, or the nearer end: a number or an array."""
    if hasattr(value, "shape"):
        return tools.clip(value, *ends)
    return min(max(value, ends[0]), ends[1])


class _Axis:
    """Values at which a grid has been computed; a place among them is 1.25 a quarter past the
    second."""

    def __init__(self, values, tools):
        self.tools = tools
        self.count = len(values)
        self.ends = values[0], values[-1]
        widths = [after - before for before, after in zip(values, values[1:])]
        even = (values[-1] - values[0]) / max(1, len(widths))
        self.per_value = 1.0 / even if even > 0.0 else 0.0
        self.is_even = all(abs(width - even) <= 1e-12 * abs(values[-1]) for width in widths)
        if not self.is_even:
            self.starts = tools.floats(values[:-1])
            self.per_width = tools.floats([1.0 / width for width in widths])

    def cell(self, value):
        """The number of the value before, and the share of the way to the next."""
        tools = self.tools
        if self.is_even:
            place = (tools.clip(value, *self.ends) - self.ends[0]) * self.per_value
        else:
            parts = tools.clip((value[..., None] - self.starts) * self.per_width, 0.0, 1.0)
            place = tools.xp.sum(parts, axis=-1)
        row = tools.cell(place, max(0, self.count - 2))
        return row, tools.past(place, row)


class _GridOn:
    """A region's grid over voltage and temperature as arrays.

    Between conditions both the corners of a bound and the torques at a place between corners are
    linear. Both bounds stand side by side, and what four conditions say of one row lies together:
    one gather of the corners, one of the torques. Where corners meet, a bound's step is a ramp.
    """

    def __init__(self, grid, tools, is_single):
        self.tools = tools
        self.voltages = _Axis(grid["voltage_V"], tools)
        self.temperatures = _Axis(grid["temperature_K"], tools)
        bounds = [grid["least"], grid["greatest"]]
        corners = [_padded(of["corner_rad_s"]) for of in bounds]
        most = max(len(of[0]) for of in corners)
        corners = [_padded(of, most) for of in corners]
        self.corners = tools.floats(
            [
                [[[of[c][i] for c in four] for i in range(most)] for of in corners]
                for four in self._fours()
            ]
        )
        fastest = max(abs(speed) for of in corners for row in of for speed in row)
        self.ramp = (1e-6 if is_single else 1e-12) * fastest
        self._keep_torques(bounds, float(most - 1), is_single)

    def _fours(self):
        """Of each cell the numbers of the conditions about it, temperatures within voltages."""
        columns = self.temperatures.count
        for v in range(max(1, self.voltages.count - 1)):
            for t in range(max(1, columns - 1)):
                yield [
                    min(v + i, self.voltages.count - 1) * columns + min(t + j, columns - 1)
                    for i in (0, 1)
                    for j in (0, 1)
                ]

    def _keep_torques(self, bounds, last_place, is_single):
        """Lines over the place, of every condition; the cells of places are the same in all."""
        tools = self.tools
        lines = [
            _Lines(*_with_end(of["place"], of["torque_Nm"], last_place), is_single) for of in bounds
        ]
        most, cells = max(of.most for of in lines), max(of.cells for of in lines)
        for of in lines + lines + lines[:1]:
            of.use(cells, most)
            most = of.most
        self.sides, self.last, self.per_width = most + 1, cells - 1, lines[0].per_width
        self.breaks = tools.floats(_of_one_axis(lines[0].breaks + lines[1].breaks))
        first = len(lines[0].lines)
        self.numbers = tools.whole(lines[0].numbers + [first + i for i in lines[1].numbers])
        self.count = first + len(lines[1].lines)
        half = len(bounds[0]["torque_Nm"])
        self.torques = tools.floats(
            [
                [line[0], *(line[1 + c] for c in four), *(line[1 + half + c] for c in four)]
                for four in self._fours()
                for of in lines
                for line in of.lines
            ]
        )
        self.rest = tools.floats(
            [
                [
                    [[of["torque_Nm"][c][of["rest_place"] + i] for c in four] for i in (0, 1)]
                    for of in bounds
                ]
                for four in self._fours()
            ]
        )
        self.bound_cells = tools.whole([0, cells])

    def _mixed(self, four, by_voltage, by_temperature):
        """What two shares make of numbers of four conditions in the last axis."""
        mixed = self.tools.mixed
        two = mixed(four[..., 0::2], four[..., 1::2], by_temperature[..., None])
        return mixed(two[..., 0], two[..., 1], by_voltage)

    def limits(self, velocity, voltage, temperature):
        tools = self.tools
        if tools.is_traced():
            return self._limits_traced(velocity, voltage, temperature)
        v, by_voltage = self.voltages.cell(_array(tools, voltage))
        t, by_temperature = self.temperatures.cell(_array(tools, temperature))
        condition = v * max(1, self.temperatures.count - 1) + t
        by_voltage, by_temperature = by_voltage[..., None], by_temperature[..., None]
        corner = self._mixed(
            tools.take(self.corners, condition), by_voltage[..., None], by_temperature[..., None]
        )
        width = tools.at_least(corner[..., 1:] - corner[..., :-1], self.ramp)
        parts = (velocity[..., None, None] - corner[..., :-1]) / width
        place = tools.xp.sum(tools.clip(parts, 0.0, 1.0), axis=-1)
        row = tools.take(self.numbers, self._row(place)) + (condition * self.count)[..., None]
        line = tools.take(self.torques, row)
        x = place - line[..., 0]
        four = tools.line(line[..., 1:5], line[..., 5:], x[..., None])
        bounds = self._mixed(four, by_voltage, by_temperature)
        rest = self._mixed(
            tools.take(self.rest, condition), by_voltage[..., None], by_temperature[..., None]
        )
        is_at_rest = velocity == 0.0
        xp = tools.xp
        least = xp.minimum(rest[..., 0, 0], rest[..., 0, 1])
        greatest = xp.maximum(rest[..., 1, 0], rest[..., 1, 1])
        return [
            xp.where(is_at_rest, least, bounds[..., 0]),
            xp.where(is_at_rest, greatest, bounds[..., 1]),
        ]

    def _limits_traced(self, velocity, voltage, temperature):
        """limits() by numbers of the velocity's shape alone, of which a compiler makes one kernel."""
        tools, xp = self.tools, self.tools.xp
        voltage, temperature = (
            xp.broadcast_to(_array(tools, of), velocity.shape) for of in (voltage, temperature)
        )
        v, by_voltage = self.voltages.cell(voltage)
        t, by_temperature = self.temperatures.cell(temperature)
        condition = v * max(1, self.temperatures.count - 1) + t

        def mixed(four):
            first = tools.mixed(four(0), four(1), by_temperature)
            return tools.mixed(first, tools.mixed(four(2), four(3), by_temperature), by_voltage)

        points, found = self.corners.shape[2], []
        for bound in (0, 1):
            met = [mixed(lambda i: self.corners[:, bound, k, i][condition]) for k in range(points)]
            parts = [
                tools.clip((velocity - low) / tools.at_least(high - low, self.ramp), 0.0, 1.0)
                for low, high in zip(met, met[1:])
            ]
            place = sum(parts[1:], parts[0])
            cell = tools.cell(place * self.per_width, self.last) + bound * (self.last + 1)
            row = cell * self.sides + tools.passed(self.breaks, cell, place)
            row = self.numbers[row] + condition * self.count
            x = place - self.torques[:, 0][row]
            line = lambda i: self.torques[:, 1 + i][row] + x * self.torques[:, 5 + i][row]
            ends = [mixed(lambda i: self.rest[:, bound, j, i][condition]) for j in (0, 1)]
            still = (xp.minimum, xp.maximum)[bound](*ends)
            found.append(xp.where(velocity == 0.0, still, mixed(line)))
        return found

    def _row(self, place):
        tools = self.tools
        cell = tools.cell(place * self.per_width, self.last) + self.bound_cells
        return cell * self.sides + tools.passed(self.breaks, cell, place)


def _array(tools, value):
    return value if hasattr(value, "shape") else tools.floats(value)


def _padded(rows, count=0):
    """Rows of one length, the last number of each repeated."""
    count = max(count, max(map(len, rows)))
    return [row + [row[-1]] * (count - len(row)) for row in rows]


def _with_end(places, torques, last_place):
    """Places that reach as far as the other bound's."""
    if places[-1] >= last_place:
        return places, torques
    return places + [last_place], [row + [row[-1]] for row in torques]
)";

}  // namespace

std::string_view python_conditions() { return kText; }

}  // namespace torquewright::actuator
