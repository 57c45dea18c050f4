#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What the exported region costs in a training loop, on a GPU: correctness, times, ratios, memory.

training_region.py MODULE.py [MODULE.py ...]: modules of `torquewright actuator mor --format python`.
Without PyTorch on a CUDA device it says so and ends with 77, as CI's skipped tests do. JAX is asked
where it is installed. Times are medians of microseconds a call; the yardsticks are Isaac Lab's
DCMotor law by its formulas (actuator_pd.py @ eafe554d) and a copy. The goals are those of the table
that it prints.

On a machine without PyTorch but for the CPU: --cpu, which checks the script and the numbers and
whose times say nothing of a GPU."""

import copy
import importlib.util
import pathlib
import statistics
import sys
import time

ROBOTS, JOINTS = 4096, 12
MANY = 10_000_000


def loaded(file):
    spec = importlib.util.spec_from_file_location("region_" + pathlib.Path(file).stem, file)
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module  # where a compiler looks for what it traces
    spec.loader.exec_module(module)
    return module.REGION


def medians_us(ways, wait, repeats=100, rounds=15):
    """Of each way a median over rounds, in which all take their turns: what slows the machine down
    for a while slows them alike."""
    for work in ways.values():
        for _ in range(10):
            work()
    wait()
    times = {name: [] for name in ways}
    for _ in range(rounds):
        for name, work in ways.items():
            begin = time.perf_counter()
            for _ in range(repeats):
                work()
            wait()
            times[name].append(1e6 * (time.perf_counter() - begin) / repeats)
    return {name: statistics.median(took) for name, took in times.items()}


class DcMotor:
    """Isaac Lab's DCMotor by its formulas: what a policy is trained with today."""

    def __init__(self, torch, stall, no_load, cap, like):
        self.torch, self.stall, self.no_load, self.cap = torch, stall, no_load, cap
        self.end = no_load * (1.0 + cap / stall)
        self.speed = torch.zeros_like(like)

    def __call__(self, effort, velocity):
        torch = self.torch
        self.speed[:] = velocity
        self.speed[:] = torch.clip(self.speed, min=-self.end, max=self.end)
        top = self.stall * (1.0 - self.speed / self.no_load)
        bottom = self.stall * (-1.0 - self.speed / self.no_load)
        most = torch.clip(top, max=self.cap)
        least = torch.clip(bottom, min=-self.cap)
        return torch.clip(effort, min=least, max=most)


def off_by(region, on, samples):
    """Of what a region answers here in single precision against double on the processor, of the
    peak torque: clip and torque, of the table and under conditions. Twice the peak is asked for,
    each way, so that both bounds are answered."""
    torque, velocity, volts, kelvins = (of.double().cpu() for of in samples)
    most = {}
    for name in ("clip", "torque"):
        for place, there in {name: (None, None), name + " there": (volts, kelvins)}.items():
            exact = getattr(region, name)(torque, velocity, *there)
            found = getattr(on, name)(*samples[:2], *(samples[2:] if there[0] is not None else ()))
            off = (found.double().cpu() - exact).abs().max().item()
            most[place] = off / region.peak_torque_Nm
    return ", ".join(f"{place} {off:.1e}" for place, off in most.items())


def slopes_differ(torch, on, samples):
    """Whether slopes are those of the plain way where they are asked for: the launches know none."""
    torque, velocity = (of.clone().requires_grad_() for of in samples[:2])
    on.clip(torque, velocity).sum().backward()
    inside = torque.detach() == on.clip(torque, velocity).detach()
    return not bool(torch.isfinite(velocity.grad).all() and (torque.grad.bool() == inside).all())


def of_torch(torch, device, region, repeats):
    wait = torch.cuda.synchronize if device == "cuda" else lambda: None
    end, peak = region.table["speed_rad_s"][-1], region.peak_torque_Nm
    dice = torch.Generator(device=device).manual_seed(1)

    def drawn(*shape):
        return 2.0 * torch.rand(*shape, device=device, generator=dice) - 1.0

    velocity, torque = 1.2 * end * drawn(ROBOTS, JOINTS), 1.5 * peak * drawn(ROBOTS, JOINTS)
    volts = region.voltage_V * (0.8 + 0.2 * drawn(ROBOTS, 1))
    kelvins = 320.0 + 20.0 * drawn(ROBOTS, 1)
    on = region.to(device, torch.float32)
    plain = copy.copy(on)
    plain.launch = None
    motor = DcMotor(torch, 4.0 * peak, end, peak, velocity)
    target = torch.empty_like(torque)
    samples = torque, velocity, volts, kelvins
    print(f"{region.name}: {'one launch' if on.launch else 'plain'}, off by "
          f"{off_by(region, on, samples)}; the plain way by {off_by(region, plain, samples)}; "
          f"slopes {'DIFFER' if slopes_differ(torch, on, samples) else 'stand'}")
    ways = {
        "DCMotor": lambda: motor(torque, velocity),
        "clip": lambda: on.clip(torque, velocity),
        "clip there": lambda: on.clip(torque, velocity, volts, kelvins),
        "torque": lambda: on.torque(torque, velocity),
        "torque there": lambda: on.torque(torque, velocity, volts, kelvins),
    }
    rows = {f"{name}, eager": way for name, way in ways.items()}
    rows = {"copy": lambda: target.copy_(torque), **rows}
    rows["REGION.clip, eager"] = lambda: region.clip(torque, velocity)
    rows["plain clip, eager"] = lambda: plain.clip(torque, velocity)
    rows["plain clip there, eager"] = lambda: plain.clip(torque, velocity, volts, kelvins)
    if device == "cuda":
        for name, way in ways.items():
            rows[f"{name}, compiled"] = torch.compile(way, fullgraph=True)
        for name, way in ways.items():
            rows[f"{name}, CUDA graph"] = graph_of(torch, way)
    times = medians_us(rows, wait, repeats)
    for name, took in times.items():
        way = name.partition(", ")[2] or "eager"
        print(f"  {name:26}{took:9.1f} us{took / times['DCMotor, ' + way]:8.2f} of DCMotor {way}")
    if device == "cuda":
        of_many(torch, region, on, end, peak, wait)


def graph_of(torch, work):
    stream = torch.cuda.Stream()
    with torch.cuda.stream(stream):
        work()
    torch.cuda.synchronize()
    graph = torch.cuda.CUDAGraph()
    with torch.cuda.graph(graph):
        work()
    return graph.replay


def of_many(torch, region, on, end, peak, wait):
    """So many samples that the memory's speed decides: the yardstick is a copy."""
    velocity = torch.rand(MANY, device="cuda") * 2.4 * end - 1.2 * end
    torque = torch.rand(MANY, device="cuda") * 3.0 * peak - 1.5 * peak
    target = torch.empty_like(torque)
    volts = region.voltage_V * (0.8 + 0.2 * torch.rand(MANY, device="cuda"))
    kelvins = 300.0 + 40.0 * torch.rand(MANY, device="cuda")
    fused = torch.compile(on.clip, fullgraph=True)
    ways = {
        "copy": lambda: target.copy_(torque),
        "clip, eager": lambda: on.clip(torque, velocity),
        "clip, compiled": lambda: fused(torque, velocity),
        "clip there, eager": lambda: on.clip(torque, velocity, volts, kelvins),
    }
    times = medians_us(ways, wait, 10)
    for name, work in ways.items():
        torch.cuda.reset_peak_memory_stats()
        before = torch.cuda.memory_allocated()
        work()
        more = (torch.cuda.max_memory_allocated() - before) / (4.0 * MANY)
        took = times[name]
        print(f"  {'1e7 ' + name:26}{took:9.1f} us{took / times['copy']:8.2f} copies, {more:.1f} "
              "arrays of memory")


def of_jax(region):
    try:
        import jax
    except ImportError:
        print("  JAX: not installed")
        return
    import jax.numpy as jnp

    end, peak = region.table["speed_rad_s"][-1], region.peak_torque_Nm
    one, other = jax.random.split(jax.random.PRNGKey(1))
    velocity = jax.random.uniform(one, (ROBOTS, JOINTS), minval=-1.2 * end, maxval=1.2 * end)
    torque = jax.random.uniform(other, (ROBOTS, JOINTS), minval=-1.5 * peak, maxval=1.5 * peak)

    def motor(effort, speed):
        stall, cap = 4.0 * peak, peak
        speed = jnp.clip(speed, -end * (1.0 + cap / stall), end * (1.0 + cap / stall))
        most = jnp.minimum(stall * (1.0 - speed / end), cap)
        least = jnp.maximum(stall * (-1.0 - speed / end), -cap)
        return jnp.clip(effort, least, most)

    volts = region.voltage_V * jnp.linspace(0.6, 1.0, ROBOTS)[:, None]
    kelvins = jnp.linspace(300.0, 340.0, ROBOTS)[:, None]
    ways = {
        "DCMotor": motor,
        "clip": region.clip,
        "clip there": lambda t, w: region.clip(t, w, volts, kelvins),
        "torque": region.torque,
    }
    last = [None]

    def kept(jitted):
        def call():
            last[0] = jitted(torque, velocity)

        return call

    calls = {name: kept(jax.jit(work)) for name, work in ways.items()}
    times = medians_us(calls, lambda: last[0].block_until_ready())
    slopes = jax.grad(lambda w: region.clip(torque, w).sum())(velocity)
    for name, took in times.items():
        print(f"  {name + ', JAX jit':26}{took:9.1f} us{took / times['DCMotor']:8.2f} of DCMotor JAX jit")
    print(f"  JAX slopes finite: {bool(jnp.isfinite(slopes).all())}")


def of_cupy(region):
    try:
        import cupy
    except ImportError:
        print("  CuPy: not installed")
        return
    velocity = cupy.linspace(-1.2, 1.2, 1001) * region.table["speed_rad_s"][-1]
    torque = 2.0 * region.peak_torque_Nm * cupy.where(cupy.arange(1001) % 2 == 0, 1.0, -1.0)
    off = cupy.asnumpy(region.clip(torque, velocity)) - region.clip(
        cupy.asnumpy(torque), cupy.asnumpy(velocity)
    )
    print(f"  CuPy off NumPy by {abs(off).max() / region.peak_torque_Nm:.1e} of the peak")


def main():
    files = [word for word in sys.argv[1:] if not word.startswith("--")]
    device = "cpu" if "--cpu" in sys.argv else "cuda"
    try:
        import torch
    except ImportError:
        torch = None
    if torch is None or (device == "cuda" and not torch.cuda.is_available()):
        print("skipped: no PyTorch with a CUDA device here")
        return 77
    name = torch.cuda.get_device_name() if device == "cuda" else "CPU"
    print(f"{name}, PyTorch {torch.__version__}, {ROBOTS} x {JOINTS}; goals: eager 1.5 and there 3 of "
          "DCMotor's, compiled 1, JAX 1.5, 1e7 4 copies compiled")
    for file in files:
        region = loaded(file)
        of_torch(torch, device, region, 100 if device == "cuda" else 3)
        of_jax(region)
        of_cupy(region)
    return 0


sys.exit(main())
