// SPDX-License-Identifier: Apache-2.0
#include "hopper/calibration/figures.hpp"

#include "robot/model/robot_centroid.hpp"
#include "robot/parts/plausible_inertia.hpp"

namespace torquewright::hopper::calibration {
namespace {

bool changes_inertia(const Knob& knob) {
  return knob.kind == Knob::Kind::kInertia || knob.kind == Knob::Kind::kRoundInertia;
}

}  // namespace

std::vector<double> inertias_kg_m2(const Question& question, std::span<const double> values) {
  dynamics::Tree tree = question.tree;
  std::vector<Posture> postures = question.postures;
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (const Knob& knob : question.free[i].knobs) turn(knob, values[i], tree, postures);
  }
  for (const FreeValue& free : question.free) {
    for (const Knob& knob : free.knobs) {
      if (!changes_inertia(knob)) continue;
      if (inertia_objection(tree.bodies[knob.body].inertia.inertia_kg_m2)) return {};
    }
  }
  std::optional<Robot> with_links = question.with_links;
  if (with_links) with_links->tree = tree;
  std::vector<double> inertias;
  for (const SpeedTarget& target : question.figures.speeds) {
    const Posture& posture = postures[target.posture];
    inertias.push_back(with_links ? pitch_inertia_kg_m2(*with_links, posture)
                                  : pitch_inertia_kg_m2(tree, posture));
  }
  return inertias;
}

std::vector<double> errors(const Question& question, std::span<const double> values) {
  std::vector<double> errors = inertias_kg_m2(question, values);
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const Figures& figures = question.figures;
    errors[i] = figures.angular_momentum_Nm_s / errors[i] / figures.speeds[i].speed_rad_s - 1.0;
  }
  return errors;
}

}  // namespace torquewright::hopper::calibration
