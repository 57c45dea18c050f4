// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/robot_bench/missing.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>

namespace torquewright::oracles::robot_bench {
namespace {

using mujoco_bench::Draws;

constexpr double kPiece_s = 5;
constexpr int kTries = 30, kHalvings = 7;
/// A change beyond this is no error of a model but another robot.
constexpr double kMostChange_rad = 0.25;

/// A way to put something on at a scale from 0 to 1.
using Maker = std::function<Scene(double scale)>;

struct Sized {
  double scale = 0, floors = 0;
};

std::vector<double> changes(const Situation& it, const Scene& changed) {
  return differences_rad(changed, it.truth, sizing_piece(it));
}

double greatest_floors(const Situation& it, const Maker& make, double scale) {
  const auto all = changes(it, make(scale));
  const double most = *std::max_element(all.begin(), all.end());
  return std::isfinite(most) ? most / it.format.floor_rad() : 1e9;
}

/// Bisection in the logarithm; what can not reach a third of the target is given up.
Sized find_size(const Situation& it, const Maker& make, double target_floors) {
  double low = 1e-4, high = 1;
  const double most = greatest_floors(it, make, high);
  if (most < target_floors)
    return most < std::max(kLeastFloors, target_floors / 3) ? Sized{} : Sized{1, most};
  Sized best{1, most};
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = std::sqrt(low * high);
    const double floors = greatest_floors(it, make, middle);
    if (std::abs(std::log(floors / target_floors)) <
        std::abs(std::log(best.floors / target_floors)))
      best = {middle, floors};
    (floors < target_floors ? low : high) = middle;
  }
  const bool fits = best.floors >= kLeastFloors && best.floors <= 1.5 * kMostFloors &&
                    best.floors * it.format.floor_rad() < kMostChange_rad;
  return fits ? best : Sized{};
}

double draw_target(Draws& draws) {
  return draws.log_uniform(1.3 * kLeastFloors, 0.8 * kMostFloors);
}

Scene with_effect(const Scene& scene, const Effect& effect) {
  Scene changed = scene;
  for (const std::string& joint : effect.joints)
    put_on(changed.laws.at(joint), effect.name, effect.parameters);
  return changed;
}

/// With a servo's unknown gain a factor on the torque says nothing; delays are for the loop.
std::vector<std::string> names_for(const Situation& it) {
  if (!it.only.empty()) return {it.only};
  std::vector<std::string> names;
  for (const std::string& name : effect_names()) {
    const bool scales = name == "torque_constant_error";
    if (!(it.servo && scales)) names.push_back(name);
  }
  return names;
}

/// Of dry and viscous laws at one joint only the sum is there.
bool is_drag(const std::string& name) {
  return name == "coulomb_friction" || name == "viscous_friction" ||
         name == "asymmetric_friction" || name == "stribeck_friction";
}

bool add_effect(Draws& draws, Situation& it, const std::vector<std::string>& joints) {
  const std::string name = draws.one_of(names_for(it));
  const Flavour flavour = draw_flavour(draws);
  const double target = draw_target(draws);
  for (const Effect& one : it.missing)
    if (one.name == name || (one.joints == joints && is_drag(one.name) && is_drag(name)))
      return false;
  const Laws& stated = it.stated.laws.at(joints.front());
  if (it.truth.laws.at(joints.front()).is_elastic()) return false;
  const auto effect = [&](double scale) {
    return Effect{name, joints,
                  parameters_of(name, scale, flavour, it.usage.at(joints.front()), stated)};
  };
  const Sized sized = find_size(
      it, [&](double scale) { return with_effect(it.truth, effect(scale)); }, target);
  if (sized.scale == 0) return false;
  it.missing.push_back(effect(sized.scale));
  it.size_floors.push_back(sized.floors);
  it.truth = with_effect(it.truth, it.missing.back());
  // A delay belongs to the controller: a log can tell it only where it may be corrected.
  if (name == "command_delay") it.uncertain.insert(it.uncertain.begin(), "/controller/delay_s");
  return true;
}

void until_done(const std::function<bool()>& attempt) {
  for (int k = 0; k < kTries; ++k)
    if (attempt()) return;
  throw std::runtime_error("nothing of that class shows in this robot's motion");
}

std::vector<std::string> one_joint(Draws& draws, const Situation& it) {
  return {draws.one_of(it.stated.robot.moved())};
}

/// Alike joints that move.
std::vector<std::string> one_group(Draws& draws, const Situation& it) {
  return draws.one_of(it.stated.robot.alike);
}

Eigen::Vector3d direction(Draws& draws) {
  return Eigen::Vector3d(draws.normal(), draws.normal(), draws.normal()).normalized();
}

Json json_of(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

/// The document's body is not the robot's.
bool add_load_error(Draws& draws, Situation& it) {
  const std::string joint = one_joint(draws, it).front();
  const std::string body = it.stated.robot.joint(joint).child;
  const std::string kind = draws.one_of(std::vector<std::string>{"mass", "centre", "payload"});
  const double sign = draws.sign(), target = draw_target(draws);
  const Eigen::Vector3d way = direction(draws);
  const Body stated = it.stated.robot.body(body);
  const Eigen::Vector3d at = stated.center_m + 0.05 * direction(draws);
  const auto change = [&](double scale) {
    Scene changed = it.truth;
    Body& real = changed.robot.body(body);
    const double factor = 1 + (sign > 0 ? 1.0 : 0.6) * sign * scale;
    if (kind == "mass") {
      real.mass_kg *= factor;
      real.inertia_kg_m2 *= factor;
    } else if (kind == "centre") {
      real.center_m += 0.1 * scale * way;
    } else {
      real.add(stated.mass_kg * 1.5 * scale, at, Eigen::Matrix3d::Zero());
    }
    return changed;
  };
  const Sized sized = find_size(it, change, target);
  if (sized.scale == 0) return false;
  it.truth = change(sized.scale);
  const Body& real = it.truth.robot.body(body);
  it.load = {{"kind", kind},
             {"body", body},
             {"joint", joint},
             {"mass_change_kg", real.mass_kg - stated.mass_kg},
             {"centre_shift_m", json_of(real.center_m - stated.center_m)},
             {"moment_change_kg_m",
              json_of(real.mass_kg * real.center_m - stated.mass_kg * stated.center_m)}};
  it.size_floors.push_back(sized.floors);
  return true;
}

void place(double* to, const Eigen::Vector3d& from) {
  for (int k = 0; k < 3; ++k) to[k] = from(k);
}

/// From two bodies up the chain (or the base) to a body.
bool add_cable(Draws& draws, Situation& it) {
  const std::string joint = one_joint(draws, it).front();
  const Robot& robot = it.stated.robot;
  const Joint* carrier = robot.carrier(robot.joint(joint).parent);
  if (carrier == nullptr || robot.is_held(carrier->name)) return false;
  Cable cable;
  cable.from = carrier->parent;
  cable.to = robot.joint(joint).child;
  place(cable.from_m, 0.12 * direction(draws));
  place(cable.to_m, robot.body(cable.to).center_m + 0.03 * direction(draws));
  const bool elastic = draws.chance(0.5);
  const double target = draw_target(draws);
  const double free_m = elastic ? draws.uniform(0.1, 0.3) : 0;
  const double weight_N = 20 * robot.body(cable.to).mass_kg + 2;
  const auto hang = [&](double scale) {
    Scene changed = it.truth;
    changed.cable = cable;
    changed.cable.free_m = free_m;
    if (elastic)
      changed.cable.stiffness_N_m = 20 * weight_N * scale;
    else
      changed.cable.tension_N = weight_N * scale;
    return changed;
  };
  const Sized sized = find_size(it, hang, target);
  if (sized.scale == 0) return false;
  it.truth = hang(sized.scale);
  it.outside = {{"kind", "cable"},
                {"joints", {carrier->name, joint}},
                {"from", cable.from},
                {"to", cable.to},
                {"tension_N", it.truth.cable.tension_N},
                {"stiffness_N_m", it.truth.cable.stiffness_N_m},
                {"free_m", free_m}};
  it.size_floors.push_back(sized.floors);
  return true;
}

/// The encoder sits before a belt that slips where the torque is great.
bool add_belt(Draws& draws, Situation& it) {
  const std::string joint = one_joint(draws, it).front();
  const double target = draw_target(draws);
  const Laws& stated = it.stated.laws.at(joint);
  const double rate = 2 * std::numbers::pi * 250;
  const auto fit = [&](double scale) {
    Scene changed = it.truth;
    Laws& laws = changed.laws.at(joint);
    laws.stiffness_Nm_rad = stated.armature_kg_m2 * rate * rate;
    laws.twist_damping_Nm_s_rad = 0.3 * stated.armature_kg_m2 * rate;
    laws.slip_torque_Nm = it.usage.at(joint).peak_Nm * (1.05 - 0.9 * scale);
    return changed;
  };
  const Sized sized = find_size(it, fit, target);
  if (sized.scale == 0) return false;
  it.truth = fit(sized.scale);
  it.outside = {{"kind", "belt"},
                {"joints", {joint}},
                {"slip_torque_Nm", it.truth.laws.at(joint).slip_torque_Nm}};
  it.size_floors.push_back(sized.floors);
  return true;
}

bool add_gantry(Draws& draws, Situation& it) {
  const double target = draw_target(draws), above = draws.uniform(0.1, 0.5);
  const double damping = draws.uniform(0.03, 0.15);
  const auto hang = [&](double scale) {
    Scene changed = it.truth;
    changed.gantry = {above, 8 * std::pow(0.05, scale), damping};
    return changed;
  };
  const Sized sized = find_size(it, hang, target);
  if (sized.scale == 0) return false;
  it.truth = hang(sized.scale);
  it.outside = {{"kind", "gantry"},
                {"joints", Json::array()},
                {"frequency_hz", it.truth.gantry.frequency_hz},
                {"damping_ratio", damping},
                {"above_m", above}};
  it.size_floors.push_back(sized.floors);
  return true;
}

/// Readings of all joints, one after the other.
Eigen::VectorXd readings(const Scene& scene, const Commands& commands) {
  const Record record = play(scene, commands, 0.02);
  const auto rows = static_cast<Eigen::Index>(record.time_s.size());
  Eigen::VectorXd all(rows * static_cast<Eigen::Index>(record.position_rad.size()));
  for (std::size_t j = 0; j < record.position_rad.size(); ++j)
    all.segment(static_cast<Eigen::Index>(j) * rows, rows) =
        Eigen::Map<const Eigen::VectorXd>(record.position_rad[j].data(), rows);
  return all;
}

/// The usual numbers of one joint, each a little more than stated; not those of what is missing.
std::vector<Scene> neighbours(const Situation& it, const std::string& joint) {
  const Usage& usage = it.usage.at(joint);
  const auto own = [&](const char* name) {
    return std::any_of(it.missing.begin(), it.missing.end(),
                       [&](const Effect& one) { return one.name == name; });
  };
  std::vector<Scene> all;
  const auto vary = [&](const char* name, const std::function<void(Laws&)>& change) {
    if (own(name)) return;
    all.push_back(it.stated);
    change(all.back().laws.at(joint));
  };
  const double small = 0.02 * usage.torque_Nm;
  vary("reflected_inertia", [](Laws& laws) { laws.armature_kg_m2 *= 1.05; });
  vary("coulomb_friction", [&](Laws& laws) {
    for (double& level : laws.coulomb_Nm) level += small;
  });
  vary("viscous_friction", [&](Laws& laws) {
    for (double& slope : laws.viscous_Nm_s_rad) slope += small / usage.speed_rad_s;
  });
  vary("torque_constant_error", [](Laws& laws) { laws.torque_factor *= 1.02; });
  for (const double away : {0.0, 100.0})  // a spring, and nearly a constant torque
    vary("parallel_spring", [&](Laws& laws) {
      laws.spring_Nm_rad = small / usage.swing_rad() / (1 + away);
      laws.spring_neutral_rad = usage.low_rad - usage.swing_rad() * away;
    });
  vary("command_delay", [](Laws& laws) { laws.command_delay_s += 1e-3; });
  if (it.load.empty()) {
    all.push_back(it.stated);
    all.back().robot.body(it.stated.robot.joint(joint).child).mass_kg *= 1.02;
  }
  return all;
}

}  // namespace

std::vector<std::string> class_names() {
  return {"none", "one", "alike", "two", "load", "outside", "gantry"};
}

Commands sizing_piece(const Situation& it) {
  Commands piece = it.runs.back();
  for (auto& targets : piece.targets_rad)
    targets.resize(
        std::min(targets.size(), static_cast<std::size_t>(std::lround(kPiece_s / piece.packet_s))));
  return piece;
}

double distinct_floors(const Situation& it) {
  const Commands piece = sizing_piece(it);
  Scene stated = it.stated;
  stated.roll_rad = it.truth.roll_rad;
  stated.pitch_rad = it.truth.pitch_rad;
  const Eigen::VectorXd base = readings(stated, piece);
  const Eigen::VectorXd change = readings(it.truth, piece) - base;
  std::vector<Scene> around;
  for (const Effect& effect : it.missing)
    for (Scene& scene : neighbours(it, effect.joints.front())) around.push_back(scene);
  if (!it.load.empty()) around = neighbours(it, it.load.at("joint").get<std::string>());
  if (around.empty()) return 0;
  Eigen::MatrixXd columns(base.size(), static_cast<Eigen::Index>(around.size()));
  for (std::size_t k = 0; k < around.size(); ++k) {
    around[k].roll_rad = stated.roll_rad;
    around[k].pitch_rad = stated.pitch_rad;
    columns.col(static_cast<Eigen::Index>(k)) = readings(around[k], piece) - base;
  }
  const Eigen::VectorXd left = change - columns * columns.colPivHouseholderQr().solve(change);
  // The joint that changes most has most of what is left as well.
  const auto joints = static_cast<Eigen::Index>(it.stated.robot.moved().size());
  const Eigen::Index rows = base.size() / joints;
  double most = 0;
  for (Eigen::Index j = 0; j < joints; ++j)
    most = std::max(most, left.segment(j * rows, rows).norm() / std::sqrt(rows));
  return most / it.format.floor_rad();
}

void draw_missing(Draws& draws, Situation& it) {
  const Scene before = it.truth;
  if (it.kind == "one") until_done([&] { return add_effect(draws, it, one_joint(draws, it)); });
  if (it.kind == "alike") until_done([&] { return add_effect(draws, it, one_group(draws, it)); });
  if (it.kind == "two")
    for (int k = 0; k < 2; ++k)
      until_done([&] { return add_effect(draws, it, one_joint(draws, it)); });
  if (it.kind == "load") until_done([&] { return add_load_error(draws, it); });
  if (it.kind == "gantry") until_done([&] { return add_gantry(draws, it); });
  if (it.kind == "outside")
    until_done([&] { return draws.chance(0.6) ? add_cable(draws, it) : add_belt(draws, it); });
  const auto all = differences_rad(it.truth, before, sizing_piece(it));
  const auto names = it.stated.robot.moved();
  for (std::size_t j = 0; j < names.size(); ++j)
    it.floors_by_joint[names[j]] = all[j] / it.format.floor_rad();
}

}  // namespace torquewright::oracles::robot_bench
