// SPDX-License-Identifier: Apache-2.0
// What a tracking controller does with an impact that comes early or late, on Rabbit's published
// walking: three handlings, two gains, two metrics, two plants (tests/real_data/motions). Writes
// impacts.csv and torques.csv into a folder and the tables of docs/replay.md to stdout.
//   study_impact build/study_impact
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "robot/model/robot_spec.hpp"
#include "tests/real_data/motions/walk_trial.hpp"

namespace torquewright::bench {
namespace {

using hopper::ImpactHandling;
using hopper::ImpactMetric;
using test::WalkResult;
using test::WalkTrial;

constexpr std::array kHandlings = {ImpactHandling::kDefault, ImpactHandling::kNoDerivative,
                                   ImpactHandling::kInvariant};
constexpr std::array kNames = {"default", "no_derivative", "invariant"};

using Results = std::array<WalkResult, 3>;

class Study {
 public:
  explicit Study(const std::filesystem::path& folder)
      : robot_(hopper::read_robot(TORQUEWRIGHT_SOURCE_DIR "/specs/robot/rabbit.json").robot),
        walk_(test::read_walk(test::rabbit_folder())),
        rows_(folder / "impacts.csv") {
    rows_ << "plant,ground_m,push_m_s,damping_1_s,window_s,metric,handling,contact_s,"
             "peak_torque_Nm,landing_leg_rad_s,other_leg_rad_s\n";
  }

  /// The trial with each handling, written down.
  Results run(WalkTrial trial) {
    Results results;
    const auto& control = trial.control;
    for (std::size_t i = 0; i < kHandlings.size(); ++i) {
      trial.control.impact.handling = kHandlings[i];
      const WalkResult& result = results[i] = test::walk(robot_, walk_, trial);
      if (!result.has_landed) throw std::runtime_error("the foot did not land");
      const std::string row =
          fmt::format("{},{},{},{},{},{},{},{:.6f},{:.5g},{:.5g},{:.5g}\n",
                      trial.is_stepped ? "stepped" : "held", trial.ground_height_m,
                      trial.swing_push_m_s, control.damping_1_s, control.impact.window_s,
                      control.impact.metric == ImpactMetric::kInertia ? "inertia" : "euclidean",
                      kNames[i], result.contact_s, result.peak_torque_Nm, result.landing_leg_rad_s,
                      result.other_leg_rad_s);
      if (written_.insert(row).second) rows_ << row;
    }
    return results;
  }

 private:
  hopper::Robot robot_;
  test::Walk walk_;
  std::ofstream rows_;
  std::set<std::string> written_;  ///< Tables share some.
};

/// What a cell says: default / without derivative / invariant.
template <typename Of>
std::string three(const Results& results, Of of) {
  return fmt::format("{}/{}/{}", of(results[0]), of(results[1]), of(results[2]));
}

/// Contact, torque and the errors of either leg as cells of a row.
std::string cells(const Results& results) {
  const auto contact = [](const WalkResult& r) {
    return fmt::format("{:+.1f}", 1e3 * r.contact_s);
  };
  const auto peak = [](const WalkResult& r) {
    const int decimals = r.peak_torque_Nm < 10.0 ? 2 : r.peak_torque_Nm < 100.0 ? 1 : 0;
    return fmt::format("{:.{}f}", r.peak_torque_Nm, decimals);
  };
  const auto other = [](const WalkResult& r) { return fmt::format("{:.2f}", r.other_leg_rad_s); };
  const auto lands = [](const WalkResult& r) { return fmt::format("{:.2f}", r.landing_leg_rad_s); };
  return fmt::format("{} | {} | {} | {} |\n", three(results, contact), three(results, peak),
                     three(results, other), three(results, lands));
}

constexpr const char* kColumns =
    "contact, ms | peak torque, N m | other leg, rad/s | landing leg, rad/s |\n";

void grounds(Study& study) {
  for (const double damping_1_s : {20.0, 40.0}) {
    fmt::print("\nKd = {}/s:\n\n| ground, mm | {}|---|---|---|---|---|\n", damping_1_s, kColumns);
    for (const double height_mm : {4.0, 2.0, 1.0, 0.0, -1.0, -2.0, -4.0, -8.0}) {
      WalkTrial trial;
      trial.ground_height_m = 1e-3 * height_mm;
      trial.control.damping_1_s = damping_1_s;
      fmt::print("| {:+g} | {}", height_mm, cells(study.run(trial)));
    }
  }
}

void pushes(Study& study) {
  fmt::print(
      "\nThe swinging foot is pushed at t = 0, ground where it was planned:\n\n"
      "| Kd, 1/s | push, m/s | plant | {}|---|---|---|---|---|---|---|\n",
      kColumns);
  for (const double damping_1_s : {20.0, 40.0}) {
    for (const double push_m_s : {0.1, 0.05, -0.05, -0.1}) {
      for (const bool is_stepped : {false, true}) {
        WalkTrial trial;
        trial.before = 0;
        trial.swing_push_m_s = push_m_s;
        trial.is_stepped = is_stepped;
        trial.control.damping_1_s = damping_1_s;
        fmt::print("| {} | {:+g} | {} | {}", damping_1_s, push_m_s,
                   is_stepped ? "free feet" : "foot held", cells(study.run(trial)));
      }
    }
  }
}

void windows(Study& study) {
  fmt::print(
      "\nOther windows and the metric of inertia, Kd = 20/s:\n\n"
      "| ground, mm | window, s | metric | {}|---|---|---|---|---|---|---|\n",
      kColumns);
  for (const double height_mm : {-2.0, -8.0}) {
    for (const double window_s : {0.025, 0.05, 0.1}) {
      for (const ImpactMetric metric : {ImpactMetric::kEuclidean, ImpactMetric::kInertia}) {
        WalkTrial trial;
        trial.ground_height_m = 1e-3 * height_mm;
        trial.control.impact.window_s = window_s;
        trial.control.impact.metric = metric;
        fmt::print("| {:+g} | {} | {} | {}", height_mm, window_s,
                   metric == ImpactMetric::kInertia ? "inertia" : "Euclidean",
                   cells(study.run(trial)));
      }
    }
  }
}

/// The greatest joint's torque over time, of ground 2 mm lower.
void torques(Study& study, const std::filesystem::path& folder) {
  WalkTrial trial;
  trial.ground_height_m = -0.002;
  const Results results = study.run(trial);
  std::ofstream rows(folder / "torques.csv");
  rows << "time_s,default_Nm,no_derivative_Nm,invariant_Nm\n";
  std::size_t count = results[0].samples.size();
  for (const WalkResult& result : results) count = std::min(count, result.samples.size());
  for (std::size_t i = 0; i < count; ++i) {
    rows << fmt::format("{:.6f}", results[0].samples[i].time_s);
    for (const WalkResult& result : results) {
      rows << fmt::format(",{:.5g}", result.samples[i].torque_Nm.cwiseAbs().maxCoeff());
    }
    rows << '\n';
  }
}

int run(const std::filesystem::path& folder) {
  if (test::rabbit_folder().empty()) {
    fmt::print(stderr, "study_impact: needs Rabbit's published walking, ../shared/data\n");
    return 2;
  }
  std::filesystem::create_directories(folder);
  Study study(folder);
  fmt::print("Each cell: default / without derivative / invariant.\n");
  grounds(study);
  pushes(study);
  windows(study);
  torques(study, folder);
  return 0;
}

}  // namespace
}  // namespace torquewright::bench

int main(int count, char** words) {
  if (count != 2) {
    fmt::print(stderr, "usage: study_impact FOLDER\n");
    return 2;
  }
  try {
    return torquewright::bench::run(words[1]);
  } catch (const std::exception& error) {
    fmt::print(stderr, "study_impact: {}\n", error.what());
    return 2;
  }
}
