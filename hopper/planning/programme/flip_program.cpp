// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/programme/flip_program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dynamics/gravity.hpp"
#include "hopper/planning/objectives/library.hpp"
#include "hopper/planning/plane/jet_rows.hpp"
#include "hopper/planning/plane/planned_instant.hpp"
#include "hopper/planning/plane/variable_numbers.hpp"
#include "hopper/planning/programme/hermite_simpson.hpp"
#include "hopper/planning/programme/landing_load.hpp"
#include "hopper/planning/programme/smoothness.hpp"
#include "hopper/planning/programme/standing.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using optimization::Bounds;
using optimization::VariableSet;

constexpr double kInfinite = std::numeric_limits<double>::infinity();
// Typical sizes, by which the solver's numbers come near 1.
constexpr double kLength_m = 0.5;
constexpr double kAngle_rad = 1.0;
constexpr double kSpeed = 5.0;
constexpr double kAcceleration = 100.0;
constexpr double kTorque_Nm = 100.0;
constexpr double kForce_N = 100.0;
constexpr double kImpulse_N_s = 10.0;
constexpr double kImpulseGuess_N_s = 5.0;
constexpr double kDuration_s = 0.3;
// Wide enough for any such robot, tight enough to keep the search from running away (trial: loose
// bounds did not converge).
constexpr double kFarthest_m = 3.0;
constexpr double kHighest_m = 3.0;
constexpr double kFastest_m_s = 10.0;
constexpr double kFastest_rad_s = 30.0;
constexpr double kHardest_m_s2 = 500.0;
constexpr double kHardest_rad_s2 = 3000.0;
constexpr double kGreatestForce_N = 1e4;
constexpr double kClear_m = 0.03;  // bodies that must not touch, above the ground
// Part of a phase before the foot tips, over which its load may go to the edge.
constexpr double kTips = 0.3;

Bounds equal(double value) { return {value, value}; }
Bounds at_least(double value) { return {value, kInfinite}; }
Bounds at_most(double value) { return {-kInfinite, value}; }
Bounds within(double value) { return {-value, value}; }

struct ConeLaw {
  std::size_t points;
  double friction;
  double edge;
  template <typename T>
  void operator()(const dynamics::VectorX<T>& x, dynamics::VectorX<T>& rows) const {
    T load = x[1];
    if (points == 2) load += x[2];
    rows[0] = x[0] - friction * load;
    rows[1] = -x[0] - friction * load;
    if (points < 2) return;
    rows[2] = edge * load - x[1];
    rows[3] = edge * load - x[2];
  }
};

/// Puts a plan's unknowns and rows into a program, phase by phase.
class Builder {
 public:
  Builder(const PlanModel& model, const PlanGoal& goal, const PlanOptions& options,
          const PlannedMotion& guess, FlipProgram& out)
      : model_(model),
        goal_(goal),
        options_(options),
        guess_(guess),
        out_(out),
        scratch_(std::make_shared<SagittalScratch>(model.plane)),
        m_(model.plane.moving_count()),
        k_(m_ - 3),
        d_(static_cast<Index>(model.plane.drive_count())) {}

  void build() {
    for (std::size_t phase = 0; phase < out_.mesh.size(); ++phase) add_variables(phase);
    for (std::size_t phase = 0; phase < out_.mesh.size(); ++phase) {
      add_intervals(phase);
      for (std::size_t point = 0; point < out_.phases[phase].points.size(); ++point) {
        add_dynamics(phase, point);
        add_drives(phase, point);
        add_forces(phase, point);
        add_clearance(phase, point);
      }
      add_begin(phase);
    }
    add_level_base(0, out_.phases.front().points.front(), 0.0);
    const std::size_t last = out_.mesh.size() - 1;
    add_level_base(last, out_.phases[last].points.back(), goal_.turn_rad);
    for (std::size_t phase = 0; phase < out_.mesh.size(); ++phase) {
      if (out_.phases[phase].has_impact) {
        add_landing_load(model_, options_.check.load_window_s, phase, out_);
      }
    }
    add_lean();
    for (const WeightedObjective& one : objectives_of(options_)) {
      objective_named(one.name).add(model_, options_, one.weight, out_);
    }
    add_smoothness(model_, out_);
  }

 private:
  const Stance& stance(std::size_t phase) const { return out_.mesh[phase].stance; }
  static std::string place(const Stance& stance, const char* what) {
    return stance.name + ": " + what;
  }

  PlannedInstant guessed(std::size_t phase, std::size_t point) const {
    const std::vector<double>& knots = out_.mesh[phase].knots;
    const std::size_t i = point / 2;
    const double share = point % 2 == 0 ? knots[i] : 0.5 * (knots[i] + knots[i + 1]);
    return instant_at(guess_.phases[phase], share);
  }

  std::vector<double> moving_of(const Eigen::VectorXd& rows) const {
    std::vector<double> out;
    for (const Index row : model_.plane.moving) out.push_back(rows[row]);
    return out;
  }

  int add(VariableSet set) {
    for (std::size_t i = 0; i < set.values.size(); ++i) {
      if (std::isfinite(set.bounds[i].lower)) {
        set.values[i] = std::max(set.values[i], set.bounds[i].lower);
      }
      if (std::isfinite(set.bounds[i].upper)) {
        set.values[i] = std::min(set.values[i], set.bounds[i].upper);
      }
    }
    return out_.program.add(std::move(set));
  }

  /// What a stance holds of the foot: x and z by its rear point, the pitch by both.
  bool holds_place(const Stance& on) const { return !on.points.empty() && on.points.front() == 0; }
  bool holds_pitch(const Stance& on) const { return on.is_flat(); }
  /// Of the foot in a phase: turned once it has flown.
  double turned_rad(std::size_t phase) const {
    for (std::size_t p = 0; p < phase; ++p) {
      if (stance(p).is_flight()) return goal_.turn_rad;
    }
    return 0.0;
  }

  int add_positions(std::size_t phase, bool is_last, bool at_rest, const PlannedInstant& guess) {
    VariableSet set{"position", moving_of(guess.position), {}, {}};
    set.bounds = {within(kFarthest_m), {0.0, kHighest_m}, within(4.0 * std::numbers::pi)};
    // The last instant of a phase is the first of the next as well.
    const bool lands = is_last && phase + 1 < out_.mesh.size() &&
                       stance(phase + 1).frame() == stance(phase).frame();
    if (holds_place(stance(phase)) || (lands && holds_place(stance(phase + 1)))) {
      set.bounds[1] = equal(0.0);
    }
    if (holds_pitch(stance(phase)) || (lands && holds_pitch(stance(phase + 1)))) {
      set.bounds[2] = equal(turned_rad(lands ? phase + 1 : phase));
    }
    // Where it begins is the origin of x: the foot's own.
    const double origin_m = model_.plane.sole.front().point.p_B_m.x();
    if (phase == 0) set.bounds[0] = equal(origin_m);
    if (phase > 0 && at_rest && goal_.stride_m) set.bounds[0] = equal(origin_m + *goal_.stride_m);
    set.scales = {kLength_m, kLength_m, kAngle_rad};
    for (Index j = 0; j < k_; ++j) {
      const auto joint = static_cast<std::size_t>(j);
      set.bounds.push_back(at_rest ? goal_.standing_rad[joint] : model_.joint_rad[joint]);
      set.scales.push_back(kAngle_rad);
    }
    return add(std::move(set));
  }

  /// Rates of what a stance holds.
  void hold(const Stance& on, VariableSet& set) const {
    if (holds_place(on)) set.bounds[0] = set.bounds[1] = equal(0.0);
    if (holds_pitch(on)) set.bounds[2] = equal(0.0);
  }

  int add_velocities(const Stance& on, const PlannedInstant& guess, bool at_rest,
                     bool takes_off = false) {
    VariableSet set{"velocity", moving_of(guess.velocity), {}, {}};
    set.bounds = {within(kFastest_m_s), within(kFastest_m_s), within(kFastest_rad_s)};
    for (Index j = 0; j < k_; ++j) {
      set.bounds.push_back(within(model_.joint_rad_s[static_cast<std::size_t>(j)]));
    }
    hold(on, set);
    if (at_rest) set.bounds.assign(set.values.size(), equal(0.0));
    if (takes_off && goal_.rise_m) {
      const double gravity_m_s2 = model_.plane.robot.tree.gravity_m_s2;
      set.bounds[1].lower = std::sqrt(2.0 * gravity_m_s2 * *goal_.rise_m);
    }
    set.scales.assign(set.values.size(), kSpeed);
    return add(std::move(set));
  }

  int add_accelerations(const Stance& on, const PlannedInstant& guess, bool at_rest) {
    VariableSet set{"acceleration", moving_of(guess.acceleration), {}, {}};
    set.bounds = {within(kHardest_m_s2), within(kHardest_m_s2)};
    set.bounds.resize(set.values.size(), within(kHardest_rad_s2));
    hold(on, set);
    if (on.is_flight()) {
      set.bounds[0] = equal(0.0);
      set.bounds[1] = equal(-model_.plane.robot.tree.gravity_m_s2);
    }
    if (at_rest) set.bounds.assign(set.values.size(), equal(0.0));
    set.scales.assign(set.values.size(), kAcceleration);
    return add(std::move(set));
  }

  int add_drive_torques(const PlannedInstant& guess) {
    VariableSet set{"drives", {}, {}, {}};
    for (Index i = 0; i < d_; ++i) {
      set.values.push_back(guess.drive_Nm[i]);
      set.bounds.push_back(
          within((*model_.regions)[static_cast<std::size_t>(i)].greatest_torque_Nm()));
      set.scales.push_back(kTorque_Nm);
    }
    return add(std::move(set));
  }

  /// By force of the stance, of what contact points give: left and right together.
  std::vector<double> of_sole(const Stance& stance, const Eigen::Matrix3Xd& contacts) const {
    std::vector<double> out(stance.force_count(), 0.0);
    for (std::size_t i = 0; i < stance.points.size(); ++i) {
      for (const std::size_t member : model_.plane.sole[stance.points[i]].members) {
        out[0] += contacts(0, static_cast<Index>(member));
        out[1 + i] += contacts(2, static_cast<Index>(member));
      }
    }
    return out;
  }

  std::vector<double> impulses_of_guess(std::size_t phase) const {
    const Eigen::Matrix3Xd& known = guess_.phases[phase].impulse_N_s;
    if (known.size() > 0) return of_sole(stance(phase), known);
    std::vector<double> out(stance(phase).force_count(), kImpulseGuess_N_s);
    out.front() = 0.0;
    return out;
  }

  /// The guess where the phase before ends, in this phase's frame.
  PlannedInstant last_before(std::size_t phase) const {
    const PlannedPhase& before = guess_.phases[phase - 1];
    PlannedInstant out = before.instants.back();
    const TreeMotion here = frame_motion(
        model_.plane, stance(phase).frame(),
        tree_motion(model_.plane, before.frame(), {out.position, out.velocity, out.acceleration}));
    out.position = here.position;
    out.velocity = here.velocity;
    out.acceleration = here.acceleration;
    return out;
  }

  int add_contact_forces(const Stance& stance, const PlannedInstant& guess) {
    if (stance.is_flight()) return 0;
    VariableSet set{"forces", of_sole(stance, guess.contact_N), {}, {}};
    set.bounds.assign(set.values.size(), {0.0, kGreatestForce_N});
    set.bounds.front() = within(kGreatestForce_N);
    set.scales.assign(set.values.size(), kForce_N);
    return add(std::move(set));
  }

  int add_bus(const PlannedInstant& guess) {
    VariableSet set{"bus", {}, {}, {}};
    for (const PlanSupply& supply : *model_.supplies) {
      if (!(supply.resistance_ohm > 0.0)) continue;
      set.values.push_back(guess.bus_V > 0.0 ? guess.bus_V : supply.open_V);
      set.bounds.push_back({0.55 * supply.open_V, 1.3 * supply.open_V});
      set.scales.push_back(0.1 * supply.open_V);
    }
    return set.values.empty() ? 0 : add(std::move(set));
  }

  void add_variables(std::size_t phase) {
    const MeshPhase& mesh = out_.mesh[phase];
    PhaseVariables variables;
    const double guess_s = guess_.phases[phase].end_s() - guess_.phases[phase].begin_s();
    variables.duration = add({"duration", {guess_s}, {mesh.duration_s}, {kDuration_s}});
    variables.has_impact = phase > 0 && mesh.stance.adds_to(stance(phase - 1));
    const std::size_t points = 2 * mesh.intervals() + 1;
    for (std::size_t i = 0; i < points; ++i) {
      const PlannedInstant guess = guessed(phase, i);
      PointVariables point;
      const bool joins = phase > 0 && i == 0;
      const bool at_rest =
          (phase == 0 && i == 0) || (phase + 1 == out_.mesh.size() && i + 1 == points);
      const bool shares = joins && stance(phase - 1).frame() == mesh.stance.frame();
      const PointVariables* before = joins ? &out_.phases.back().points.back() : nullptr;
      point.position =
          shares ? before->position : add_positions(phase, i + 1 == points, at_rest, guess);
      point.velocity =
          shares && !variables.has_impact
              ? before->velocity
              : add_velocities(mesh.stance, guess, at_rest, joins && mesh.stance.is_flight());
      if (joins && variables.has_impact) {
        variables.velocity_before =
            shares ? before->velocity : add_velocities({"free", {}}, last_before(phase), false);
      }
      point.acceleration = add_accelerations(mesh.stance, guess, at_rest);
      point.drives = add_drive_torques(guess);
      point.forces = add_contact_forces(mesh.stance, guess);
      point.bus = add_bus(guess);
      variables.points.push_back(point);
    }
    if (variables.has_impact) {
      VariableSet set{"impulses", impulses_of_guess(phase), {}, {}};
      set.bounds.assign(set.values.size(), {0.0, 500.0});
      set.bounds.front() = within(500.0);
      set.scales.assign(set.values.size(), kImpulse_N_s);
      variables.impulses = add(std::move(set));
    }
    out_.phases.push_back(std::move(variables));
  }

  void add_intervals(std::size_t phase) {
    const PhaseVariables& variables = out_.phases[phase];
    const std::vector<double>& knots = out_.mesh[phase].knots;
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
      const PointVariables& p0 = variables.points[2 * i];
      const PointVariables& pm = variables.points[2 * i + 1];
      const PointVariables& p1 = variables.points[2 * i + 2];
      const double share = knots[i + 1] - knots[i];
      for (int r = 0; r < m_; ++r) {
        const auto rows = [&](const char* what, int PointVariables::*y, int PointVariables::*rate,
                              double scale) {
          out_.program.add_rows(std::make_unique<HermiteSimpson>(
              place(stance(phase), what),
              std::vector<int>{p0.*y + r, pm.*y + r, p1.*y + r, p0.*rate + r, pm.*rate + r,
                               p1.*rate + r, variables.duration},
              share, scale));
        };
        const bool is_place = r < 2 && holds_place(stance(phase));
        const bool is_pitch = r == 2 && holds_pitch(stance(phase));
        if ((is_place && (r == 1 || phase == 0)) || is_pitch) continue;
        rows("positions go on", &PointVariables::position, &PointVariables::velocity,
             r < 2 ? kLength_m : kAngle_rad);
        // A free fall's acceleration is known, so that the middle row says nothing new.
        if (!is_place)
          rows("velocities go on", &PointVariables::velocity, &PointVariables::acceleration,
               kSpeed);
      }
    }
  }

  std::vector<int> posture(const PointVariables& point) const {
    return numbers_from(point.position + 2, m_ - 2);
  }
  std::vector<int> posture_rates(const PointVariables& point) const {
    return numbers_from(point.velocity + 2, m_ - 2);
  }

  void add_dynamics(std::size_t phase, std::size_t index) {
    const PointVariables& point = out_.phases[phase].points[index];
    const Stance& on = stance(phase);
    const auto forces = static_cast<Index>(on.force_count());
    const auto rows = static_cast<std::size_t>(m_) + model_.plane.held.size();
    std::vector<Bounds> bounds(rows, equal(0.0));
    // In flight the frame's acceleration is gravity's already.
    if (on.is_flight()) bounds[0] = bounds[1] = {};
    out_.program.add_rows(jet_rows(
        place(on, "equations of motion"),
        in_order({posture(point), posture_rates(point), numbers_from(point.acceleration, m_),
                  numbers_from(point.drives, d_), numbers_from(point.forces, forces)}),
        std::move(bounds), std::vector<double>(rows, kForce_N), DynamicsLaw{scratch_, on}));
    if (on.is_flight() || holds_place(on)) return;
    out_.program.add_rows(jet_rows(
        place(on, "feet stay"),
        in_order({posture(point), posture_rates(point), numbers_from(point.acceleration, m_)}),
        std::vector<Bounds>(on.force_count(), equal(0.0)),
        std::vector<double>(on.force_count(), kAcceleration),
        ContactAccelerationLaw{scratch_, on}));
  }

  Index bus_count() const {
    return std::count_if(model_.supplies->begin(), model_.supplies->end(),
                         [](const PlanSupply& one) { return one.resistance_ohm > 0.0; });
  }

  void add_drives(std::size_t phase, std::size_t index) {
    const PointVariables& point = out_.phases[phase].points[index];
    std::vector<Bounds> bounds;
    std::vector<double> scales;
    for (const DriveRegion& region : *model_.regions) {
      bounds.insert(bounds.end(), region.rows(), at_most(0.0));
    }
    for (const double most_Nm : model_.gear_Nm) bounds.push_back(within(most_Nm));
    for (const double most_Nm : model_.joint_Nm) bounds.push_back(within(most_Nm));
    scales.assign(bounds.size(), kTorque_Nm);
    for (const PlanSupply& supply : *model_.supplies) {
      if (!(supply.resistance_ohm > 0.0)) continue;
      bounds.push_back(equal(0.0));
      scales.push_back(0.1 * supply.open_V);
    }
    out_.program.add_rows(jet_rows(
        place(stance(phase), "drives"),
        in_order({numbers_from(point.position + 3, k_), numbers_from(point.velocity + 3, k_),
                  numbers_from(point.acceleration + 3, k_), numbers_from(point.drives, d_),
                  numbers_from(point.bus, bus_count())}),
        std::move(bounds), std::move(scales),
        DriveLaw{&model_.plane, model_.regions, model_.supplies, model_.rotors_kg_m2}));
  }

  /// Affine rows of forces or impulses: friction, and the load's place on the sole.
  void add_cone(const Stance& on, int forces, const char* what, double scale, double edge_share) {
    double friction = kInfinite;
    for (const std::size_t i : on.points) {
      friction = std::min(friction, model_.plane.sole[i].friction_coefficient);
    }
    friction *= 1.0 - options_.margins.friction;
    const std::size_t rows = on.is_flat() ? 4 : 2;
    out_.program.add_rows(
        jet_rows(place(on, what), numbers_from(forces, static_cast<Index>(on.force_count())),
                 std::vector<Bounds>(rows, at_most(0.0)), std::vector<double>(rows, scale),
                 ConeLaw{on.points.size(), friction, edge_share}));
  }

  /// 1, but over the last part of a phase whose end lets a point go, down to 0 there.
  double from_tipping(std::size_t phase, std::size_t index) const {
    if (phase + 1 == out_.mesh.size() ||
        stance(phase + 1).points.size() >= stance(phase).points.size()) {
      return 1.0;
    }
    const std::vector<double>& knots = out_.mesh[phase].knots;
    const std::size_t i = index / 2;
    const double share = index % 2 == 0 ? knots[i] : 0.5 * (knots[i] + knots[i + 1]);
    return std::min(1.0, (1.0 - share) / kTips);
  }

  void add_forces(std::size_t phase, std::size_t index) {
    const Stance& on = stance(phase);
    if (on.is_flight()) return;
    const bool stands =
        (phase == 0 && index == 0) ||
        (phase + 1 == out_.mesh.size() && index + 1 == out_.phases[phase].points.size());
    // Where it stands the load is near the middle of the sole: each end bears nearly half of it.
    // Where the foot will tip, the load has to go to its edge.
    const double edge = stands ? 0.5 - kStandsWithin
                               : options_.margins.center_of_pressure * from_tipping(phase, index);
    add_cone(on, out_.phases[phase].points[index].forces, "ground", kForce_N, edge);
  }

  void add_clearance(std::size_t phase, std::size_t index) {
    const PhaseVariables& variables = out_.phases[phase];
    const PointVariables& point = variables.points[index];
    PlaceLaw law{scratch_, stance(phase).frame(), {}};
    std::vector<Bounds> bounds;
    const dynamics::Tree& tree = model_.plane.robot.tree;
    if (index % 2 == 0) {
      for (std::size_t body = 0; body < tree.bodies.size(); ++body) {
        if (body == model_.plane.foot || tree.bodies[body].inertia.mass_kg < 0.01) continue;
        const Eigen::Vector3d center_m = tree.bodies[body].inertia.center_of_mass_m;
        law.points.push_back({body, center_m});
        law.points.push_back({body, Eigen::Vector3d::Zero()});
        bounds.insert(bounds.end(), 2, at_least(kClear_m));
      }
    }
    const bool first = index == 0, last = index + 1 == variables.points.size();
    for (std::size_t i = 0; i < model_.plane.sole.size(); ++i) {
      const auto touches = [&](std::size_t of) {
        if (of >= out_.mesh.size()) return false;
        const std::vector<std::size_t>& points = stance(of).points;
        return std::find(points.begin(), points.end(), i) != points.end();
      };
      // A point that was or will be on the ground is there at the phase's end.
      const bool is_variable = i == 0 && stance(phase).frame() == PlanFrame::kSole;
      if (is_variable || touches(phase) || (first && phase > 0 && touches(phase - 1)) ||
          (last && touches(phase + 1))) {
        continue;
      }
      law.points.push_back(model_.plane.sole[i].point);
      bounds.push_back(at_least(0.0));
    }
    if (law.points.empty()) return;
    const std::size_t rows = bounds.size();
    out_.program.add_rows(jet_rows(place(stance(phase), "above the ground"),
                                   numbers_from(point.position, m_), std::move(bounds),
                                   std::vector<double>(rows, kLength_m), std::move(law)));
  }

  void add_level_base(std::size_t phase, const PointVariables& point, double pitch_rad) {
    if (!goal_.has_level_base) return;
    out_.program.add_rows(jet_rows(place(stance(phase), "base upright"), posture(point),
                                   {equal(pitch_rad)}, {kAngle_rad}, BasePitchLaw{&model_.plane}));
  }

  std::vector<dynamics::BodyPoint> points_of(const Stance& on, const Stance* before) const {
    std::vector<dynamics::BodyPoint> out;
    for (const std::size_t i : on.points) {
      const bool is_old =
          before != nullptr &&
          std::find(before->points.begin(), before->points.end(), i) != before->points.end();
      if (!is_old) out.push_back(model_.plane.sole[i].point);
    }
    return out;
  }

  /// Where a phase's frame is another than that of the phase before.
  void add_link(std::size_t phase) {
    if (stance(phase).frame() == stance(phase - 1).frame()) return;
    const PointVariables& before = out_.phases[phase - 1].points.back();
    const PointVariables& after = out_.phases[phase].points.front();
    const bool lands = stance(phase).frame() == PlanFrame::kSole;
    const PointVariables& sole = lands ? after : before;
    const PointVariables& mass = lands ? before : after;
    const int sole_velocity = lands ? out_.phases[phase].velocity_before : sole.velocity;
    std::vector<double> scales(static_cast<std::size_t>(2 * m_), kSpeed);
    std::fill_n(scales.begin(), m_, kLength_m);
    out_.program.add_rows(
        jet_rows(place(stance(phase), "goes on"),
                 in_order({numbers_from(sole.position, m_), numbers_from(sole_velocity, m_),
                           numbers_from(mass.position, m_), numbers_from(mass.velocity, m_)}),
                 std::vector<Bounds>(scales.size(), equal(0.0)), scales, LinkLaw{scratch_}));
  }

  void add_begin(std::size_t phase) {
    const PhaseVariables& variables = out_.phases[phase];
    const PointVariables& point = variables.points.front();
    const Stance& on = stance(phase);
    // What the foot's own variables do not hold already.
    const auto touching = points_of(on, phase == 0 ? nullptr : &stance(phase - 1));
    if (!touching.empty() && !holds_place(on)) {
      out_.program.add_rows(jet_rows(place(on, "feet on the ground"),
                                     numbers_from(point.position, m_),
                                     std::vector<Bounds>(touching.size(), equal(0.0)),
                                     std::vector<double>(touching.size(), kLength_m),
                                     PlaceLaw{scratch_, PlanFrame::kSole, touching}));
    }
    if (phase > 0) add_link(phase);
    if (!variables.has_impact) return;
    const auto forces = static_cast<Index>(on.force_count());
    const auto rows = static_cast<std::size_t>(m_);
    out_.program.add_rows(jet_rows(
        place(on, "impact"),
        in_order({posture(point), numbers_from(variables.velocity_before, m_),
                  numbers_from(point.velocity, m_), numbers_from(variables.impulses, forces)}),
        std::vector<Bounds>(rows, equal(0.0)), std::vector<double>(rows, kImpulse_N_s),
        ImpactLaw{scratch_, on}));
    if (!holds_place(on))
      out_.program.add_rows(jet_rows(
          place(on, "feet stop"), in_order({posture(point), numbers_from(point.velocity, m_)}),
          std::vector<Bounds>(on.force_count(), equal(0.0)),
          std::vector<double>(on.force_count(), kSpeed), ContactVelocityLaw{scratch_, on}));
    add_cone(on, variables.impulses, "impulse", kImpulse_N_s, 0.0);
  }

  /// Where the last stance begins after a landing on an edge, the mass is over the sole already,
  /// as far as the load has to be: else it creeps there over the edge, which no feedback can help
  /// (trial: plans without this fell back in most replays).
  void add_lean() {
    const std::size_t last = out_.mesh.size() - 1;
    if (last == 0 || !stance(last).is_flat() || stance(last - 1).points.size() != 1) return;
    const double length_m = model_.foot_length_m;
    const double within_m = options_.margins.center_of_pressure * length_m;
    out_.program.add_rows(jet_rows(
        place(stance(last), "mass over the sole"), posture(out_.phases[last].points.front()),
        {{within_m, length_m - within_m}}, {kLength_m}, LeanLaw{scratch_}));
  }

  const PlanModel& model_;
  const PlanGoal& goal_;
  const PlanOptions& options_;
  const PlannedMotion& guess_;
  FlipProgram& out_;
  std::shared_ptr<SagittalScratch> scratch_;
  Index m_, k_, d_;
};

}  // namespace

FlipProgram flip_program(const PlanModel& model, const std::vector<MeshPhase>& mesh,
                         const PlanGoal& goal, const PlanOptions& options,
                         const PlannedMotion& guess) {
  FlipProgram out;
  out.mesh = mesh;
  Builder(model, goal, options, guess, out).build();
  return out;
}

PlannedMotion motion_of(const FlipProgram& program, const PlanModel& model,
                        const std::vector<double>& values) {
  const SagittalRobot& plane = model.plane;
  const auto read = [&](int first, Index count) {
    return Eigen::Map<const Eigen::VectorXd>(values.data() + first, count).eval();
  };
  const Index m = plane.moving_count();
  const auto d = static_cast<Index>(plane.drive_count());
  /// What a stance's points give, shared alike by the contact points that are one in the plane.
  const auto on_contacts = [&plane](const Stance& stance, const Eigen::VectorXd& forces) {
    Eigen::Matrix3Xd out =
        Eigen::Matrix3Xd::Zero(3, static_cast<Index>(plane.robot.contacts.size()));
    const double load = forces.size() > 0 ? forces.tail(forces.size() - 1).sum() : 0.0;
    for (std::size_t f = 0; f < stance.points.size(); ++f) {
      const SolePoint& sole = plane.sole[stance.points[f]];
      const double up = forces[1 + static_cast<Index>(f)];
      for (const std::size_t member : sole.members) {
        const double share = 1.0 / static_cast<double>(sole.members.size());
        out(2, static_cast<Index>(member)) = up * share;
        out(0, static_cast<Index>(member)) = load > 0.0 ? forces[0] * up / load * share : 0.0;
      }
    }
    return out;
  };
  PlannedMotion out;
  double begin_s = 0.0;
  for (std::size_t p = 0; p < program.phases.size(); ++p) {
    const MeshPhase& mesh = program.mesh[p];
    const PhaseVariables& variables = program.phases[p];
    const double duration_s = values[static_cast<std::size_t>(variables.duration)];
    PlannedPhase phase{mesh.stance.name, std::vector<bool>(plane.robot.contacts.size(), false), {}};
    for (const std::size_t i : mesh.stance.points) {
      for (const std::size_t member : plane.sole[i].members) phase.touches[member] = true;
    }
    for (std::size_t i = 0; i < variables.points.size(); ++i) {
      const PointVariables& point = variables.points[i];
      const double share =
          i % 2 == 0 ? mesh.knots[i / 2] : 0.5 * (mesh.knots[i / 2] + mesh.knots[i / 2 + 1]);
      PlannedInstant instant;
      instant.time_s = begin_s + share * duration_s;
      instant.position = plane.all_rows(read(point.position, m));
      instant.velocity = plane.all_rows(read(point.velocity, m));
      instant.acceleration = plane.all_rows(read(point.acceleration, m));
      instant.drive_Nm = read(point.drives, d);
      instant.contact_N = on_contacts(
          mesh.stance, read(point.forces, static_cast<Index>(mesh.stance.force_count())));
      if (!model.supplies->empty()) {
        const PlanSupply& supply = model.supplies->front();
        instant.bus_V = supply.resistance_ohm > 0.0 ? values[static_cast<std::size_t>(point.bus)]
                                                    : supply.open_V;
      }
      phase.instants.push_back(std::move(instant));
    }
    phase.is_collocated = true;
    if (variables.has_impact) {
      phase.impulse_N_s = on_contacts(
          mesh.stance, read(variables.impulses, static_cast<Index>(mesh.stance.force_count())));
    }
    begin_s += duration_s;
    out.phases.push_back(std::move(phase));
  }
  return out;
}

}  // namespace torquewright::hopper
