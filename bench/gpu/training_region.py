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
    spec.loader.exec_module(module)
    return module.REGION


def median_us(work, wait, repeats=200):
    for _ in range(10):
        work()
    wait()
    times = []
    for _ in range(7):
        begin = time.perf_counter()
        for _ in range(repeats):
            work()
        wait()
        times.append(1e6 * (time.perf_counter() - begin) / repeats)
    return statistics.median(times)


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


def worst_of(torch, region, speed):
    """Of both bounds in single precision against double on the processor, of the peak torque."""
    narrow = region.limits(speed)
    wide = region.limits(speed.double().cpu())
    off = [(one.double().cpu() - other).abs().max().item() for one, other in zip(narrow, wide)]
    return max(off) / region.peak_torque_Nm


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
    motor = DcMotor(torch, 4.0 * peak, end, peak, velocity)
    copy = torch.empty_like(torque)
    print(f"{region.name}: single precision off by {worst_of(torch, region, velocity):.2g} of the peak")
    rows = {
        "copy": lambda: copy.copy_(torque),
        "DCMotor eager": lambda: motor(torque, velocity),
        "clip eager": lambda: on.clip(torque, velocity),
        "there eager": lambda: on.clip(torque, velocity, volts, kelvins),
        "torque eager": lambda: on.torque(torque, velocity),
    }
    if hasattr(torch, "compile") and device == "cuda":
        fused_motor = torch.compile(motor, fullgraph=True)
        fused = torch.compile(on.clip, fullgraph=True)
        rows["DCMotor compiled"] = lambda: fused_motor(torque, velocity)
        rows["clip compiled"] = lambda: fused(torque, velocity)
        rows["there compiled"] = lambda: fused(torque, velocity, volts, kelvins)
        rows["clip in a CUDA graph"] = graph_of(torch, lambda: on.clip(torque, velocity))
    times = {name: median_us(work, wait, repeats) for name, work in rows.items()}
    for name, took in times.items():
        yardstick = "DCMotor compiled" if "compiled" in name or "graph" in name else "DCMotor eager"
        ratio = took / times.get(yardstick, times["DCMotor eager"])
        print(f"  {name:24}{took:10.1f} us{ratio:8.2f} of {yardstick}")
    if device == "cuda":
        of_many(torch, on, end, peak, wait)


def graph_of(torch, work):
    stream = torch.cuda.Stream()
    with torch.cuda.stream(stream):
        work()
    torch.cuda.synchronize()
    graph = torch.cuda.CUDAGraph()
    with torch.cuda.graph(graph):
        work()
    return graph.replay


def of_many(torch, on, end, peak, wait):
    """So many samples that the memory's speed decides: the yardstick is a copy."""
    velocity = torch.rand(MANY, device="cuda") * 2.4 * end - 1.2 * end
    torque = torch.rand(MANY, device="cuda") * 3.0 * peak - 1.5 * peak
    copy = torch.empty_like(torque)
    base = median_us(lambda: copy.copy_(torque), wait, 20)
    for name, work in {"eager": on.clip, "compiled": torch.compile(on.clip, fullgraph=True)}.items():
        work(torque, velocity)
        torch.cuda.reset_peak_memory_stats()
        before = torch.cuda.memory_allocated()
        took = median_us(lambda: work(torque, velocity), wait, 20)
        more = (torch.cuda.max_memory_allocated() - before) / (4.0 * MANY)
        print(f"  1e7 {name:20}{took:10.1f} us{took / base:8.2f} copies, {more:.1f} arrays of memory")


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

    times = {}
    for name, work in {"DCMotor": motor, "clip": region.clip}.items():
        jitted = jax.jit(work)
        times[name] = median_us(lambda: jitted(torque, velocity).block_until_ready(), lambda: None)
    slopes = jax.grad(lambda w: region.clip(torque, w).sum())(velocity)
    print(f"  JAX clip {times['clip']:.1f} us, {times['clip'] / times['DCMotor']:.2f} of DCMotor jitted;"
          f" slopes finite: {bool(jnp.isfinite(slopes).all())}")


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
        of_torch(torch, device, region, 200 if device == "cuda" else 3)
        of_jax(region)
    return 0


sys.exit(main())
