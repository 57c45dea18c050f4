// SPDX-License-Identifier: Apache-2.0
// The region as one launch on a GPU: kernels in Triton's language (triton.language). Constants are
// those of closures, which count in a kernel's name in the cache (get_capture_scope and cache_key
// of triton/runtime/jit.py, Triton 3.3 and later). Without a GPU
// tests/actuator/exporters/triton_stub speaks as much of the language.
#include "actuator/source_text/python_parts.hpp"

namespace torquewright::actuator {
namespace {

constexpr std::string_view kKernels = R"(

def _triton_kernels(on, composes):
    """The kernels of clip(), or of torque() where it composes: over velocity, and over velocity,
    voltage and temperature (None where the region knows no conditions). A region's numbers are
    compiled in. Arithmetic and names are those of _LinesOn, _ScaledLine, _GridOn and _DragOn."""
    import triton
    import triton.language as tl

    fixed = tl.constexpr
    SIZE = fixed(_Launch.SIZE)

    @triton.jit
    def held(x, low, high):
        return tl.minimum(tl.maximum(x, low), high)

    def named(function, name):
        """Compiled under a name of its own: in a kernel a name stands for one function."""
        function.__name__ = function.__qualname__ = name
        return triton.jit(function)

    def finder(name, low, high, per_width, last, most, is_laid_along):
        LOW, HIGH, MIDDLE = fixed(low), fixed(high), fixed(0.5 * (low + high))
        PER_WIDTH, LAST, HALF = fixed(per_width), fixed(last), fixed(last // 2)
        MOST, IS_LAID_ALONG = fixed(most), fixed(is_laid_along)

        def row_of(place, breaks, first_cell):
            if IS_LAID_ALONG:
                near = tl.maximum(tl.minimum(place - LOW, HIGH - place), 0.0)
                cell = held((tl.sqrt(tl.sqrt(near)) * PER_WIDTH).to(tl.int32), 0, HALF)
                cell = tl.where(place > MIDDLE, LAST - cell, cell)
            else:
                cell = held(((place - LOW) * PER_WIDTH).to(tl.int32), 0, LAST)
            cell += first_cell
            row = cell * (MOST + 1)
            for k in tl.static_range(MOST):
                row += (place >= tl.load(breaks + cell * MOST + k)).to(tl.int32)
            return row

        return named(row_of, name)

    def finder_of(name, of):
        most = 1 if len(of.breaks.shape) == 1 else of.breaks.shape[1]
        return finder(name, of.low, of.high, of.per_width, of.last, most, of.is_laid_along)

    @triton.jit
    def line_at(rows, row, place):
        """Both values at a place of a line of two columns."""
        line = rows + 5 * row
        x = place - tl.load(line)
        first = tl.load(line + 1) + tl.load(line + 3) * x
        return first, tl.load(line + 2) + tl.load(line + 4) * x

    def through_of(drag):
        SMOOTHING, LIMIT = fixed(2.0 / drag.smoothing_rad_s), fixed(drag.limit_Nm or 3.0e38)
        MEAN, HALF, IS_TABLE = fixed(drag.mean), fixed(drag.half), fixed(drag.only is None)
        START, FORWARD, BACKWARD, FORWARD_SLOPE, BACKWARD_SLOPE = map(fixed, drag.only or [0.0] * 5)
        drag_row = finder_of("drag_row", drag.lines) if drag.only is None else held

        @triton.jit
        def reached(within, v, breaks, rows):
            size = tl.abs(v)
            if IS_TABLE:
                forward, backward = line_at(rows, drag_row(size, breaks, 0), size)
            else:
                forward = FORWARD + FORWARD_SLOPE * (size - START)
                backward = BACKWARD + BACKWARD_SLOPE * (size - START)
            way = 1.0 - 2.0 / (tl.exp(v * SMOOTHING) + 1.0)  # the hyperbolic tangent
            before = within + 0.5 * (backward * (1.0 - way) - forward * (1.0 + way))
            return held(MEAN * before + HALF * tl.abs(before) * way, -LIMIT, LIMIT)

        return reached

    COMPOSES = fixed(composes)
    reached = through_of(on.drag) if composes else held

    @triton.jit
    def put(out, torque, at, mask, v, least, greatest, drag_breaks, drag_rows):
        effort = tl.load(torque + at, mask=mask, other=0.0)
        answer = held(effort, least, greatest)
        if COMPOSES:
            answer = reached(answer, v, drag_breaks, drag_rows)
        is_number = (effort == effort) & (v == v)
        tl.store(out + at, tl.where(is_number, answer, effort + v), mask=mask)

    def of_lines():
        row_of = finder_of("row_of", on.lines)
        LEAST, MOST, JUMPS = fixed(on.lines.least), fixed(on.lines.most), fixed(on.jumps_at_rest)
        REST_LEAST, REST_GREATEST = (fixed(float(of)) for of in on.rest)

        @triton.jit
        def kernel(out, torque, velocity, count, breaks, rows, drag_breaks, drag_rows):
            at = tl.program_id(0) * SIZE + tl.arange(0, SIZE)
            mask = at < count
            v = tl.load(velocity + at, mask=mask, other=0.0)
            place = held(v, LEAST, MOST)
            least, greatest = line_at(rows, row_of(place, breaks, 0), place)
            if JUMPS:
                least = tl.where(v == 0.0, REST_LEAST, least)
                greatest = tl.where(v == 0.0, REST_GREATEST, greatest)
            put(out, torque, at, mask, v, least, greatest, drag_breaks, drag_rows)

        return kernel, (on.lines.breaks, on.lines.rows)

    def of_scaled_line(there):
        TORQUE, PER_SPEED = fixed(there.torque_Nm_V), fixed(there.V_s_rad)
        GREATEST, PER_K, AT_K = fixed(there.greatest_Nm), fixed(there.per_K), fixed(there.at_K)
        V_LOW, V_HIGH, K_LOW, K_HIGH = map(fixed, there.voltages + there.temperatures)

        @triton.jit
        def kernel(out, torque, velocity, voltage, temperature, each_V, each_K, count,
                   drag_breaks, drag_rows):
            at = tl.program_id(0) * SIZE + tl.arange(0, SIZE)
            mask = at < count
            v = tl.load(velocity + at, mask=mask, other=0.0)
            volts = tl.load(voltage + at // each_V, mask=mask, other=0.0)
            kelvins = tl.load(temperature + at // each_K, mask=mask, other=0.0)
            per_V = TORQUE / (1.0 + PER_K * (held(kelvins, K_LOW, K_HIGH) - AT_K))
            lost = PER_SPEED * v
            least = held(per_V * (-held(volts, V_LOW, V_HIGH) - lost), -GREATEST, GREATEST)
            greatest = held(per_V * (held(volts, V_LOW, V_HIGH) - lost), -GREATEST, GREATEST)
            v = tl.where((volts == volts) & (kelvins == kelvins), v, volts + kelvins)
            put(out, torque, at, mask, v, least, greatest, drag_breaks, drag_rows)

        return kernel, ()

    def axis_of(name, axis):
        LOW, HIGH, PER_VALUE = fixed(axis.ends[0]), fixed(axis.ends[1]), fixed(axis.per_value)
        CELLS, IS_EVEN = fixed(axis.count - 1), fixed(axis.is_even)
        LAST = fixed(max(0, axis.count - 2))

        def cell_of(value, starts, per_width):
            value = tl.where(value == value, value, LOW)
            if IS_EVEN:
                place = (held(value, LOW, HIGH) - LOW) * PER_VALUE
            else:
                place = tl.zeros_like(value)
                for k in tl.static_range(CELLS):
                    part = (value - tl.load(starts + k)) * tl.load(per_width + k)
                    place += held(part, 0.0, 1.0)
            cell = held(place.to(tl.int32), 0, LAST)
            return cell, place - cell

        tables = (on.rest[0], on.rest[0]) if axis.is_even else (axis.starts, axis.per_width)
        return named(cell_of, name), tables

    def of_grid(grid):
        voltage_cell, voltage_tables = axis_of("voltage_cell", grid.voltages)
        temperature_cell, temperature_tables = axis_of("temperature_cell", grid.temperatures)
        most = 1 if len(grid.breaks.shape) == 1 else grid.breaks.shape[1]
        row_of = finder("row_of", 0.0, 1.0, grid.per_width, grid.last, most, False)
        CORNERS, RAMP = fixed(grid.corners.shape[2]), fixed(grid.ramp)
        COLUMNS = fixed(max(1, grid.temperatures.count - 1))
        ROWS, CELLS = fixed(grid.count), fixed(grid.last + 1)

        @triton.jit
        def mixed(four, a, b):
            first, second = tl.load(four), tl.load(four + 2)
            first += b * (tl.load(four + 1) - first)
            second += b * (tl.load(four + 3) - second)
            return first + a * (second - first)

        @triton.jit
        def bound(which: tl.constexpr, v, condition, a, b, corners, breaks, numbers, torques):
            corner = corners + (condition * 2 + which) * (4 * CORNERS)
            before = mixed(corner, a, b)
            place = tl.zeros_like(v)
            for k in tl.static_range(1, CORNERS):
                after = mixed(corner + 4 * k, a, b)
                place += held((v - before) / tl.maximum(after - before, RAMP), 0.0, 1.0)
                before = after
            row = tl.load(numbers + row_of(place, breaks, which * CELLS)).to(tl.int32)
            line = torques + 9 * (row + condition * ROWS)
            x = place - tl.load(line)
            first = tl.load(line + 1) + x * tl.load(line + 5)
            first += b * (tl.load(line + 2) + x * tl.load(line + 6) - first)
            second = tl.load(line + 3) + x * tl.load(line + 7)
            second += b * (tl.load(line + 4) + x * tl.load(line + 8) - second)
            return first + a * (second - first)

        @triton.jit
        def kernel(out, torque, velocity, voltage, temperature, each_V, each_K, count, V_starts,
                   V_per_width, K_starts, K_per_width, corners, breaks, numbers, torques, rest,
                   drag_breaks, drag_rows):
            at = tl.program_id(0) * SIZE + tl.arange(0, SIZE)
            mask = at < count
            v = tl.load(velocity + at, mask=mask, other=0.0)
            volts = tl.load(voltage + at // each_V, mask=mask, other=0.0)
            kelvins = tl.load(temperature + at // each_K, mask=mask, other=0.0)
            i, a = voltage_cell(volts, V_starts, V_per_width)
            j, b = temperature_cell(kelvins, K_starts, K_per_width)
            condition = i * COLUMNS + j
            least = bound(0, v, condition, a, b, corners, breaks, numbers, torques)
            greatest = bound(1, v, condition, a, b, corners, breaks, numbers, torques)
            still = rest + 16 * condition
            low = tl.minimum(mixed(still, a, b), mixed(still + 4, a, b))
            high = tl.maximum(mixed(still + 8, a, b), mixed(still + 12, a, b))
            least = tl.where(v == 0.0, low, least)
            greatest = tl.where(v == 0.0, high, greatest)
            v = tl.where((volts == volts) & (kelvins == kelvins), v, volts + kelvins)
            put(out, torque, at, mask, v, least, greatest, drag_breaks, drag_rows)

        tables = (grid.corners, grid.breaks, grid.numbers, grid.torques, grid.rest)
        return kernel, (*voltage_tables, *temperature_tables, *tables)

    there = None
    if isinstance(on.conditions, _ScaledLine):
        there = of_scaled_line(on.conditions)
    elif on.conditions is not None:
        there = of_grid(on.conditions)
    has_table = composes and on.drag.only is None
    drag = (on.drag.lines.breaks, on.drag.lines.rows) if has_table else (on.rest[0], on.rest[0])
    return [None if of is None else (of[0], (*of[1], *drag)) for of in (of_lines(), there)]
)";

constexpr std::string_view kLaunch = R"(

class _Launch:
    """clip() and torque() of a region on a CUDA device as one launch each, by Triton: of single
    precision and where no slopes are asked for. What it does not take goes the plain way."""

    SIZE = 256  # samples of a block of threads

    def __init__(self, on):
        self.torch, self.rest = on.tools.xp, (on.voltage_V, on.temperature_K)
        ways = {False, on.drag is not None}
        self.kernels = {composes: _triton_kernels(on, composes) for composes in ways}
        functorch = getattr(self.torch._C, "_functorch", None)
        self.is_transformed = getattr(functorch, "is_functorch_wrapped_tensor", lambda array: False)

    @staticmethod
    def of(on):
        """Of a region on a device, or None where that cannot be."""
        xp, device = on.tools.xp, on.tools.place.get("device", "cpu")
        is_cuda = xp.__name__ == "torch" and xp.device(device).type == "cuda"
        if not is_cuda or on.tools.dtype != xp.float32:
            return None
        try:
            import triton
        except ImportError:
            return None
        newest = tuple(int(part) for part in triton.__version__.split(".")[:2])
        return _Launch(on) if newest >= (3, 3) else None

    def clip(self, torque, velocity, voltage, temperature, out):
        """See RegionOn.clip(); None where it must be found the plain way."""
        return self._answer(False, torque, velocity, voltage, temperature, out)

    def torque(self, torque, velocity, voltage, temperature):
        """See RegionOn.torque(); None where it must be found the plain way."""
        return self._answer(True in self.kernels, torque, velocity, voltage, temperature, None)

    def _answer(self, composes, torque, velocity, voltage, temperature, out):
        torch = self.torch
        if torch.jit.is_tracing() or self._carries_tangents():
            return None
        if not self._takes(velocity, velocity) or not self._takes(torque, velocity):
            return None
        given, there = (), voltage is not None or temperature is not None
        if there:
            volts = self._condition(self.rest[0] if voltage is None else voltage, velocity)
            kelvins = self.rest[1] if temperature is None else temperature
            kelvins = self._condition(kelvins, velocity)
            if volts is None or kelvins is None:
                return None
            given = volts[0], kelvins[0], volts[1], kelvins[1]
        if out is None:
            out = torch.empty_like(velocity)
        elif not self._takes(out, velocity):
            return None
        kernel, tables = self.kernels[composes][there]
        count = velocity.numel()
        blocks = (count + self.SIZE - 1) // self.SIZE
        with torch.cuda.device(velocity.device):
            kernel[(blocks,)](out, torque, velocity, *given, count, *tables)
        return out

    def _carries_tangents(self):
        """Whether slopes are taken forward, along with the numbers: the kernels know none."""
        forward = getattr(self.torch.autograd, "forward_ad", None)
        return getattr(forward, "_current_level", -1) >= 0

    def _takes(self, array, velocity):
        """Whether it is an array as a kernel reads it, of the velocity's shape."""
        return (
            type(array) is self.torch.Tensor
            and array.dtype == self.torch.float32
            and array.device == velocity.device
            and array.shape == velocity.shape
            and 0 < array.numel() < 2**31
            and array.is_contiguous()
            and not (array.requires_grad and self.torch.is_grad_enabled())
            and not self.is_transformed(array)
        )

    def _condition(self, value, velocity):
        """It as an array, and how many samples in a row share each of its numbers; None where that
        is not so simple."""
        count = velocity.numel()
        if not hasattr(value, "shape"):
            place = {"dtype": velocity.dtype, "device": velocity.device}
            return self.torch.full((1,), float(value), **place), count
        shape = value.shape
        each = 1
        if value.numel() == 1:
            each = count
        elif shape == velocity.shape[:-1] + (1,):
            each = velocity.shape[-1]
        elif shape != velocity.shape:
            return None
        is_taken = self._takes(value, value) and value.device == velocity.device
        return (value, each) if is_taken else None
)";

}  // namespace

std::string python_launches() { return std::string(kKernels) + std::string(kLaunch); }

}  // namespace torquewright::actuator
