// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/mujoco_bench/profile.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace torquewright::oracles::mujoco_bench {
namespace {

constexpr double kTurn_rad = 2 * std::numbers::pi;
/// From one level to the next.
constexpr double kRamp_s = 0.08;

double stepped(const Profile& profile, double time_s) {
  const auto count = profile.levels.size();
  const auto index = static_cast<std::size_t>(time_s / profile.period_s);
  const double since = time_s - static_cast<double>(index) * profile.period_s;
  const double before = index == 0 ? 0 : profile.levels[(index - 1) % count];
  const double share = std::min(1.0, since / kRamp_s);
  return before + share * (profile.levels[index % count] - before);
}

double ramped(const Profile& profile, double time_s) {
  const double phase = std::fmod(time_s / profile.period_s + 0.25, 1.0);
  return phase < 0.5 ? 4 * phase - 1 : 3 - 4 * phase;
}

double swept(const Profile& profile, double time_s) {
  const double rate = (profile.last_hz - profile.first_hz) / profile.duration_s;
  return std::sin(kTurn_rad * (profile.first_hz * time_s + rate * time_s * time_s / 2));
}

double summed(const Profile& profile, double time_s) {
  double sum = 0;
  for (const Profile::Sine& one : profile.sines)
    sum += one.share * std::sin(kTurn_rad * one.hz * time_s + one.phase_rad);
  return sum;
}

/// Shares such that the sum reaches about one.
void normalise(std::vector<Profile::Sine>& sines) {
  double squares = 0, whole = 0;
  for (const auto& one : sines) {
    squares += one.share * one.share;
    whole += one.share;
  }
  const double peak = std::min(whole, 2.2 * std::sqrt(squares / 2) * std::numbers::sqrt2);
  for (auto& one : sines) one.share /= peak;
}

}  // namespace

double Profile::operator()(double time_s) const {
  double value = 1;
  if (kind == "steps") value = stepped(*this, time_s);
  if (kind == "triangle") value = ramped(*this, time_s);
  if (kind == "chirp") value = swept(*this, time_s);
  if (kind == "sines") value = summed(*this, time_s);
  return kind == "constant" ? offset : offset + amplitude * value;
}

Profile constant(double level) {
  Profile profile;
  profile.offset = level;
  return profile;
}

Profile steps(Draws& draws, double amplitude, double period_s, double duration_s) {
  Profile profile{.kind = "steps", .amplitude = amplitude, .period_s = period_s};
  const int count = static_cast<int>(duration_s / period_s) + 1;
  double sign = draws.sign();
  for (int k = 0; k < count; ++k) {
    profile.levels.push_back(sign * (k % 3 == 0 ? 1 : draws.log_uniform(0.1, 1)));
    if (draws.chance(0.7)) sign = -sign;
  }
  return profile;
}

Profile triangle(double amplitude, double period_s) {
  return {.kind = "triangle", .amplitude = amplitude, .period_s = period_s};
}

Profile chirp(double amplitude, double first_hz, double last_hz, double duration_s) {
  return {.kind = "chirp",
          .amplitude = amplitude,
          .first_hz = first_hz,
          .last_hz = last_hz,
          .duration_s = duration_s};
}

Profile sines(Draws& draws, double amplitude, double first_hz, double last_hz, int count) {
  Profile profile{.kind = "sines", .amplitude = amplitude};
  for (int k = 0; k < count; ++k)
    profile.sines.push_back({1, draws.log_uniform(first_hz, last_hz), draws.uniform(0, kTurn_rad)});
  normalise(profile.sines);
  return profile;
}

Profile gait(Draws& draws, double amplitude, double hz) {
  Profile profile{.kind = "sines", .amplitude = amplitude};
  for (int k = 1; k <= 4; ++k)
    profile.sines.push_back({draws.uniform(0.3, 1) / k, k * hz, draws.uniform(0, kTurn_rad)});
  normalise(profile.sines);
  return profile;
}

}  // namespace torquewright::oracles::mujoco_bench
