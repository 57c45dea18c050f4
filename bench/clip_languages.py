#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What it takes to clip a million samples in each language, as a ratio to copying them.

clip_languages.py PROGRAM [ACTUATOR]: PROGRAM is build/release/src/torquewright. Exports the region
as a C header and a Python module, compiles the one with cc -O2, runs the other in NumPy and, where
it is installed, PyTorch (double and single precision, one thread). Speeds and torques at random, so
that no branch can be foreseen. A copy is of both arrays, by memcpy, numpy.copyto or Tensor.copy_.
The least of some repetitions; C++ is measured by bench/clip."""

import importlib.util
import pathlib
import subprocess
import sys
import tempfile
import time

SAMPLES = 1_000_000
REPEATS = 15
VOLTAGE_V = 60.0  # as a number; and as one per 4096 samples, as parallel environments have it

C_PROGRAM = r"""
#define _POSIX_C_SOURCE 199309L
#include "region.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
enum { kSamples = %d, kRepeats = %d };
static double seconds(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}
static double uniform(double most) { return most * (2.0 * rand() / (double)RAND_MAX - 1.0); }
int main(void) {
  double* speed = malloc(kSamples * sizeof(double));
  double* torque = malloc(kSamples * sizeof(double));
  double* out = malloc(kSamples * sizeof(double));
  double* other = malloc(kSamples * sizeof(double));
  const torquewright_region_row* row = %s.row;
  double end = row[%s.rows - 1].speed_rad_s, best[3] = {1e9, 1e9, 1e9}, sum = 0.0;
  int i, k, r;
  for (i = 0; i < kSamples; ++i) {
    speed[i] = uniform(1.1 * end);
    torque[i] = uniform(1.3 * %s.peak_torque_Nm);
  }
  for (r = 0; r < kRepeats; ++r) {
    for (k = 0; k < 3; ++k) {
      const double begin = seconds();
      double taken;
      if (k == 0) {
        memcpy(out, torque, kSamples * sizeof(double));
        memcpy(other, speed, kSamples * sizeof(double));
      } else if (k == 1) {
        torquewright_region_clip_all(&%s, torque, speed, out, kSamples);
      } else {
        for (i = 0; i < kSamples; ++i) {
          out[i] = torquewright_region_clip_under(&%s, torque[i], speed[i], %g, 310.0);
        }
      }
      taken = seconds() - begin;
      sum += out[r] + other[r];
      if (taken < best[k]) best[k] = taken;
    }
  }
  printf("%%.9g %%.9g %%.9g\n", best[0], best[1], best[2]);
  return sum == 1e300;
}
"""


def exported(program, actuator, language, file):
    subprocess.run([program, "actuator", "mor", actuator, "--format", language, "-o", str(file)],
                   check=True, stdout=subprocess.DEVNULL)


def line(language, copy, clip, under, many=None):
    more = "" if many is None else f"{many / copy:10.1f}"
    print(f"{language:16}{1e3 * copy:10.2f}{clip / copy:10.1f}{under / copy:10.1f}{more}")


def in_c(program, actuator, folder):
    exported(program, actuator, "c", folder / "region.h")
    text = (folder / "region.h").read_text()
    name = text.split("static const torquewright_region ")[1].split(" = ")[0]
    (folder / "main.c").write_text(
        C_PROGRAM % (SAMPLES, REPEATS, name, name, name, name, name, VOLTAGE_V))
    subprocess.run(["cc", "-std=c99", "-O2", "main.c", "-o", "main"], cwd=folder, check=True)
    run = subprocess.run([folder / "main"], check=True, capture_output=True, text=True)
    line("C, double", *map(float, run.stdout.split()))


def least(work):
    best = float("inf")
    for _ in range(REPEATS):
        begin = time.perf_counter()
        work()
        best = min(best, time.perf_counter() - begin)
    return best


def in_python(region, numpy, end, peak):
    dice = numpy.random.default_rng(1)
    speed = dice.uniform(-1.1 * end, 1.1 * end, SAMPLES)
    torque = dice.uniform(-1.3 * peak, 1.3 * peak, SAMPLES)
    volts = numpy.repeat(dice.uniform(50.0, 70.0, -(-SAMPLES // 4096)), 4096)[:SAMPLES]
    return speed, torque, volts


def main():
    program = sys.argv[1]
    actuator = sys.argv[2] if len(sys.argv) > 2 else "specs/actuator/d151_knee.json"
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        print(f"{SAMPLES} samples, {actuator}; ratios to a copy, least of {REPEATS}")
        print(f"{'':16}{'copy [ms]':>10}{'clip':>10}{'volts':>10}{'volts each':>10}")
        in_c(program, actuator, folder)
        exported(program, actuator, "python", folder / "region.py")
        spec = importlib.util.spec_from_file_location("region", folder / "region.py")
        region = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(region)
    import numpy

    end, peak = region.REGION.table["speed_rad_s"][-1], region.REGION.peak_torque_Nm
    speed, torque, volts = in_python(region, numpy, end, peak)
    one, other = numpy.empty_like(torque), numpy.empty_like(speed)

    def copy():
        numpy.copyto(one, torque)
        numpy.copyto(other, speed)

    line("NumPy, double", least(copy), least(lambda: region.clip(torque, speed)),
         least(lambda: region.clip(torque, speed, VOLTAGE_V)),
         least(lambda: region.clip(torque, speed, volts)))
    try:
        import torch
    except ImportError:
        print("PyTorch: not installed")
        return
    torch.set_num_threads(1)
    for kind, title in ((torch.float64, "PyTorch, double"), (torch.float32, "PyTorch, single")):
        s, t, v = (torch.tensor(a, dtype=kind) for a in (speed, torque, volts))
        a, b = torch.empty_like(t), torch.empty_like(s)

        def copy_tensors():
            a.copy_(t)
            b.copy_(s)

        line(title, least(copy_tensors), least(lambda: region.clip(t, s)),
             least(lambda: region.clip(t, s, VOLTAGE_V)), least(lambda: region.clip(t, s, v)))


main()
