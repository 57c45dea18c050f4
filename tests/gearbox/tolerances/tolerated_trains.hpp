// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "gearbox/tolerances/built_train.hpp"
#include "gearbox/topologies/topology.hpp"
#include "tests/gearbox/example_problem.hpp"

namespace torquewright::gearbox::test {

inline ToleratedTrain tolerated(const Problem& problem, const Design& design,
                                const std::vector<PartLimit>& limits = {}) {
  CutTrain cut = cut_train(gear_train(problem, design)).value();
  const DesignReport report = find_topology(problem.topology)->evaluate(problem, design);
  std::vector<PartLimit> wanted = limits.empty() ? usual_limits(cut) : limits;
  return tolerated_train(std::move(cut), report, std::move(wanted));
}

inline const Design kKneeDesign{{44, 44, 32, 132, 120}, 4, Rational(3, 5)};

inline ToleratedTrain tolerated_knee() { return tolerated(knee(), kKneeDesign); }

/// Matsuki's bilateral drive: shifted gears of two modules.
inline ToleratedTrain tolerated_drive() {
  Problem problem = knee();
  problem.module_mm = {Rational(4, 5)};
  Design design{{12, 39, 32, 90, 81},
                3,
                Rational(4, 5),
                {0.476, 0.762, 0.536, 0.0, 0.0},
                Rational(8467, 10000)};
  design.profile_shift = coaxial_shifts(gear_train(problem, design)).value();
  return tolerated(problem, design);
}

/// A single stage, 4:1.
inline ToleratedTrain tolerated_stage() {
  Problem problem = knee();
  problem.topology = "planetary";
  problem.target_ratio = 4;
  problem.min_teeth = {{"sun", 20}, {"planet", 20}};
  return tolerated(problem, {{24, 24, 72}, 3, Rational(1)});
}

inline std::vector<double> nominal(const ToleratedTrain& train) {
  return std::vector<double>(train.limits.size(), 0.0);
}

/// Deviations that are nominal but for one.
inline std::vector<double> but(const ToleratedTrain& train, const std::string& name,
                               double deviation) {
  std::vector<double> deviations = nominal(train);
  for (std::size_t i = 0; i < deviations.size(); ++i) {
    if (train.limits[i].name == name) deviations[i] = deviation;
  }
  return deviations;
}

inline double output_rad(const ToleratedTrain& train, Deviations deviations) {
  std::vector<double> backlash_mm;
  for (std::size_t mesh = 0; mesh < train.cut.meshes.size(); ++mesh) {
    backlash_mm.push_back(built_mesh(train, mesh, deviations).backlash_mm);
  }
  return train.backlash_rad(backlash_mm);
}

}  // namespace torquewright::gearbox::test
