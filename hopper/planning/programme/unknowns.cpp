// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/programme/unknowns.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dynamics/gravity.hpp"
#include "hopper/planning/model/bounds.hpp"
#include "hopper/planning/model/typical_sizes.hpp"
#include "hopper/planning/plane/planned_instant.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using optimization::Bounds;
using optimization::VariableSet;

constexpr double kImpulseGuess_N_s = 5.0;
// Wide enough for any such robot, tight enough to keep the search from running away (trial: loose
// bounds did not converge).
constexpr double kFarthest_m = 3.0;
constexpr double kHighest_m = 3.0;
constexpr double kFastest_m_s = 10.0;
constexpr double kFastest_rad_s = 30.0;
constexpr double kHardest_m_s2 = 500.0;
constexpr double kHardest_rad_s2 = 3000.0;
constexpr double kGreatestForce_N = 1e4;
constexpr double kGreatestImpulse_N_s = 500.0;

class Unknowns {
 public:
  Unknowns(const PlanModel& model, const PlanGoal& goal, const PlannedMotion& guess,
           FlipProgram& out)
      : model_(model),
        goal_(goal),
        guess_(guess),
        out_(out),
        joints_(model.plane.moving_count() - 3),
        drives_(static_cast<Index>(model.plane.drive_count())) {}

  void add_all() {
    for (std::size_t phase = 0; phase < out_.mesh.size(); ++phase) add_phase(phase);
  }

 private:
  const Stance& stance(std::size_t phase) const { return out_.mesh[phase].stance; }

  PlannedInstant guessed(std::size_t phase, std::size_t point) const {
    return instant_at(guess_.phases[phase], out_.mesh[phase].share_at(point));
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

  /// Of the foot in a phase: turned once it has flown.
  double turned_rad(std::size_t phase) const {
    for (std::size_t p = 0; p < phase; ++p) {
      if (stance(p).is_flight()) return goal_.turn_rad;
    }
    return 0.0;
  }

  double flights(std::size_t phase) const {
    return static_cast<double>(flights_before(out_.mesh, phase));
  }

  /// How far strides after the first take the foot.
  double further_m() const {
    return std::abs(goal_.stride_m.value_or(0.0)) * (flights(out_.mesh.size()) - 1.0);
  }

  /// Height of the ground after a flight; of another phase, where it stands.
  double lands_at_m(std::size_t phase) const {
    return ground_m(goal_, out_.mesh, std::min(phase + 1, out_.mesh.size() - 1));
  }

  /// Whether a phase after a flight holds the rearmost point, which goes on before the end: there
  /// the foot is where the flights before have brought it.
  bool is_held_between(std::size_t phase) const {
    if (flights_before(out_.mesh, phase) == 0 || stance(phase - 1).holds_place()) return false;
    for (std::size_t p = phase; p < out_.mesh.size(); ++p) {
      if (!stance(p).holds_place()) return p > phase;
    }
    return false;
  }

  int add_positions(std::size_t phase, std::size_t point, bool at_rest,
                    const PlannedInstant& guess) {
    const bool is_last = point + 1 == out_.mesh[phase].points();
    VariableSet set{"position", moving_of(guess.position), {}, {}};
    const double ground = ground_m(goal_, out_.mesh, phase);
    const double lowest_m = std::min(ground, lands_at_m(phase));
    set.bounds = {within(kFarthest_m + further_m()),
                  {lowest_m, kHighest_m + std::max(ground, lands_at_m(phase))},
                  within(4.0 * std::numbers::pi)};
    // The last instant of a phase is the first of the next as well.
    const bool lands = is_last && phase + 1 < out_.mesh.size() &&
                       stance(phase + 1).frame() == stance(phase).frame();
    if (stance(phase).holds_place() || (lands && stance(phase + 1).holds_place())) {
      set.bounds[1] = equal_to(ground);
    }
    if (stance(phase).holds_pitch() || (lands && stance(phase + 1).holds_pitch())) {
      set.bounds[2] = equal_to(turned_rad(lands ? phase + 1 : phase));
    }
    // Where it begins is the origin of x: the foot's own.
    const double origin_m = model_.plane.sole.front().point.p_B_m.x();
    if (phase == 0) set.bounds[0] = equal_to(origin_m);
    if (phase > 0 && at_rest && goal_.stride_m)
      set.bounds[0] = equal_to(origin_m + *goal_.stride_m * flights(phase));
    const std::size_t held = lands && !stance(phase).holds_place() ? phase + 1 : phase;
    if (goal_.stride_m && is_held_between(held))
      set.bounds[0] = equal_to(origin_m + *goal_.stride_m * flights(held));
    set.scales = {typical::kLength_m, typical::kLength_m, typical::kAngle_rad};
    for (Index j = 0; j < joints_; ++j) {
      const auto joint = static_cast<std::size_t>(j);
      const Bounds& reach =
          stance(phase).is_flight() ? model_.flight_rad[joint] : model_.joint_rad[joint];
      set.bounds.push_back(at_rest ? goal_.standing_rad[joint] : reach);
      set.scales.push_back(typical::kAngle_rad);
    }
    return add(std::move(set));
  }

  /// Rates of what a stance holds.
  void hold(const Stance& on, VariableSet& set) const {
    if (on.holds_place()) set.bounds[0] = set.bounds[1] = equal_to(0.0);
    if (on.holds_pitch()) set.bounds[2] = equal_to(0.0);
  }

  int add_velocities(const Stance& on, const PlannedInstant& guess, bool at_rest,
                     bool takes_off = false) {
    VariableSet set{"velocity", moving_of(guess.velocity), {}, {}};
    set.bounds = {within(kFastest_m_s), within(kFastest_m_s), within(kFastest_rad_s)};
    for (Index j = 0; j < joints_; ++j) {
      set.bounds.push_back(within(model_.joint_rad_s[static_cast<std::size_t>(j)]));
    }
    hold(on, set);
    if (at_rest) set.bounds.assign(set.values.size(), equal_to(0.0));
    if (takes_off && goal_.rise_m) {
      const double gravity_m_s2 = model_.plane.robot.tree.gravity_m_s2;
      set.bounds[1].lower = std::sqrt(2.0 * gravity_m_s2 * *goal_.rise_m);
    }
    set.scales.assign(set.values.size(), typical::kSpeed);
    return add(std::move(set));
  }

  int add_accelerations(const Stance& on, const PlannedInstant& guess, bool at_rest) {
    VariableSet set{"acceleration", moving_of(guess.acceleration), {}, {}};
    set.bounds = {within(kHardest_m_s2), within(kHardest_m_s2)};
    set.bounds.resize(set.values.size(), within(kHardest_rad_s2));
    hold(on, set);
    if (on.is_flight()) {
      set.bounds[0] = equal_to(0.0);
      set.bounds[1] = equal_to(-model_.plane.robot.tree.gravity_m_s2);
    }
    if (at_rest) set.bounds.assign(set.values.size(), equal_to(0.0));
    set.scales.assign(set.values.size(), typical::kAcceleration);
    return add(std::move(set));
  }

  int add_drive_torques(const PlannedInstant& guess) {
    VariableSet set{"drives", {}, {}, {}};
    for (Index i = 0; i < drives_; ++i) {
      set.values.push_back(guess.drive_Nm[i]);
      set.bounds.push_back(
          within((*model_.regions)[static_cast<std::size_t>(i)].greatest_torque_Nm()));
      set.scales.push_back(typical::kTorque_Nm);
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
    set.scales.assign(set.values.size(), typical::kForce_N);
    return add(std::move(set));
  }

  int add_bus(const PlannedInstant& guess) {
    VariableSet set{"bus", {}, {}, {}};
    for (const PlanSupply& supply : *model_.supplies) {
      if (!(supply.resistance_ohm > 0.0)) continue;
      set.values.push_back(guess.bus_V > 0.0 ? guess.bus_V : supply.open_V);
      set.bounds.push_back({0.55 * supply.open_V, 1.3 * supply.open_V});
      set.scales.push_back(typical::kVoltage * supply.open_V);
    }
    return set.values.empty() ? 0 : add(std::move(set));
  }

  int add_impulses(std::size_t phase) {
    VariableSet set{"impulses", impulses_of_guess(phase), {}, {}};
    set.bounds.assign(set.values.size(), {0.0, kGreatestImpulse_N_s});
    set.bounds.front() = within(kGreatestImpulse_N_s);
    set.scales.assign(set.values.size(), typical::kImpulse_N_s);
    return add(std::move(set));
  }

  void add_phase(std::size_t phase) {
    const MeshPhase& mesh = out_.mesh[phase];
    PhaseVariables variables;
    const double guess_s = guess_.phases[phase].end_s() - guess_.phases[phase].begin_s();
    variables.duration = add({"duration", {guess_s}, {mesh.duration_s}, {typical::kDuration_s}});
    variables.has_impact = phase > 0 && mesh.stance.adds_to(stance(phase - 1));
    const std::size_t points = mesh.points();
    for (std::size_t i = 0; i < points; ++i) {
      const PlannedInstant guess = guessed(phase, i);
      PointVariables point;
      const bool joins = phase > 0 && i == 0;
      const bool at_rest =
          (phase == 0 && i == 0) || (phase + 1 == out_.mesh.size() && i + 1 == points);
      const bool shares = joins && stance(phase - 1).frame() == mesh.stance.frame();
      const PointVariables* before = joins ? &out_.phases.back().points.back() : nullptr;
      point.position = shares ? before->position : add_positions(phase, i, at_rest, guess);
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
    if (variables.has_impact) variables.impulses = add_impulses(phase);
    out_.phases.push_back(std::move(variables));
  }

  const PlanModel& model_;
  const PlanGoal& goal_;
  const PlannedMotion& guess_;
  FlipProgram& out_;
  Index joints_, drives_;
};

}  // namespace

void add_unknowns(const PlanModel& model, const PlanGoal& goal, const PlannedMotion& guess,
                  FlipProgram& program) {
  Unknowns(model, goal, guess, program).add_all();
}

}  // namespace torquewright::hopper
