// SPDX-License-Identifier: Apache-2.0
#include "actuator/source_text/python_source.hpp"

#include "actuator/source_text/python_parts.hpp"

namespace torquewright::actuator {
namespace {

constexpr std::string_view kRegion = R"(

class Region:
    """The torques that an actuator can have, by velocity, supply voltage and temperature."""

    def __init__(
        self, name, peak_torque_Nm, armature_kg_m2, voltage_V, temperature_K, table, grid, line=None
    ):
        self.name = name
        self.peak_torque_Nm = peak_torque_Nm
        self.armature_kg_m2 = armature_kg_m2
        self.voltage_V = voltage_V
        self.temperature_K = temperature_K
        self.table = table
        self.grid = grid
        self.line = line
        self.drag = None
        self.supply = None
        self._on = {}
        self._warp = {}
        self._is_flagged = False

    def __getstate__(self):
        return {**self.__dict__, "_on": {}, "_warp": {}}

    def to(self, device=None, dtype=None, library=None):
        """The region with its constants made, once, as arrays of a device and type: a RegionOn.

        REGION.to("cuda", torch.float32) is what a compiler traces (torch.compile, fullgraph). The
        library is the type's; where that does not tell, hand its module.
        """
        if library is None:
            name = (getattr(dtype, "__module__", "") or type(dtype).__module__).partition(".")[0]
            name = type(dtype).__module__.partition(".")[0] if name == "builtins" else name
            library = sys.modules["jax.numpy" if name in ("jax", "jaxlib") else name]
        key = library.__name__, str(dtype), str(device)
        if key not in self._on:
            self._on[key] = RegionOn(self, _tools_of(library, dtype, device))
        return self._on[key]

    def _beside(self, velocity, others):
        """The region's constants beside an array, and the type of what is answered."""
        xp = _namespace(velocity)
        device = getattr(velocity, "device", None)
        if "jax" in xp.__name__:
            device = None  # a tracer has none
        kind = velocity.dtype
        for name, other in others:
            if not hasattr(other, "dtype"):
                continue
            if xp.__name__ == "torch" and other.shape and _namespace(other) is not xp:
                raise ValueError(
                    f"{self.name}: {name} is no tensor, velocity is one; torch.as_tensor makes one"
                )
            where = getattr(other, "device", None)
            if device is not None and where is not None and str(where) != str(device):
                raise ValueError(
                    f"{self.name}: {name} is on {where}, velocity on {device}; move one of them"
                )
            if other.dtype != kind and "float" in str(other.dtype):
                finer = getattr(xp, "promote_types", None) or xp.result_type
                kind = finer(kind, other.dtype) if "float" in str(kind) else other.dtype
        if "float" not in str(kind):
            kind = xp.asarray(0.0).dtype  # numbers without a fraction count as the library's floats
        inside = xp.float32 if "float16" in str(kind) else kind
        return self.to(device, inside, xp), kind

    def _given(self, on, value):
        """An argument in the type that is computed in; a number stays one."""
        if not hasattr(value, "dtype") or value.dtype == on.tools.dtype:
            return value
        return on.tools.cast(value, on.tools.dtype)

    def _flag(self, on, voltage, temperature):
        """Says once that a condition lies beyond the grid, whose edge then holds."""
        if self._is_flagged:
            return
        for what, value, axis in (
            ("voltage", voltage, "voltage_V"),
            ("temperature", temperature, "temperature_K"),
        ):
            low, high = self.grid[axis][0], self.grid[axis][-1]
            if on.tools.lies_outside(value, low, high):
                self._is_flagged = True
                warnings.warn(
                    f"{self.name}: a {what} lies beyond {low:.6g} to {high:.6g}; there the nearest "
                    "end holds; said once",
                    stacklevel=4,
                )

    def _prepared(self, torque, velocity, voltage, temperature):
        others = [("torque", torque), ("voltage", voltage), ("temperature", temperature)]
        on, kind = self._beside(velocity, others)
        if isinstance(torque, (int, float)):
            torque = on.tools.floats(torque)
        if voltage is not None or temperature is not None:
            if self.grid is None:
                raise ValueError(
                    self.name + ": no grid over voltage and temperature in this file, which is of "
                    f"{self.voltage_V} V and {self.temperature_K} K"
                )
            voltage = self.voltage_V if voltage is None else voltage
            temperature = self.temperature_K if temperature is None else temperature
            self._flag(on, voltage, temperature)
        return on, kind, [self._given(on, of) for of in (torque, velocity, voltage, temperature)]

    def _answer(self, on, kind, value):
        return value if kind == on.tools.dtype else on.tools.cast(value, kind)

    def beside(self, array):
        """The region with its constants beside an array, of its type: see to()."""
        return self._beside(array, ())[0]

    def limits(self, velocity, voltage=None, temperature=None):
        """Least and greatest torque [Nm] at a velocity [rad/s].

        Without voltage and temperature the region is that of its table. With either, numbers or
        arrays that broadcast, it is interpolated in the grid; beyond the grid its edge holds.
        The voltage is that of the supply without load: its sag is in the region. [V], [K].
        """
        on, kind, (_, v, volts, kelvins) = self._prepared(None, velocity, voltage, temperature)
        return [self._answer(on, kind, bound) for bound in on.limits(v, volts, kelvins)]

    def clip(self, torque, velocity, voltage=None, temperature=None, out=None):
        """The torque [Nm] within the limits at a velocity [rad/s], arrays that broadcast.

        Numbers without a fraction count as floats; of two precisions the finer is answered, half
        precision is computed in single. What is no number stays none. `out`: an array of the
        answer's shape and type to write into (NumPy, CuPy, PyTorch).
        """
        on, kind, given = self._prepared(torque, velocity, voltage, temperature)
        if out is None:
            return self._answer(on, kind, on.clip(*given))
        if out.dtype != kind:
            raise ValueError(f"{self.name}: out holds {out.dtype}; the answer is of {kind}")
        if kind == on.tools.dtype:
            return on.clip(*given, out=out)
        out[...] = self._answer(on, kind, on.clip(*given))
        return out
)";

/// Between the motor and the load, where a command is the motor's. The dry part turns over with
/// tanh; what passes the gear depends on the sign of torque times motion, which turns over alike:
/// (d + b)/2 x + (d - b)/2 |x| tanh(velocity / smoothing), d driving and b braking.
constexpr std::string_view kFriction = R"(
    def add_friction(
        self, speed_rad_s, forward_Nm, backward_Nm, driving, braking, limit_Nm, smoothing_rad_s
    ):
        """Friction over the size of the speed, each way, and what of a torque passes the gear."""
        self.drag = {
            "speed_rad_s": speed_rad_s,
            "forward_Nm": forward_Nm,
            "backward_Nm": backward_Nm,
            "driving": driving,
            "braking": braking,
            "limit_Nm": limit_Nm,
            "smoothing_rad_s": smoothing_rad_s,
        }
        self.joint_peak_torque_Nm = braking * (self.peak_torque_Nm + max(forward_Nm + backward_Nm))
        if limit_Nm is not None:
            self.joint_peak_torque_Nm = min(self.joint_peak_torque_Nm, limit_Nm)

    @property
    def smoothing_rad_s(self):
        return self.drag["smoothing_rad_s"]

    @smoothing_rad_s.setter
    def smoothing_rad_s(self, value):
        self.drag["smoothing_rad_s"] = value
        self._on.clear()

    def friction(self, velocity):
        """Friction [Nm] at a velocity [rad/s], with its sign; beyond its table it goes on as a line."""
        on, kind, (_, v, _, _) = self._prepared(None, velocity, None, None)
        return self._answer(on, kind, on.friction(v))

    def torque(self, torque, velocity, voltage=None, temperature=None):
        """The torque [Nm] that reaches the joint for one that the motor is commanded, in Nm there.

        The command is clipped as the motor is; friction and the gear's losses are taken off it,
        driving and braking each by its own. Within some smoothing_rad_s of rest all that fades.
        """
        on, kind, given = self._prepared(torque, velocity, voltage, temperature)
        return self._answer(on, kind, on.torque(*given))
)";

/// Heat and the shared supply as states that are carried along.
constexpr std::string_view kSupply = R"(
    def add_supply(self, loss_W_Nm2, per_K, at_K, open_circuit_V, resistance_ohm, thermal):
        """What a drive loses at 1 Nm when its winding is at_K warm, and what heats and feeds it."""
        self.supply = {
            "loss_W_Nm2": loss_W_Nm2,
            "per_K": per_K,
            "at_K": at_K,
            "open_circuit_V": open_circuit_V,
            "resistance_ohm": resistance_ohm,
            "thermal": thermal,
        }

    def state(self, like, winding_K=None):
        """State for step(): windings and cases at a temperature (the document's ambient, or that of
        the file), no current in the supply."""
        thermal = self.supply["thermal"]
        start = thermal["ambient_K"] if thermal else self.temperature_K
        return DriveState(
            0.0 * like + (start if winding_K is None else winding_K), 0.0 * like + start, 0.0 * like
        )

    def step(self, torque, velocity, state, dt):
        """One step of dt [s]: what reaches the joint, and the state after it.

        Each drive is clipped at the temperature of its own winding and at the voltage that the
        others of its robot (those of the last axis) leave it: the supply they share sags by its
        resistance times their current of the step before. Copper losses heat winding and case by
        the midpoint rule. Batched and, but for the two roots' ends, with slopes.
        """
        xp = _namespace(velocity)
        supply, thermal = self.supply, self.supply["thermal"]
        ohm, volts = supply["resistance_ohm"], supply["open_circuit_V"]
        others_A = xp.sum(state.current_A, axis=-1)[..., None] - state.current_A
        on = self.beside(velocity)
        within = on.clip(torque, velocity, volts - ohm * others_A, state.winding_K)
        warmer = state.winding_K - supply["at_K"]
        loss_W = supply["loss_W_Nm2"] * within * within * (1.0 + supply["per_K"] * warmer)
        power_W = within * velocity + loss_W
        current_A = power_W / volts
        if ohm > 0.0:  # volts i - ohm i^2 = power, at most what the supply can give
            inside = on.tools.at_least(volts * volts - 4.0 * ohm * power_W, 1e-6 * volts * volts)
            current_A = 0.5 * (volts - xp.sqrt(inside)) / ohm
        if thermal is None:
            warmed = state.winding_K, state.case_K
        else:
            warmed = _warmed(thermal, state.winding_K, state.case_K, loss_W, dt)
        reached = within if on.drag is None else on.drag.through(within, velocity)
        return reached, DriveState(*warmed, current_A)
)";

}  // namespace

std::string python_source(bool has_friction) {
  std::string text;
  for (const std::string_view part :
       {python_lines(), python_libraries(), python_tables(), python_conditions()}) {
    text += part;
  }
  text += python_launches() + std::string(kRegion);
  return has_friction ? text + std::string(kFriction) + std::string(kSupply) : text;
}

}  // namespace torquewright::actuator
