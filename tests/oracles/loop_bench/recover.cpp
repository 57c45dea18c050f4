// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/loop_bench/recover.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace torquewright::oracles::loop {
namespace {

using std::numbers::pi;
using Series = std::vector<double>;

constexpr double kStateCut_Hz = 40.0, kJudgedCut_Hz = 12.0, kJudgedRate_Hz = 250.0;
constexpr double kCutAtEnds_s = 0.4, kBlock_s = 1.0;
constexpr double kRest_rad_s = 0.03, kRest_s = 0.02, kAwayFromRest_s = 0.06;

/// First order, there and back, twice.
void smooth(Series& values, double step_s, double cut_Hz) {
  const double part = 1.0 - std::exp(-2.0 * pi * cut_Hz * step_s);
  const auto pass = [part](auto begin, auto end) {
    double now = *begin;
    for (auto at = begin; at != end; ++at) *at = now += part * (*at - now);
  };
  for (int twice = 0; twice < 2; ++twice) {
    pass(values.begin(), values.end());
    pass(values.rbegin(), values.rend());
  }
}

Series slope_of(const Series& values, double step_s) {
  Series out(values.size(), 0.0);
  for (std::size_t k = 2; k + 2 < values.size(); ++k)
    out[k] =
        (8.0 * (values[k + 1] - values[k - 1]) - (values[k + 2] - values[k - 2])) / (12.0 * step_s);
  return out;
}

/// What one run's rows hold, smoothed and thinned.
struct Heard {
  double step_s = 0.0;
  std::array<Series, 2> q, v, a;
  Series current, duty, bus, volts;
};

/// The laws, and what is no law of the drive.
struct Truth {
  std::vector<Law> hidden;
  double delay_s = 0.0, offset_A = 0.0;
};

/// A number of the truth that is fitted.
struct Free {
  std::size_t belongs_to;  ///< Index in the situation's hidden names; beyond them: nobody's.
  std::string key;
  bool is_phase = false;
};

Heard heard_of(const Situation& it, const Record& record) {
  const double row_s = 1.0 / it.sensing.rate_Hz;
  const auto thin =
      std::max<std::size_t>(1, static_cast<std::size_t>(it.sensing.rate_Hz / kJudgedRate_Hz));
  const auto series = [&](auto value) {
    Series all;
    for (const Row& row : record) all.push_back(value(row));
    smooth(all, row_s, std::min(kStateCut_Hz, 0.2 * it.sensing.rate_Hz));
    Series out;
    for (std::size_t k = 0; k < all.size(); k += thin) out.push_back(all[k]);
    return out;
  };
  Heard out;
  out.step_s = row_s * static_cast<double>(thin);
  for (std::size_t j = 0; j < 2; ++j) {
    const std::size_t joint = std::min(j, it.rig.joints() - 1);
    out.q[j] = series([joint](const Row& row) { return row.joints[joint].position_rad; });
    out.v[j] = slope_of(out.q[j], out.step_s);
    out.a[j] = slope_of(out.v[j], out.step_s);
  }
  const std::size_t j = it.joint;
  out.current = series([j](const Row& row) { return row.joints[j].current_A; });
  out.duty = series([j](const Row& row) { return row.joints[j].duty; });
  out.bus = series([j](const Row& row) { return row.joints[j].bus_V; });
  out.volts = series([j](const Row& row) { return row.joints[j].duty * row.joints[j].bus_V; });
  return out;
}

/// The current that the motion takes under these laws.
Series predicted_current_A(const Situation& it, const Heard& heard, const Truth& truth) {
  Drive drive = it.rig.drives[it.joint];
  drive.hidden = truth.hidden;
  const std::vector<Law> laws = drive.laws();
  const std::size_t j = it.joint;
  Series out;
  for (std::size_t k = 0; k < heard.q[0].size(); ++k) {
    const Pair q{heard.q[0][k], heard.q[1][k]}, v{heard.v[0][k], heard.v[1][k]};
    const LinkTorques links = link_torques(it.rig, q, v);
    const double alone = it.rig.joints() > 1 ? 1.0 : 0.0;
    const double a0 = heard.a[0][k], a1 = alone * heard.a[1][k];
    const Pair load{links.m11 * a0 + links.m12 * a1 + links.bias_Nm[0],
                    links.m12 * a0 + links.m22 * a1 + links.bias_Nm[1]};
    const Moment at{static_cast<double>(k) * heard.step_s, q[j], v[j], load[j]};
    const DryFriction dry = dry_friction(laws, at);
    const double rub = v[j] > 0.0 ? dry.forwards_Nm : -dry.backwards_Nm;
    const double torque_Nm = load[j] + drive.reflected_inertia_kg_m2() * heard.a[j][k] + rub -
                             smooth_torque_Nm(laws, at, drive.ratio);
    out.push_back(current_of_A(laws, torque_Nm / drive.torque_per_current_Nm_A()));
  }
  if (const Law* lag = law_named(laws, "torque_lag")) {
    const Series rate = slope_of(out, heard.step_s);
    for (std::size_t k = 0; k < out.size(); ++k) out[k] += lag->at("time_constant_s") * rate[k];
  }
  return out;
}

Series delayed(const Series& values, double steps) {
  Series out(values);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double at =
        std::clamp(static_cast<double>(k) - steps, 0.0, static_cast<double>(values.size()) - 1.001);
    const auto low = static_cast<std::size_t>(at);
    const double part = at - static_cast<double>(low);
    out[k] = (1.0 - part) * values[low] + part * values[low + 1];
  }
  return out;
}

/// Rows away from standstill, where dry friction is whatever the motion asks for.
std::vector<bool> moves_at(const Series& speed, double step_s) {
  std::vector<bool> moves(speed.size(), true);
  const auto apart = static_cast<std::size_t>(kAwayFromRest_s / step_s);
  const auto enough = static_cast<std::size_t>(kRest_s / step_s) + 1;
  std::size_t still = 0;
  for (std::size_t k = 0; k < speed.size(); ++k) {
    still = std::abs(speed[k]) < kRest_rad_s ? still + 1 : 0;
    if (still < enough) continue;
    const std::size_t begin = k + 1 < still + apart ? 0 : k + 1 - still - apart;
    for (std::size_t at = begin; at < std::min(k + apart, speed.size()); ++at) moves[at] = false;
  }
  return moves;
}

/// Measured less predicted, of the one equation that a current allows or of the two of voltages.
std::vector<Series> equations_of(const Situation& it, const Heard& heard, const Truth& truth) {
  const Drive& drive = it.rig.drives[it.joint];
  Series current = predicted_current_A(it, heard, truth);
  if (!it.sensing.logs_voltage) {
    current = delayed(current, truth.delay_s / heard.step_s);
    for (std::size_t k = 0; k < current.size(); ++k)
      current[k] = heard.current[k] - current[k] - truth.offset_A;
    return {current};
  }
  Series winding(current.size()), bus(current.size());
  const Law* dead = law_named(truth.hidden, "inverter_dead_time");
  const Law* sag = law_named(truth.hidden, "voltage_sag");
  for (std::size_t k = 0; k < current.size(); ++k) {
    const double i = current[k];
    winding[k] = heard.volts[k] - drive.resistance_ohm * i -
                 drive.torque_per_current_Nm_A() * heard.v[it.joint][k];
    if (dead != nullptr) winding[k] -= std::copysign(dead->at("voltage_V"), i);
    bus[k] = heard.bus[k] - drive.bus_V;
    if (sag != nullptr) bus[k] += sag->at("resistance_ohm") * heard.duty[k] * i;
  }
  return {winding, bus};
}

/// All equations of all runs behind the same filter, with the lengths of its pieces.
struct Rest {
  std::vector<Series> equations;  ///< Each over all runs.
  std::size_t block = 1;
};

Rest rest_of(const Situation& it, const std::vector<Heard>& runs, const Truth& truth) {
  Rest rest;
  for (const Heard& heard : runs) {
    auto parts = equations_of(it, heard, truth);
    rest.equations.resize(parts.size());
    rest.block = static_cast<std::size_t>(kBlock_s / heard.step_s);
    const auto cut = static_cast<std::size_t>(kCutAtEnds_s / heard.step_s);
    const auto moves = moves_at(heard.v[it.joint], heard.step_s);
    for (std::size_t e = 0; e < parts.size(); ++e) {
      smooth(parts[e], heard.step_s, kJudgedCut_Hz);
      for (std::size_t k = cut; k + cut < moves.size(); ++k)
        if (moves[k]) rest.equations[e].push_back(parts[e][k]);
    }
  }
  return rest;
}

double rms(const Series& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

/// One row of numbers for all equations, each in units of what the truth leaves of it.
Series scaled(const Rest& rest, const std::vector<double>& floors) {
  Series out;
  for (std::size_t e = 0; e < floors.size(); ++e)
    for (const double value : rest.equations[e]) out.push_back(value / floors[e]);
  return out;
}

double* number(Truth& truth, const std::vector<std::string>& names, const Free& free) {
  if (free.key == "delay_s") return &truth.delay_s;
  if (free.key == "offset_A") return &truth.offset_A;
  for (Law& law : truth.hidden)
    if (law.name == names[free.belongs_to]) return &law.values.at(free.key);
  return nullptr;
}

std::vector<Free> free_numbers(const Situation& it, const Truth& truth) {
  std::vector<Free> free;
  bool has_delay = it.sensing.logs_voltage;
  for (std::size_t h = 0; h < it.hidden.size(); ++h) {
    if (it.hidden[h] == "channel_delay") free.push_back({h, "delay_s"}), has_delay = true;
    if (it.hidden[h] == "current_offset") free.push_back({h, "offset_A"});
    if (const Law* law = law_named(truth.hidden, it.hidden[h]))
      for (const auto& [key, value] : law->values)
        if (key != "order") free.push_back({h, key, key == "phase_rad"});
  }
  if (!has_delay) free.push_back({it.hidden.size(), "delay_s"});
  return free;
}

/// Gaussian elimination with pivots; empty where singular.
std::vector<Series> inverse_of(std::vector<Series> m) {
  const std::size_t n = m.size();
  std::vector<Series> inverse(n, Series(n, 0.0));
  for (std::size_t k = 0; k < n; ++k) inverse[k][k] = 1.0;
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t best = k;
    for (std::size_t r = k; r < n; ++r)
      if (std::abs(m[r][k]) > std::abs(m[best][k])) best = r;
    if (!(std::abs(m[best][k]) > 0.0)) return {};
    std::swap(m[k], m[best]);
    std::swap(inverse[k], inverse[best]);
    for (std::size_t r = 0; r < n; ++r) {
      if (r == k) continue;
      const double share = m[r][k] / m[k][k];
      for (std::size_t c = 0; c < n; ++c) {
        m[r][c] -= share * m[k][c];
        inverse[r][c] -= share * inverse[k][c];
      }
    }
  }
  for (std::size_t k = 0; k < n; ++k)
    for (double& value : inverse[k]) value /= m[k][k];
  return inverse;
}

struct Fit {
  Series step, error;  ///< Of each free number; empty where they cannot be told apart.
};

/// One step of Gauss and Newton, errors from sums over blocks.
Fit fit_step(const Series& rest, const std::vector<Series>& slopes, std::size_t block) {
  const std::size_t n = slopes.size();
  std::vector<Series> normal(n, Series(n, 0.0)), scatter(n, Series(n, 0.0));
  Series right(n, 0.0), sum(n, 0.0);
  for (std::size_t k = 0; k < rest.size(); ++k) {
    for (std::size_t r = 0; r < n; ++r) {
      sum[r] += slopes[r][k] * rest[k];
      right[r] -= slopes[r][k] * rest[k];
      for (std::size_t c = 0; c < n; ++c) normal[r][c] += slopes[r][k] * slopes[c][k];
    }
    if ((k + 1) % block != 0) continue;
    for (std::size_t r = 0; r < n; ++r)
      for (std::size_t c = 0; c < n; ++c) scatter[r][c] += sum[r] * sum[c];
    sum.assign(n, 0.0);
  }
  const auto inverse = inverse_of(normal);
  if (inverse.empty()) return {};
  Fit fit{Series(n, 0.0), Series(n, 0.0)};
  for (std::size_t r = 0; r < n; ++r) {
    for (std::size_t c = 0; c < n; ++c) fit.step[r] += inverse[r][c] * right[c];
    for (std::size_t a = 0; a < n; ++a)
      for (std::size_t b = 0; b < n; ++b)
        fit.error[r] += inverse[r][a] * scatter[a][b] * inverse[b][r];
    fit.error[r] = std::sqrt(std::max(fit.error[r], 0.0));
  }
  return fit;
}

Fit fit_about(const Situation& it, const std::vector<Heard>& runs, const Truth& truth,
              const std::vector<Free>& free, const std::vector<double>& floors) {
  const Rest here = rest_of(it, runs, truth);
  const Series rest = scaled(here, floors);
  std::vector<Series> slopes;
  for (const Free& each : free) {
    Truth moved = truth;
    double* value = number(moved, it.hidden, each);
    const double step = std::max(1e-3 * std::abs(*value), 1e-6);
    *value += step;
    Series slope = scaled(rest_of(it, runs, moved), floors);
    for (std::size_t k = 0; k < slope.size(); ++k) slope[k] = (slope[k] - rest[k]) / step;
    slopes.push_back(std::move(slope));
  }
  return fit_step(rest, slopes, here.block);
}

Truth without(const Situation& it, Truth truth, const std::string& name) {
  if (name == "current_offset") truth.offset_A = 0.0;
  if (name == "channel_delay") truth.delay_s -= it.sensing.current_delay_s;
  std::erase_if(truth.hidden, [&](const Law& law) { return law.name == name; });
  return truth;
}

double size_of(const Situation& it, const std::vector<Heard>& runs, const Truth& truth,
               const std::string& name, const std::vector<double>& floors) {
  const Rest with = rest_of(it, runs, truth), less = rest_of(it, runs, without(it, truth, name));
  double most = 0.0;
  for (std::size_t e = 0; e < floors.size(); ++e) {
    Series change = less.equations[e];
    for (std::size_t k = 0; k < change.size(); ++k) change[k] -= with.equations[e][k];
    most = std::max(most, rms(change) / floors[e]);
  }
  return most;
}

/// What a number is where its law does nothing, or is no more than a simpler one.
struct Neutral {
  double value = 0.0, error = 0.0;
};

Neutral neutral_of(const Situation& it, Truth& truth, const std::vector<Free>& free, const Fit& fit,
                   std::size_t k) {
  if (free[k].key == "factor") return {1.0, 0.0};
  const std::string simpler = free[k].key == "breakaway_Nm"          ? "coulomb_Nm"
                              : free[k].key == "coulomb_negative_Nm" ? "coulomb_positive_Nm"
                                                                     : "";
  for (std::size_t other = 0; other < free.size(); ++other)
    if (free[other].belongs_to == free[k].belongs_to && free[other].key == simpler)
      return {*number(truth, it.hidden, free[other]), fit.error[other]};
  return {};
}

}  // namespace

void recover(Made& made) {
  const Situation& it = made.situation;
  std::vector<Heard> runs;
  for (const Record& record : made.records) runs.push_back(heard_of(it, record));
  Truth truth{it.rig.drives[it.joint].hidden,
              it.sensing.current_delay_s + 0.5 / pi / it.sensing.current_filter_Hz,
              it.sensing.current_offset_A};
  std::vector<double> floors;
  for (const Series& each : rest_of(it, runs, truth).equations) floors.push_back(rms(each));
  made.floors = floors;
  for (const std::string& name : it.hidden)
    made.size_floors.push_back(size_of(it, runs, truth, name, floors));
  const auto free = free_numbers(it, truth);
  Fit fit;
  constexpr int kRounds = 3;
  for (int round = 0; round < kRounds; ++round) {
    fit = fit_about(it, runs, truth, free, floors);
    for (std::size_t k = 0; k < fit.step.size(); ++k) {
      double* value = number(truth, it.hidden, free[k]);
      const double most = std::max(0.3 * std::abs(*value), 1e-6);
      *value += std::clamp(fit.step[k], -most, most);
    }
  }
  made.is_recoverable.assign(it.hidden.size(), !fit.error.empty());
  for (std::size_t k = 0; k < fit.error.size(); ++k) {
    if (free[k].is_phase || free[k].belongs_to >= it.hidden.size()) continue;
    const Neutral neutral = neutral_of(it, truth, free, fit, k);
    const double beyond = std::abs(*number(truth, it.hidden, free[k]) - neutral.value);
    if (!(beyond > 3.0 * std::hypot(fit.error[k], neutral.error)))
      made.is_recoverable[free[k].belongs_to] = false;
  }
}

}  // namespace torquewright::oracles::loop
