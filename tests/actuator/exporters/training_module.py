# SPDX-License-Identifier: Apache-2.0
"""What training scripts do with an exported module; prints facts as JSON, which
training_module_test.cpp judges.

training_module.py FOLDER: NAME.py, exported modules, beside NAME.json of each (velocity_rad_s of
single precision, least_Nm, greatest_Nm; voltage_V, temperature_K and the bounds there), and
knee.py, which has a folder of its own in the path, as a training script's would."""

import copy
import importlib
import importlib.util
import io
import json
import pathlib
import pickle
import sys
import types
import warnings

sys.path.insert(0, str(pathlib.Path(__file__).parent))
folder = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(folder))
import numpy
import simulator_classes

try:
    import torch
except ImportError:
    torch = None

warnings.simplefilter("error")


def loaded(file):
    spec = importlib.util.spec_from_file_location(file.stem + "_of_test", file)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def worst(found, expected, peak):
    return max(
        float(numpy.max(numpy.abs(numpy.asarray(one, dtype=numpy.float64) - other)))
        for one, other in zip(found, expected)
    ) / peak


def off_its_law(file, region, samples):
    """Of both bounds, as shares of the peak torque, by library and precision."""
    peak = region.peak_torque_Nm
    speed = numpy.asarray(samples["velocity_rad_s"])
    expected = [numpy.asarray(samples[name]) for name in ("least_Nm", "greatest_Nm")]
    facts = {"double": worst(region.limits(speed), expected, peak)}
    volts, kelvins = (numpy.asarray(samples[n]) for n in ("voltage_V", "temperature_K"))
    there = [numpy.asarray(samples[n]) for n in ("least_there_Nm", "greatest_there_Nm")]
    facts["double_there"] = worst(region.limits(speed, volts, kelvins), there, peak)
    narrow = speed.astype(numpy.float32)
    facts["single"] = worst(region.limits(narrow), expected, peak)
    facts["single_there"] = worst(
        region.limits(narrow, volts.astype(numpy.float32), kelvins.astype(numpy.float32)), there, peak
    )
    if torch is not None:
        facts["torch"] = worst(region.limits(torch.tensor(narrow)), expected, peak)
        facts["launches"] = launches(region)
        facts["one_launch"], facts["one_kernel"] = other_ways(loaded_with_launch(file), samples)
    return facts


def loaded_with_launch(file):
    """A region whose launches run on the processor, in the language as triton_stub speaks it."""
    import contextlib

    sys.path.insert(0, str(pathlib.Path(__file__).parent / "triton_stub"))
    module = loaded(file)
    on = module.REGION.to("cpu", torch.float32)
    on.launch = module._Launch(on)
    torch.cuda.device = contextlib.nullcontext  # the processor is no CUDA device
    return on


def samples_of(on, samples):
    """Torques and speeds of six joints and their conditions by robot, with some of no number."""
    rows = len(samples["velocity_rad_s"]) // 6
    shaped = lambda name: torch.tensor(samples[name][: 6 * rows]).reshape(rows, 6)
    velocity, volts, kelvins = map(shaped, ("velocity_rad_s", "voltage_V", "temperature_K"))
    torque = 1.5 * max(samples["greatest_Nm"]) * torch.sin(torch.arange(6.0 * rows)).reshape(rows, 6)
    torque[1, 0] = velocity[1, 1] = volts[2, 0] = float("nan")
    return torque, velocity, volts[:, :1].contiguous(), kelvins


def other_ways(on, samples):
    """How far off the plain way are, as shares of the peak torque, the launches and what a compiler
    traces: clip and torque, of the table and under conditions, as arrays and numbers."""
    torque, velocity, volts, kelvins = samples_of(on, samples)
    launch, off = on.launch, {"launch": 0.0, "traced": 0.0}
    for name in ("clip", "torque"):
        for there in ((), (volts, kelvins), (None, kelvins), (on.voltage_V, None)):
            found = {}
            for way in ("launch", "plain", "traced"):
                on.launch = launch if way == "launch" else None
                on.tools.is_traced = lambda way=way: way == "traced"
                found[way] = getattr(on, name)(torque, velocity, *there)
            for way in off:
                if not torch.equal(found[way].isnan(), found["plain"].isnan()):
                    off[way] = float("inf")
                gap = (found[way] - found["plain"]).nan_to_num().abs().max().item()
                off[way] = max(off[way], gap / max(samples["greatest_Nm"]))
    on.launch = launch
    return off["launch"], off["traced"]


def what_launches_leave(file):
    """Who takes a call: a launch, or the plain way."""
    on = loaded_with_launch(file)
    torque, velocity = torch.full((4, 2), 1000.0), torch.full((4, 2), 9.0)
    volts = torch.full((4, 1), 60.0)
    taken = lambda *of, out=None: on.launch.clip(*of, *[None] * (4 - len(of)), out) is not None
    steep = velocity.clone().requires_grad_()
    into = torch.zeros(4, 2)
    facts = {
        "plain": taken(torque, velocity),
        "by_robot": taken(torque, velocity, volts, 300.0),
        "number": taken(1000.0, velocity),
        "row": taken(torque[:1], velocity),
        "double": taken(torque.double(), velocity),
        "turned": taken(torque.T.contiguous().T, velocity),
        "empty": taken(torque[:0], velocity[:0]),
        "other_shape": taken(torque, velocity, volts[:2]),
        "slopes": taken(torque, steep),
        "written": on.clip(torque, velocity, out=into) is into and bool((into > 0.0).all()),
    }
    with torch.no_grad():
        facts["no_slopes"] = taken(torque, steep)
    with torch.autograd.forward_ad.dual_level():
        dual = torch.autograd.forward_ad.make_dual(velocity, torch.ones(4, 2))
        facts["forward_slopes"] = taken(torque, dual)
        tangent = torch.autograd.forward_ad.unpack_dual(on.clip(torque, dual)).tangent
        facts["tangents"] = tangent is not None and bool((tangent < 0.0).all())
    torch.set_default_dtype(torch.float64)
    facts["under_double"] = str(on.clip(torque, velocity, 60.0, 300.0).dtype)
    torch.set_default_dtype(torch.float32)
    return facts


def launches(region):
    """How many operations a compiler finds when it traces the calls: it asks no value, branches on
    none and looks nothing up, or there would be no trace."""
    import torch.fx

    on = region.to("cpu", torch.float32)

    def count(function):
        graph = torch.fx.symbolic_trace(function).graph
        views = {"getitem", "unbind"}
        return sum(
            node.op in ("call_function", "call_method")
            and getattr(node.target, "__name__", node.target) not in views
            for node in graph.nodes
        )

    return {
        "clip": count(lambda torque, velocity: on.clip(torque, velocity)),
        "there": count(lambda torque, velocity, v, t: on.clip(torque, velocity, v, t)),
    }


def start_of_isaac_lab():
    """How a configuration travels: Isaac Lab's string form, by import and getattr; pickle; copies."""
    import knee

    cfg = knee.REGION.isaac_lab(["knee"], stiffness=20.0, damping=0.5)
    kind = cfg.class_type
    text = f"{kind.__module__}:{kind.__qualname__}"
    module, name = text.split(":")
    back = getattr(importlib.import_module(module), name)
    sent = pickle.loads(pickle.dumps(cfg))
    copied = copy.deepcopy(cfg)
    robot = knee.REGION.mjlab(("knee",), stiffness=20.0, damping=0.5)
    return {
        "text": text,
        "is_found": back is kind,
        "is_pickled": sent.class_type is kind and sent.stiffness == 20.0,
        "is_copied": copied.class_type is kind,
        "is_lazy": knee.__getattr__("MjlabActuator").__module__ == "knee",
        "mjlab": pickle.loads(pickle.dumps(robot)) == robot,
        "region": pickle.loads(pickle.dumps(knee.REGION)).table == knee.REGION.table,
        "unknown": refusal(lambda: knee.NoSuchClass),
    }


def refusal(work):
    try:
        work()
    except Exception as error:
        return f"{type(error).__name__}: {error}"
    return ""


def numbers(knee):
    """Kinds of numbers: by hand 10.5 rad/s is the no-load speed, and the line falls by
    1536 / 10.5 Nm s/rad."""
    whole = numpy.asarray([9, -9])
    torques = numpy.asarray([1000, -1000])
    facts = {"whole": knee.clip(torques, whole).tolist()}
    facts["mixed"] = str(knee.clip(torques.astype(numpy.float32), whole * 1.0).dtype)
    half = knee.clip(torques.astype(numpy.float16), whole.astype(numpy.float16))
    facts["half"] = [str(half.dtype), half.tolist()]
    out = numpy.zeros(2)
    given = knee.clip(torques, whole * 1.0, out=out)
    facts["out"] = [given is out, out.tolist()]
    narrow = numpy.zeros(2, numpy.float32)
    facts["narrow_out"] = refusal(lambda: knee.clip(torques, whole * 1.0, out=narrow))
    facts["empty"] = [list(knee.clip(numpy.zeros((0, 12)), numpy.zeros((0, 12))).shape)]
    nan = numpy.nan
    speed, torque = numpy.asarray([9.0, nan, 9.0]), numpy.asarray([nan, 1000.0, 1000.0])
    facts["nan"] = [repr(one) for one in knee.clip(torque, speed).tolist()]
    facts["nan_there"] = [repr(one) for one in knee.clip(torque, speed, 67.2).tolist()]
    facts["long"] = long_array(knee)
    if torch is None:
        return facts
    facts["empty"].append(list(knee.clip(torch.zeros((0, 12)), torch.zeros((0, 12))).shape))
    facts["whole_torch"] = knee.clip(torch.tensor(torques), torch.tensor(whole)).tolist()
    half = knee.clip(torch.tensor(torques).bfloat16(), torch.tensor(whole).bfloat16())
    facts["half_torch"] = [str(half.dtype), half.tolist()]
    facts["nan_torch"] = [repr(one) for one in knee.clip(torch.tensor(torque), torch.tensor(speed)).tolist()]
    single, double = torch.tensor(torques).float(), torch.tensor(whole).double()
    facts["mixed_torch"] = [str(knee.clip(single, double).dtype), str(knee.clip(double, single).dtype)]
    facts["number_torch"] = [float(knee.clip(sign * 1000.0, double)[of]) for of, sign in ((0, 1), (1, -1))]
    facts["libraries"] = refusal(lambda: knee.clip(torques * 1.0, double))
    meta = torch.zeros(2, device="meta")
    facts["devices"] = refusal(lambda: knee.clip(torch.zeros(2), meta))
    facts["onnx"] = onnx_nodes(knee)
    return facts


def long_array(knee):
    """More than a piece, in two axes: the same as one by one."""
    speed = numpy.linspace(-15.0, 15.0, 60000).reshape(5000, 12)
    torque = 500.0 * numpy.sin(numpy.arange(60000.0)).reshape(5000, 12)
    volts = numpy.linspace(40.0, 70.0, 5000).reshape(5000, 1)
    is_same = True
    for conditions in ((), (60.0,), (volts, 300.0)):
        bounds = knee.limits(speed, *conditions)
        is_same &= bool((knee.clip(torque, speed, *conditions) == numpy.clip(torque, *bounds)).all())
    return is_same


def onnx_nodes(region):
    """The kinds of nodes of a policy's last layer in ONNX, as PyTorch writes them."""
    on = region.to("cpu", torch.float32)

    class Last(torch.nn.Module):
        def forward(self, torque, velocity):
            return on.clip(torque, velocity)

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        text = torch.onnx.export_to_pretty_string(
            Last(), (torch.zeros(3, 2), torch.zeros(3, 2)), opset_version=14
        )
    return sorted({part.split('"')[1] for part in text.split("Node {type: ")[1:]}) or text[:300]


def flagged(region):
    """Conditions beyond the grid: the edge, and one warning."""
    low = region.grid["voltage_V"][0]
    speed, torque = numpy.asarray([2.0]), numpy.asarray([1e9])
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        beyond = region.clip(torque, speed, 0.5 * low)
        region.clip(torque, speed, numpy.asarray([0.25 * low]))
    edge = region.clip(torque, speed, low)
    return {"said": [str(one.message) for one in said], "is_edge": beyond.tolist() == edge.tolist()}


class Device:
    """As CuPy's: without a hash."""

    __hash__ = None

    def __eq__(self, other):
        return True

    def __str__(self):
        return "<CUDA Device 0>"


def like_cupy(knee):
    """CuPy by what it does otherwise than NumPy: its name and its devices."""
    library = types.ModuleType("cupy")
    library.__dict__.update({name: getattr(numpy, name) for name in dir(numpy) if name[:1] != "_"})

    class ndarray(numpy.ndarray):
        device = Device()

    ndarray.__module__ = "cupy"
    sys.modules["cupy"] = library
    made = lambda *of: numpy.asarray(of).view(ndarray)
    return [knee.clip(made(1000.0), made(9.0)).tolist() for _ in range(2)][1]


def stepped(region):
    """Two drives of one robot, held at 100 Nm for 10 s; then how the winding follows the torque."""
    speed, torque = numpy.zeros((1, 2)), numpy.full((1, 2), 100.0)
    state = region.state(speed)
    for _ in range(2000):
        reached, state = region.step(torque, speed, state, 0.005)
    facts = {
        "reached_Nm": reached.tolist()[0],
        "winding_K": state.winding_K.tolist()[0],
        "case_K": state.case_K.tolist()[0],
        "current_A": state.current_A.tolist()[0],
    }
    # Fast and at full torque, beside a drive that draws and beside one that does not.
    fast = numpy.asarray([[9.0, 0.0]])
    for name, other in (("alone_Nm", 0.0), ("beside_Nm", 320.0)):
        state = region.state(fast)
        for _ in range(2):
            reached, state = region.step(numpy.asarray([[1e3, other]]), fast, state, 1e-6)
        facts[name] = reached.tolist()[0][0]
    if torch is None:
        return facts
    given = torch.full((1, 2), 100.0, dtype=torch.float64, requires_grad=True)
    rest = torch.zeros((1, 2), dtype=torch.float64)

    def after(torque):
        return region.step(torque, rest, region.state(rest), 0.1)[1].winding_K.sum()

    after(given).backward()
    with torch.no_grad():
        difference = (after(given + 1e-3) - after(given - 1e-3)) / 2e-3
    facts["slopes"] = [given.grad.sum().item(), difference.item()]
    return facts


facts = {"laws": {}}
for file in sorted(folder.glob("*.json")):
    region = loaded(file.with_suffix(".py")).REGION
    facts["laws"][file.stem] = off_its_law(file.with_suffix(".py"), region, json.loads(file.read_text()))
knee = loaded(folder / "knee.py").REGION
facts["stepped"] = stepped(loaded(folder / "heated.py").REGION)
facts["start"] = start_of_isaac_lab()
facts["numbers"] = numbers(knee)
facts["cupy"] = like_cupy(knee)
if torch is not None:
    facts["left"] = what_launches_leave(folder / "knee.py")
facts["flagged"] = flagged(loaded(folder / "knee.py").REGION)
print(json.dumps(facts))
