// SPDX-License-Identifier: Apache-2.0
#include "hopper/candidates/candidates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "actuator/drive_check/left_out_sizes.hpp"
#include "actuator/drive_check/region_words.hpp"
#include "actuator/region/joint_region.hpp"
#include "actuator/region/torque_at.hpp"
#include "hopper/check/left_out_rows.hpp"
#include "io/text/time_text.hpp"
#include "simulation/in_parallel.hpp"

namespace torquewright::hopper {
namespace {

using actuator::Verdict;

/// The robot as it is: what stays the same for all candidates.
struct Basis {
  CheckedMotion checked;
  DriveTorques torques;  ///< Those that count.
  CandidateTorques source = CandidateTorques::kDynamics;
  std::optional<Demand> twice_as_far;  ///< For the doubt of the torques.
};

Basis basis_of(const CheckedMotion& checked) {
  const bool exchanges =
      checked.options.torques == TorqueSource::kFile || !checked.demand.has_dynamics;
  return {checked, drive_torques(checked),
          exchanges ? CandidateTorques::kExchangedFile : CandidateTorques::kDynamics,
          exchanges ? std::nullopt : demand_twice_as_far(checked)};
}

/// Of all drives.
std::size_t first_drive(const Robot& robot, std::size_t drivetrain) {
  std::size_t first = 0;
  for (std::size_t i = 0; i < drivetrain; ++i) first += robot.drivetrains[i].actuators.size();
  return first;
}

/// Moves mass at a point of a body: its centre and its inertia about it move too (Steiner).
void add_mass(double mass_kg, const Eigen::Vector3d& place_m, dynamics::RigidInertia& inertia) {
  const auto about = [](double mass, const Eigen::Vector3d& r) -> Eigen::Matrix3d {
    return mass * (r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose());
  };
  const double sum_kg = inertia.mass_kg + mass_kg;
  const Eigen::Vector3d center_m =
      (inertia.mass_kg * inertia.center_of_mass_m + mass_kg * place_m) / sum_kg;
  inertia.inertia_kg_m2 += about(inertia.mass_kg, inertia.center_of_mass_m - center_m) +
                           about(mass_kg, place_m - center_m);
  inertia.center_of_mass_m = center_m;
  inertia.mass_kg = sum_kg;
}

/// What the candidate weighs more than the actuators it replaces; 0 where it is not known, or not
/// where.
double heavier_kg(const Drivetrain& drivetrain, const Candidate& candidate) {
  if (!drivetrain.mount || !candidate.actuator.mass_kg) return 0.0;
  double sum_kg = 0.0;
  for (const actuator::Actuator& actuator : drivetrain.actuators) {
    if (!actuator.mass_kg) return 0.0;
    sum_kg += *candidate.actuator.mass_kg - *actuator.mass_kg;
  }
  return sum_kg;
}

Robot with(const Robot& robot, std::size_t drivetrain, const Candidate& candidate) {
  Robot changed = robot;
  Drivetrain& drive = changed.drivetrains[drivetrain];
  const double more_kg = heavier_kg(drive, candidate);
  if (more_kg != 0.0) {
    add_mass(more_kg, drive.mount->p_B_m, changed.tree.bodies[drive.mount->body].inertia);
  }
  for (actuator::Actuator& actuator : drive.actuators) {
    const std::optional<actuator::Battery> battery = actuator.battery;
    actuator = candidate.actuator;
    if (battery && !actuator.battery && !actuator.envelope) actuator.battery = battery;
  }
  drive.stated_rotors_kg_m2.clear();
  drive.joints_state_rotors = false;
  if (!drive.rotors_in_tree) return changed;
  // What the joints state is of the rotors that it replaces; its own turn as the mechanism says.
  drive.rotors_in_tree = false;
  for (const std::size_t joint : drive.joints) {
    changed.tree.bodies[joint].joint.reflected_inertia = 0.0;
  }
  return changed;
}

/// The drives' part of a demand with the rotors of a changed robot in one drivetrain. What they
/// bear apart from their own rotors is not that of any rotor.
Demand with_rotors_of(const Robot& changed, std::size_t drivetrain, const Demand& demand) {
  Demand exchanged;
  exchanged.has_dynamics = demand.has_dynamics;
  exchanged.drives = demand.drives;
  exchanged.shared_doubt_Nm = demand.shared_doubt_Nm;
  exchanged.left_out = demand.left_out;
  const WholeBody body(changed);
  std::size_t drive = first_drive(changed, drivetrain);
  for (std::size_t i = 0; i < changed.drivetrains[drivetrain].actuators.size(); ++i, ++drive) {
    const double rotor_kg_m2 = body.rotor_inertia_kg_m2(drive);
    for (DriveInstant& at : exchanged.drives[drive]) {
      at.torque_Nm = at.load_torque_Nm + rotor_kg_m2 * at.acceleration_rad_s2;
    }
  }
  return exchanged;
}

/// The demand of a candidate.
struct TriedMotion {
  Demand demand;
  std::optional<Demand> twice_as_far;
};

TriedMotion trial_of(const Basis& basis, const Robot& changed, std::size_t drivetrain,
                     bool same_mass) {
  const auto& [robot, options, motion, contacts, demand] = basis.checked;
  if (same_mass && !rotors_stay_in_tree(robot.drivetrains[drivetrain])) {
    TriedMotion trial{with_rotors_of(changed, drivetrain, demand), {}};
    if (basis.twice_as_far) {
      trial.twice_as_far = with_rotors_of(changed, drivetrain, *basis.twice_as_far);
    }
    return trial;
  }
  TriedMotion trial{demand_of(changed, motion, contacts), {}};
  if (!demand.left_out.empty()) leave_out(motion, demand.left_out, trial.demand);
  if (basis.twice_as_far) {
    trial.twice_as_far = demand_twice_as_far({changed, options, motion, contacts, trial.demand});
  }
  return trial;
}

/// What each reading of the file makes of the candidate's torques; one where there is one. Those of
/// the dynamics come with their doubt.
std::vector<DriveTorques> torques_of(const Basis& basis, const CheckedMotion& checked,
                                     const std::optional<Demand>& twice_as_far) {
  DriveTorques torques;
  torques.torque_Nm = torques_by_dynamics(checked.demand);
  if (basis.source == CandidateTorques::kDynamics) {
    torques.doubt_Nm = torque_doubts(checked, twice_as_far);
    return {torques};
  }
  const Eigen::MatrixXd with_rotor_Nm = torques.torque_Nm;
  torques.from_file = true;
  torques.torque_Nm += basis.torques.torque_Nm - torques_by_dynamics(basis.checked.demand);
  if (basis.torques.inertia != actuator::InertiaConvention::kUnstated) return {torques};
  DriveTorques without = torques;
  without.torque_Nm = basis.torques.torque_Nm + with_rotor_Nm;
  return {torques, without};
}

double stall_torque_Nm(const actuator::Actuator& actuator,
                       const actuator::OperatingConditions& conditions) {
  const actuator::JointRange range = actuator::Region(actuator, conditions).at(0.0);
  if (range.is_empty) return 0.0;
  return std::max(range.greatest.torque_Nm, -range.least.torque_Nm);
}

/// 1.5 R i^2 over the run, i the amplitude of a phase's current.
double copper_loss_J(const actuator::Actuator& actuator,
                     const actuator::OperatingConditions& conditions,
                     const actuator::DriveReport& report) {
  const actuator::PhaseModel model = actuator::phase_model_at(actuator, conditions);
  const double phase_A =
      report.interpretation.rms_current_A *
      actuator::phase_amperes_per_ampere(actuator.motor.torque_constant_convention);
  return 1.5 * model.resistance_ohm * phase_A * phase_A * (report.until_s - report.from_s);
}

std::string reason(const actuator::DriveReport& report, bool by_dynamics) {
  const actuator::CheckedInterpretation& interpretation = report.interpretation;
  const bool is_open = report.verdict == Verdict::kUndecided;
  for (const actuator::LeftOutEffect& effect : report.effects_left_out) {
    if (!is_open || !actuator::outweighs(effect, interpretation)) continue;
    return fmt::format("{}: undecided, {} is left out and may outweigh its margin", report.name,
                       effect.effect);
  }
  if (is_open && report.held_heat) {
    return fmt::format("{}: undecided, its winding is between {:.4g} and {:.4g} K", report.name,
                       report.held_heat->coldest_K, report.held_heat->warmest_K);
  }
  if (by_dynamics && is_open) {
    return fmt::format("{}: undecided, its limits lie within what the torques leave open",
                       report.name);
  }
  if (interpretation.first) {
    const actuator::WorstSample& first = *interpretation.first;
    return fmt::format("{} at t = {} s: {} ({}); {:.3g} % of the samples, the worst at t = {} s",
                       report.name, io::time_text(first.time_s, 4), actuator::outside_words(first),
                       actuator::name_of(first.limiter),
                       100.0 * static_cast<double>(interpretation.clipped_samples) /
                           static_cast<double>(report.samples),
                       io::time_text(interpretation.worst.time_s, 4));
  }
  if (interpretation.winding && interpretation.winding->runs_to_limit) {
    return fmt::format("{}: its winding passes {:.4g} K in run {}", report.name,
                       interpretation.winding->limit_K, *interpretation.winding->runs_to_limit);
  }
  for (const actuator::ContinuousUse* use :
       {&interpretation.continuous_current, &interpretation.continuous_torque}) {
    if (!use->is_passed()) continue;
    const bool is_current = use == &interpretation.continuous_current;
    return fmt::format("{}: its {} is {:.4g} {} root mean square, {:.4g} may last", report.name,
                       is_current ? "current" : "torque", use->rms, is_current ? "A" : "Nm",
                       *use->limit);
  }
  return fmt::format("{}: undecided, {}", report.name,
                     "whether the file's torque includes the rotor's decides");
}

/// What stands of a candidate before any motion.
CandidateResult described(const Robot& robot, std::size_t drivetrain, const Candidate& candidate) {
  CandidateResult result;
  result.drivetrain = drivetrain;
  result.name = candidate.name;
  result.ratio = candidate.actuator.transmission.ratio;
  result.rotor_inertia_kg_m2 = actuator::reflected_inertia_kg_m2(candidate.actuator);
  if (candidate.actuator.mass_kg) {
    const auto count = robot.drivetrains[drivetrain].actuators.size();
    result.mass_kg = *candidate.actuator.mass_kg * static_cast<double>(count);
  }
  return result;
}

void add_drive(const Candidate& candidate, const CheckOptions& options, double stall_Nm,
               const actuator::DriveReport& report, CandidateResult& result) {
  const actuator::CheckedInterpretation& interpretation = report.interpretation;
  result.margin_share = std::min(result.margin_share, interpretation.margin_Nm / stall_Nm);
  if (!candidate.actuator.envelope) {
    result.energy_J = result.energy_J.value_or(0.0) + interpretation.energy_drawn_J -
                      interpretation.energy_returned_J;
    result.copper_loss_J = result.copper_loss_J.value_or(0.0) +
                           copper_loss_J(candidate.actuator, options.conditions, report);
  }
  result.peak_torque_Nm = std::max(result.peak_torque_Nm, interpretation.peak_torque_Nm);
  if (interpretation.speed_margin_rad_s &&
      (!result.speed_margin_rad_s ||
       *interpretation.speed_margin_rad_s < *result.speed_margin_rad_s)) {
    result.speed_margin_rad_s = interpretation.speed_margin_rad_s;
  }
  if (report.verdict == Verdict::kPass || result.verdict == Verdict::kFail) return;
  result.verdict = report.verdict;
  result.why = reason(report, result.torques == CandidateTorques::kDynamics);
}

void add_battery(const std::vector<SharedBus>& buses, std::size_t first, std::size_t count,
                 CandidateResult& result) {
  for (const SharedBus& bus : buses) {
    const bool is_fed = std::any_of(bus.drives.begin(), bus.drives.end(), [&](std::size_t drive) {
      return drive >= first && drive < first + count;
    });
    const std::string overload = overload_of(bus);
    if (overload.empty() || !is_fed) continue;
    result.verdict = Verdict::kFail;
    result.why = "the battery that it shares: " + overload;
  }
}

/// With one reading of its torques.
CandidateResult judge(const CheckedMotion& checked, const DriveTorques& torques,
                      std::size_t drivetrain, const Candidate& candidate, CandidateResult result) {
  const std::vector<SharedBus> buses = shared_buses(checked, torques.torque_Nm);
  const DriveReports reports = check_drivetrain(checked, torques, buses, drivetrain);
  const double stall_Nm = stall_torque_Nm(candidate.actuator, checked.options.conditions);
  result.margin_share = std::numeric_limits<double>::infinity();
  for (const actuator::DriveReport& report : reports.drives) {
    add_drive(candidate, checked.options, stall_Nm, report, result);
  }
  add_battery(buses, first_drive(checked.robot, drivetrain),
              checked.robot.drivetrains[drivetrain].actuators.size(), result);
  return result;
}

CandidateResult refused(CandidateResult result, Verdict verdict, std::string why) {
  result.verdict = verdict;
  result.margin_share = -1.0;
  result.why = std::move(why);
  return result;
}

CandidateResult judge(const Basis& basis, std::size_t drivetrain, const Candidate& candidate) {
  const auto& [robot, options, motion, contacts, old_demand] = basis.checked;
  CandidateResult result = described(robot, drivetrain, candidate);
  result.torques = basis.source;
  if (const auto objections = actuator::objections(candidate.actuator, options.conditions);
      !objections.empty()) {
    return refused(std::move(result), Verdict::kFail, objections.front());
  }
  const bool same_mass = heavier_kg(robot.drivetrains[drivetrain], candidate) == 0.0;
  if (!same_mass && !old_demand.has_dynamics) {
    return refused(std::move(result), Verdict::kUndecided,
                   "its mass is another, and nothing says how the base moves");
  }
  const Robot changed = with(robot, drivetrain, candidate);
  const TriedMotion trial = trial_of(basis, changed, drivetrain, same_mass);
  const CheckedMotion checked{changed, options, motion, contacts, trial.demand};
  std::optional<CandidateResult> worst;
  for (const DriveTorques& torques : torques_of(basis, checked, trial.twice_as_far)) {
    CandidateResult one = judge(checked, torques, drivetrain, candidate, result);
    const bool differs = worst && worst->verdict != one.verdict;
    if (!worst || one.margin_share < worst->margin_share) worst = std::move(one);
    if (!differs) continue;
    worst->verdict = Verdict::kUndecided;
    worst->why = "whether the file's torque includes that of the old rotor decides";
  }
  return *worst;
}

bool is_less(const std::optional<double>& one, const std::optional<double>& other) {
  return one && other && *one < *other;
}

/// As good in everything and better in something. Where one of two is not known (masses, what a
/// drive by its curve draws), they count as equal.
bool dominates(const CandidateResult& one, const CandidateResult& other) {
  bool better = one.margin_share > other.margin_share;
  bool as_good = one.margin_share >= other.margin_share;
  for (const auto figure :
       {&CandidateResult::mass_kg, &CandidateResult::energy_J, &CandidateResult::copper_loss_J}) {
    as_good = as_good && !is_less(other.*figure, one.*figure);
    better = better || is_less(one.*figure, other.*figure);
  }
  return as_good && better;
}

void mark_front(std::vector<CandidateResult>& results) {
  for (CandidateResult& result : results) {
    result.is_on_front =
        result.verdict == Verdict::kPass &&
        std::none_of(results.begin(), results.end(), [&](const CandidateResult& other) {
          return other.drivetrain == result.drivetrain && other.verdict == Verdict::kPass &&
                 dominates(other, result);
        });
  }
}

void rank(std::vector<CandidateResult>& results) {
  std::stable_sort(results.begin(), results.end(),
                   [](const CandidateResult& one, const CandidateResult& other) {
                     if (one.drivetrain != other.drivetrain) {
                       return one.drivetrain < other.drivetrain;
                     }
                     const bool passes = one.verdict == Verdict::kPass;
                     if (passes != (other.verdict == Verdict::kPass)) return passes;
                     return one.margin_share > other.margin_share;
                   });
}

using Judge = std::function<CandidateResult(std::size_t drivetrain, const Candidate& candidate)>;

Judge judging(const CheckedMotion& checked) {
  return [basis = basis_of(checked)](std::size_t drivetrain, const Candidate& candidate) {
    return judge(basis, drivetrain, candidate);
  };
}

CheckOptions without_traces(CheckOptions options) {
  options.keep_traces = false;
  return options;
}

}  // namespace

struct CandidateTrials::Ready {
  Ready(const Robot& of, const Motion& motion, const CheckOptions& with, const HopperReport& report,
        const CandidateSet& candidates)
      : robot(of), options(without_traces(with)) {
    for (std::size_t i = 0; i < candidates.by_drivetrain.size(); ++i) {
      for (const Candidate& candidate : candidates.by_drivetrain[i])
        trials.emplace_back(i, &candidate);
    }
    judge_in = judging({robot, options, motion, report.contacts, report.demand});
  }

  const Robot& robot;
  CheckOptions options;
  std::vector<std::pair<std::size_t, const Candidate*>> trials;  ///< In which drivetrain.
  Judge judge_in;
};

CandidateTrials::CandidateTrials(const Robot& robot, const Motion& motion,
                                 const CheckOptions& options, const HopperReport& report,
                                 const CandidateSet& candidates)
    : ready_(std::make_unique<const Ready>(robot, motion, options, report, candidates)) {}

CandidateTrials::~CandidateTrials() = default;

std::size_t CandidateTrials::size() const { return ready_->trials.size(); }

std::string CandidateTrials::name_of(std::size_t number) const {
  const auto& [drivetrain, candidate] = ready_->trials[number];
  return fmt::format("{}: {}", drivetrain, candidate->name);
}

CandidateResult CandidateTrials::result_of(std::size_t number) const {
  const auto& [drivetrain, candidate] = ready_->trials[number];
  return ready_->judge_in(drivetrain, *candidate);
}

CandidateResult CandidateTrials::untried(std::size_t number, std::string why) const {
  const auto& [drivetrain, candidate] = ready_->trials[number];
  return refused(described(ready_->robot, drivetrain, *candidate), Verdict::kUndecided,
                 std::move(why));
}

std::vector<CandidateResult> ranked(std::vector<CandidateResult> results) {
  mark_front(results);
  rank(results);
  return results;
}

std::vector<CandidateResult> try_candidates(const Robot& robot, const Motion& motion,
                                            const CheckOptions& options, const HopperReport& report,
                                            const CandidateSet& candidates, std::size_t threads,
                                            const std::function<void(double)>& on_progress) {
  const CandidateTrials trials(robot, motion, options, report, candidates);
  std::vector<CandidateResult> results(trials.size());
  simulation::in_parallel(trials.size(), threads, [&](std::size_t number, std::size_t thread) {
    results[number] = trials.result_of(number);
    if (thread == 0 && on_progress) {
      on_progress(static_cast<double>(number) / static_cast<double>(trials.size()));
    }
  });
  return ranked(std::move(results));
}

}  // namespace torquewright::hopper
