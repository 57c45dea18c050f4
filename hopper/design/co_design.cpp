// SPDX-License-Identifier: Apache-2.0
#include "hopper/design/co_design.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "actuator/motor/gear_transmission.hpp"
#include "simulation/in_parallel.hpp"

namespace torquewright::hopper {
namespace {

using actuator::Verdict;

/// Least efficiency of the way back that is taken for possible: gears of less lock, and then their
/// teeth hold the load, which no motor needs.
constexpr double kLeastBackwardEfficiency = 1e-3;

class Work {
 public:
  Work(const Robot& robot, const Motion& motion, const CheckOptions& options,
       const HopperReport& report, const CoDesignQuestion& question)
      : robot_(robot), motion_(motion), options_(options), report_(report), question_(question) {}

  CoDesign run() {
    may_use_.assign(question_.ratios.size(), std::vector<bool>(motors().size(), true));
    if (question_.prunes) prune();
    search_gears();
    try_pairs();
    rank();
    return std::move(answer_);
  }

 private:
  const std::vector<ShelfMotor>& motors() const { return question_.shelf.motors; }

  Candidate candidate(std::size_t motor, actuator::Transmission transmission) const {
    Candidate made{fmt::format("{} {:g}:1", motors()[motor].name, std::abs(transmission.ratio)),
                   motors()[motor].actuator};
    made.actuator.transmission = std::move(transmission);
    actuator::carry_joint_rating(motors()[motor].actuator.transmission, made.actuator);
    made.actuator.mass_kg.reset();
    return made;
  }

  std::vector<CandidateResult> tried(const std::string& what, std::vector<Candidate> candidates) {
    CandidateSet set;
    set.by_drivetrain.resize(robot_.drivetrains.size());
    set.by_drivetrain[question_.drivetrain] = std::move(candidates);
    const CandidateTrials trials(robot_, motion_, options_, report_, set);
    std::vector<CandidateResult> results(trials.size());
    simulation::in_parallel(trials.size(), question_.threads,
                            [&](std::size_t number, std::size_t thread) {
                              results[number] = trials.result_of(number);
                              if (thread == 0) question_.report(what, number, trials.size());
                            });
    return results;
  }

  /// Every motor at every ratio, ratio by ratio, behind gears that take nothing on the way out.
  std::vector<Candidate> behind_ideal_gears(double backward_efficiency) const {
    std::vector<Candidate> candidates;
    for (const io::Rational& ratio : question_.ratios) {
      for (std::size_t motor = 0; motor < motors().size(); ++motor) {
        actuator::Transmission nothing;
        nothing.ratio = io::nearest(at_ratio(question_.problem, ratio).target_ratio);
        nothing.backward_efficiency = backward_efficiency;
        candidates.push_back(candidate(motor, nothing));
      }
    }
    return candidates;
  }

  /// Gears that bear all on the way back spare the motor, those that bear nothing feed a battery
  /// that others share: only what fails behind both is left out.
  void prune() {
    const char* const what = "motors behind gears that take nothing";
    const std::vector<CandidateResult> spared =
        tried(what, behind_ideal_gears(kLeastBackwardEfficiency));
    const std::vector<CandidateResult> feeding = tried(what, behind_ideal_gears(1.0));
    for (std::size_t i = 0; i < spared.size(); ++i) {
      if (spared[i].verdict != Verdict::kFail || feeding[i].verdict != Verdict::kFail) continue;
      const std::size_t ratio = i / motors().size(), motor = i % motors().size();
      may_use_[ratio][motor] = false;
      answer_.pruned.push_back({motor, ratio, spared[i].why});
    }
  }

  void search_gears() {
    answer_.gears.resize(question_.ratios.size());
    simulation::in_parallel(
        question_.ratios.size(), question_.threads, [&](std::size_t ratio, std::size_t thread) {
          answer_.gears[ratio].ratio = question_.ratios[ratio];
          const std::vector<bool>& use = may_use_[ratio];
          if (std::find(use.begin(), use.end(), true) == use.end()) return;
          answer_.gears[ratio] = gears_of_ratio(question_.problem, question_.ratios[ratio],
                                                question_.points, question_.should_stop);
          if (thread == 0) question_.report("ratios", ratio, question_.ratios.size());
        });
    answer_.is_whole =
        std::none_of(answer_.gears.begin(), answer_.gears.end(),
                     [](const auto& gears) { return gears.search == GearSearch::kLimit; });
  }

  void try_pairs() {
    std::vector<Candidate> candidates;
    for (std::size_t ratio = 0; ratio < answer_.gears.size(); ++ratio) {
      const std::vector<GearChoice>& choices = answer_.gears[ratio].choices;
      for (std::size_t choice = 0; choice < choices.size(); ++choice) {
        for (std::size_t motor = 0; motor < motors().size(); ++motor) {
          if (may_use_[ratio][motor]) add_pair({motor, ratio, choice, {}, {}, {}}, candidates);
        }
      }
    }
    std::vector<CandidateResult> results = tried("pairs", std::move(candidates));
    for (std::size_t i = 0; i < results.size(); ++i) {
      answer_.pairs[i].result = std::move(results[i]);
    }
  }

  void add_pair(DesignedPair pair, std::vector<Candidate>& candidates) {
    const GearChoice& choice = answer_.gears[pair.ratio].choices[pair.choice];
    pair.gears_kg = choice.report.mass_kg;
    const std::optional<double>& motor_kg = motors()[pair.motor].mass_kg;
    if (motor_kg && pair.gears_kg) pair.mass_kg = *motor_kg + *pair.gears_kg;
    candidates.push_back(candidate(pair.motor, choice.transmission));
    candidates.back().actuator.mass_kg = pair.mass_kg;
    answer_.pairs.push_back(std::move(pair));
  }

  /// What is compared in turn; the least comes first.
  static auto key(const DesignedPair& pair) {
    const bool passes = pair.result.verdict == Verdict::kPass;
    const int order = passes ? 0 : pair.result.verdict == Verdict::kUndecided ? 1 : 2;
    const double mass_kg = pair.mass_kg.value_or(pair.gears_kg.value_or(0.0));
    return std::tuple(order, passes && !pair.mass_kg, passes ? mass_kg : 0.0,
                      -pair.result.margin_share);
  }

  void rank() {
    std::stable_sort(
        answer_.pairs.begin(), answer_.pairs.end(),
        [](const DesignedPair& one, const DesignedPair& other) { return key(one) < key(other); });
  }

  const Robot& robot_;
  const Motion& motion_;
  const CheckOptions& options_;
  const HopperReport& report_;
  const CoDesignQuestion& question_;
  std::vector<std::vector<bool>> may_use_;  ///< By ratio and motor.
  CoDesign answer_;
};

}  // namespace

double greatest_load_Nm(const Robot& robot, std::size_t drivetrain, const HopperReport& report) {
  std::size_t drive = 0;
  for (std::size_t i = 0; i < drivetrain; ++i) drive += robot.drivetrains[i].actuators.size();
  double load_Nm = 0.0;
  for (std::size_t i = 0; i < robot.drivetrains[drivetrain].actuators.size(); ++i, ++drive) {
    for (const DriveInstant& at : report.demand.drives[drive]) {
      load_Nm = std::max(load_Nm, std::abs(at.load_torque_Nm));
    }
  }
  return load_Nm;
}

CoDesign co_design(const Robot& robot, const Motion& motion, const CheckOptions& options,
                   const HopperReport& report, const CoDesignQuestion& question) {
  return Work(robot, motion, options, report, question).run();
}

}  // namespace torquewright::hopper
