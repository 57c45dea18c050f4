// SPDX-License-Identifier: Apache-2.0
// Batched clipping against copying the same arrays, in one run and one thread. The claim: 1e7
// samples take at most three times as long to clip as to copy.
#include <benchmark/benchmark.h>

#include <cstring>
#include <random>
#include <vector>

#include "actuator/mor/clip_table.hpp"
#include "actuator/motor/actuator_spec.hpp"

namespace torquewright::actuator {
namespace {

constexpr std::size_t kSamples = 10'000'000;

/// Speeds and torques at random, so that no branch can be foreseen, and room for the answer and for
/// the copies.
struct Samples {
  std::vector<double> speed_rad_s = std::vector<double>(kSamples);
  std::vector<double> torque_Nm = std::vector<double>(kSamples);
  std::vector<double> clipped_Nm = std::vector<double>(kSamples);
  std::vector<double> copy = std::vector<double>(kSamples);

  Samples() {
    std::mt19937 dice(1);
    std::uniform_real_distribution<double> speed(-14.0, 14.0);
    std::uniform_real_distribution<double> torque(-400.0, 400.0);
    for (double& value : speed_rad_s) value = speed(dice);
    for (double& value : torque_Nm) value = torque(dice);
  }
};

Samples& samples() {
  static Samples made;
  return made;
}

void copy_arrays(benchmark::State& state) {
  Samples& of = samples();
  for (auto _ : state) {
    std::memcpy(of.clipped_Nm.data(), of.torque_Nm.data(), kSamples * sizeof(double));
    std::memcpy(of.copy.data(), of.speed_rad_s.data(), kSamples * sizeof(double));
    benchmark::ClobberMemory();
  }
}

template <typename Limits>
void clip_arrays(benchmark::State& state, const Limits& limits) {
  Samples& of = samples();
  for (auto _ : state) {
    clip(limits, of.speed_rad_s.data(), of.torque_Nm.data(), of.clipped_Nm.data(), kSamples);
    benchmark::ClobberMemory();
  }
}

void clip_to_parallelogram(benchmark::State& state) {
  clip_arrays(state, Parallelogram{1536.0, 10.5, 320.0});
}

void clip_to_table(benchmark::State& state) {
  const Actuator knee =
      read_actuator(TORQUEWRIGHT_SOURCE_DIR "/specs/actuator/d151_knee.json").actuator;
  const ClipTable table(mor_table(Region(knee, {})));
  clip_arrays(state, table.view());
}

BENCHMARK(copy_arrays)->Unit(benchmark::kMillisecond);
BENCHMARK(clip_to_parallelogram)->Unit(benchmark::kMillisecond);
BENCHMARK(clip_to_table)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace torquewright::actuator

BENCHMARK_MAIN();
