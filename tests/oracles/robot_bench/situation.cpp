// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/robot_bench/situation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "tests/oracles/robot_bench/missing.hpp"
#include "tests/oracles/robot_bench/motions.hpp"
#include "tests/oracles/robot_bench/robots.hpp"

namespace torquewright::oracles::robot_bench {
namespace {

double rounded(double value, int digits = 4) {
  return std::stod(fmt::format("{:.{}g}", value, digits));
}

/// Of each joint over its range, others anywhere: greatest inertia and greatest weight.
struct Weight {
  double inertia_kg_m2 = 0, gravity_Nm = 0;
};

std::vector<Weight> weights(const Scene& scene, Draws& draws) {
  Scene bare = scene;
  for (auto& [name, laws] : bare.laws) laws = Laws{};
  const Model model = compile(mjcf(bare, 1e-3));
  const Data data(mj_makeData(model.get()));
  const auto names = scene.robot.moved();
  std::vector<Weight> all(names.size());
  const auto n = static_cast<std::size_t>(model->nv);
  std::vector<mjtNum> full(n * n);
  for (int k = 0; k < 20; ++k) {
    for (std::size_t j = 0; j < n; ++j) {
      const Joint& joint = scene.robot.joint(names[j]);
      data->qpos[j] = joint.middle_rad() +
                      draws.uniform(-0.4, 0.4) * std::min(1.5, joint.high_rad - joint.low_rad);
    }
    mj_forward(model.get(), data.get());
    mj_fullM(model.get(), full.data(), data->qM);
    for (std::size_t j = 0; j < n; ++j) {
      all[j].inertia_kg_m2 = std::max(all[j].inertia_kg_m2, full[j * n + j]);
      all[j].gravity_Nm = std::max(all[j].gravity_Nm, std::abs(data->qfrc_bias[j]));
    }
  }
  return all;
}

/// The first of the joints that are alike with this one.
std::string first_alike(const Robot& robot, const std::string& joint) {
  for (const auto& group : robot.alike)
    if (std::find(group.begin(), group.end(), joint) != group.end()) return group.front();
  return joint;
}

/// The greatest of alike joints, for each of them.
template <class Field>
void even_out(const Robot& robot, std::vector<Weight>& all, Field field) {
  const auto names = robot.moved();
  for (std::size_t j = 0; j < names.size(); ++j)
    for (std::size_t k = 0; k < names.size(); ++k)
      if (first_alike(robot, names[j]) == first_alike(robot, names[k]))
        all[j].*field = std::max(all[j].*field, all[k].*field);
}

/// Where the model's author states nothing. Of light links the rotor is the greater part.
void draw_own_values(Draws& draws, Scene& scene, const std::vector<Weight>& all) {
  const auto names = scene.robot.moved();
  for (std::size_t j = 0; j < names.size(); ++j) {
    Joint& joint = scene.robot.joint(names[j]);
    const std::string first = first_alike(scene.robot, joint.name);
    if (first != joint.name) {
      const Joint& sister = scene.robot.joint(first);
      joint.armature_kg_m2 = sister.armature_kg_m2;
      joint.damping_Nm_s_rad = sister.damping_Nm_s_rad;
      joint.friction_Nm = sister.friction_Nm;
    } else if (joint.armature_kg_m2 == 0) {
      const double torque = all[j].gravity_Nm + all[j].inertia_kg_m2 * 10;
      joint.armature_kg_m2 = rounded(all[j].inertia_kg_m2 * draws.log_uniform(0.3, 4));
      joint.damping_Nm_s_rad = rounded(torque * draws.log_uniform(0.005, 0.05));
      joint.friction_Nm = rounded(torque * draws.log_uniform(0.005, 0.05));
    }
  }
  for (const std::string& name : names) {
    const Joint& joint = scene.robot.joint(name);
    Laws laws;
    laws.armature_kg_m2 = joint.armature_kg_m2;
    laws.coulomb_Nm[0] = laws.coulomb_Nm[1] = joint.friction_Nm;
    laws.viscous_Nm_s_rad[0] = laws.viscous_Nm_s_rad[1] = joint.damping_Nm_s_rad;
    scene.laws[name] = laws;
  }
}

void draw_loops(Draws& draws, Scene& scene, const std::vector<Weight>& all) {
  const auto names = scene.robot.moved();
  const double hz = draws.uniform(2, 6), damping = draws.uniform(0.3, 0.9);
  for (std::size_t j = 0; j < names.size(); ++j) {
    const Joint& joint = scene.robot.joint(names[j]);
    const double inertia = all[j].inertia_kg_m2 + joint.armature_kg_m2,
                 rate = 2 * std::numbers::pi * hz;
    Controller controller;
    controller.stiffness_Nm_rad =
        rounded(std::max(inertia * rate * rate, all[j].gravity_Nm / 0.15), 3);
    const double critical = 2 * std::sqrt(controller.stiffness_Nm_rad * inertia);
    controller.damping_Nm_s_rad =
        rounded(std::max(0.05 * critical, damping * critical - joint.damping_Nm_s_rad), 3);
    scene.controllers[joint.name] = controller;
  }
}

struct Rate {
  double hz, run_s;
  int runs;
};

void draw_format(Draws& draws, Situation& it, Rate& rate) {
  rate = draws.one_of(std::vector<Rate>{
      {50, 10, 4}, {100, 9, 3}, {200, 7, 3}, {200, 7, 3}, {500, 4, 3}, {1000, 3, 3}});
  it.format.row_s = 1 / rate.hz;
  it.format.encoder_step_rad =
      2 * std::numbers::pi / draws.one_of(std::vector<double>{4096, 16384, 65536});
  it.format.noise_rad = it.format.encoder_step_rad * draws.uniform(0.1, 0.7);
  it.format.has_speed = draws.chance(0.35);
  it.format.speed_filter_s = draws.log_uniform(2e-3, 2e-2);
  it.format.speed_step_rad_s = draws.chance(0.5) ? draws.log_uniform(1e-3, 5e-2) : 0;
}

/// Packets come with the rows, or more often than them, or (in fast logs) less often.
void draw_runs(Draws& draws, Situation& it, const Rate& rate) {
  const std::size_t which = draws.below(3);
  double packet_s = it.format.row_s;
  if (which == 1 && rate.hz < 400) packet_s = it.format.row_s / 5;
  if (which == 1 && rate.hz > 400) packet_s = it.format.row_s * 5;
  const double transport_s = draws.chance(0.5) ? rounded(draws.uniform(0, 0.01), 2) : 0;
  it.stated_delay_s = std::min(packet_s, it.format.row_s) / 2 + transport_s;
  const double slow = draws.uniform(0, 0.4);
  for (int k = 0; k < rate.runs; ++k) {
    const double speed = std::min(1.0, slow + 0.6 * k / (rate.runs - 1));
    Commands commands = draw_motion(draws, it.stated.robot, rate.run_s, packet_s, speed);
    commands.delay_s = transport_s;
    it.runs.push_back(commands);
  }
}

double rms(const std::vector<double>& values) {
  double sum = 0;
  for (const double x : values) sum += x * x;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

Usage usage_of(const Record& record, std::size_t joint) {
  const auto peak = [](const std::vector<double>& all) {
    double most = 0;
    for (const double x : all) most = std::max(most, std::abs(x));
    return most;
  };
  const auto& q = record.position_rad[joint];
  const auto [low, high] = std::minmax_element(q.begin(), q.end());
  return {rms(record.torque_Nm[joint]),
          peak(record.torque_Nm[joint]),
          rms(record.speed_rad_s[joint]),
          peak(record.speed_rad_s[joint]),
          *low,
          *high};
}

/// The fastest run as stated says what the joints do; limits are drawn against it.
void draw_limits(Draws& draws, Situation& it) {
  const Record record = play(it.stated, it.runs.back(), 0.01);
  const auto names = it.stated.robot.moved();
  const double share = draws.chance(0.2) ? 0.85 : draws.uniform(1.3, 3);
  std::map<std::string, double> peaks;
  for (std::size_t j = 0; j < names.size(); ++j) {
    it.usage[names[j]] = usage_of(record, j);
    double& peak = peaks[first_alike(it.stated.robot, names[j])];
    peak = std::max(peak, it.usage[names[j]].peak_Nm);
  }
  for (const std::string& name : names)
    it.stated.controllers[name].torque_limit_Nm =
        rounded(share * peaks[first_alike(it.stated.robot, name)], 3);
}

/// Strong enough for the loop's limit at any speed that occurs.
void draw_drives(Draws& draws, Situation& it) {
  double top_speed = 0;
  for (const auto& [name, usage] : it.usage) top_speed = std::max(top_speed, usage.top_speed_rad_s);
  for (const std::string& name : it.stated.robot.moved()) {
    const std::string first = first_alike(it.stated.robot, name);
    if (first != name) {
      it.drives[name] = it.drives.at(first);
      continue;
    }
    Drive drive;
    drive.ratio = draws.one_of(std::vector<double>{6, 6.33, 9, 10});
    const double limit = it.stated.controllers.at(name).torque_limit_Nm;
    drive.torque_constant_Nm_A = rounded(1.2 * limit / (30 * drive.ratio));
    drive.resistance_ohm = rounded(draws.log_uniform(0.1, 0.5));
    drive.bus_voltage_V =
        std::ceil(2 * (30 * drive.resistance_ohm +
                       drive.torque_constant_Nm_A * drive.ratio * (2 * top_speed + 5)));
    it.drives[name] = drive;
  }
}

Wanted wanted_by(const std::string& kind) {
  return {.floats = kind == "gantry", .alike = kind == "alike"};
}

/// A loop of a servo whose gain nobody published.
void perhaps_servo(Draws& draws, Situation& it) {
  const bool arm = !it.stated.robot.floats;
  if (!arm || it.kind == "two" || !draws.chance(0.3)) return;
  it.servo = true;
  it.servo_guess = draws.log_uniform(0.6, 1.7);
}

}  // namespace

double Format::floor_rad() const {
  return std::sqrt(encoder_step_rad * encoder_step_rad / 12 + noise_rad * noise_rad);
}

std::vector<double> differences_rad(const Scene& one, const Scene& other,
                                    const Commands& commands) {
  const Record a = play(one, commands, 0.01), b = play(other, commands, 0.01);
  std::vector<double> all;
  for (std::size_t j = 0; j < a.position_rad.size(); ++j) {
    std::vector<double> apart;
    for (std::size_t k = 0; k < a.time_s.size(); ++k)
      apart.push_back(a.position_rad[j][k] - b.position_rad[j][k]);
    all.push_back(rms(apart));
  }
  return all;
}

Situation draw_situation(const std::string& kind, std::uint64_t seed,
                         const std::filesystem::path& data, const std::string& only) {
  const auto kinds = class_names();
  if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end())
    throw std::invalid_argument("no such class: " + kind);
  const auto effects = effect_names();
  if (!only.empty() && std::find(effects.begin(), effects.end(), only) == effects.end())
    throw std::invalid_argument("no such effect: " + only);
  Draws draws(seed * 1000003 + static_cast<std::uint64_t>(
                                   std::find(kinds.begin(), kinds.end(), kind) - kinds.begin()));
  Situation it;
  it.kind = kind;
  it.only = only;
  it.stated.robot = draw_robot(draws, wanted_by(kind), data);
  for (const std::string& name : it.stated.robot.moved()) it.stated.laws[name] = Laws{};
  auto heavy = weights(it.stated, draws);
  even_out(it.stated.robot, heavy, &Weight::inertia_kg_m2);
  even_out(it.stated.robot, heavy, &Weight::gravity_Nm);
  draw_own_values(draws, it.stated, heavy);
  draw_loops(draws, it.stated, heavy);
  Rate rate{};
  draw_format(draws, it, rate);
  draw_runs(draws, it, rate);
  draw_limits(draws, it);
  perhaps_servo(draws, it);
  if (!it.servo && draws.chance(0.4)) draw_drives(draws, it);
  it.uses_patterns = draws.chance(0.5);
  if (draws.chance(0.4)) it.uncertain.emplace_back("/controller/delay_s");
  it.truth = it.stated;
  if (it.stated.robot.floats && draws.chance(0.3)) {
    it.truth.roll_rad = draws.uniform(-0.04, 0.04);
    it.truth.pitch_rad = draws.uniform(-0.04, 0.04);
    it.uncertain.insert(it.uncertain.end(), {"/load/roll_rad", "/load/pitch_rad"});
  }
  draw_missing(draws, it);
  return it;
}

}  // namespace torquewright::oracles::robot_bench
