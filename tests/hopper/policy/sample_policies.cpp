// SPDX-License-Identifier: Apache-2.0
#include "tests/hopper/policy/sample_policies.hpp"

#include <algorithm>

#include "learning/generator.hpp"

namespace torquewright::hopper::test {
namespace {

using learning::ActivationKind;
using learning::Generator;
using learning::Layer;

/// Floats, as they are learned.
Eigen::MatrixXd drawn_floats(Generator& generator, Eigen::Index rows, Eigen::Index columns,
                             double size) {
  Eigen::MatrixXd matrix(rows, columns);
  for (double& entry : matrix.reshaped()) entry = static_cast<float>(size * generator.normal());
  return matrix;
}

std::vector<Layer> drawn_layers(Generator& generator, const std::vector<int>& widths,
                                const learning::Activation& activation) {
  std::vector<Layer> layers;
  for (std::size_t i = 1; i < widths.size(); ++i) {
    const bool is_last = i + 1 == widths.size();
    layers.push_back({drawn_floats(generator, widths[i], widths[i - 1], 0.5),
                      drawn_floats(generator, widths[i], 1, 0.2),
                      is_last ? learning::activation_of(ActivationKind::kIdentity) : activation});
  }
  return layers;
}

}  // namespace

PolicyDocument sample_policy(ActivationKind kind, bool has_estimator) {
  Generator generator(11, static_cast<std::uint64_t>(kind));
  const learning::Activation activation = learning::activation_of(kind);
  PolicyDocument document;
  document.task = "stand";
  document.policy.normalisation.mean = drawn_floats(generator, 5, 1, 2.0);
  document.policy.normalisation.deviation =
      drawn_floats(generator, 5, 1, 1.0).cwiseAbs().array() + 0.25;
  if (has_estimator) document.policy.estimator = drawn_layers(generator, {5, 7, 3}, activation);
  document.policy.layers = drawn_layers(generator, {has_estimator ? 8 : 5, 16, 9, 2}, activation);
  document.inputs = {{"base_pitch_rad", "rad", 0},
                     {"base_pitch_rate_rad_s", "rad/s", 0},
                     {"knee_rad", "rad", 0},
                     {"knee_rad", "rad", 1},
                     {"phase_sin", "1", 0}};
  document.outputs = {{"knee_target_rad", "rad", 1.1, 1.0}, {"ankle_target_rad", "rad", -0.1, 0.7}};
  document.gains = {{"ankle", 100.0, 3.0}, {"knee", 150.0, 5.0}};
  document.control_period_s = 0.01;
  document.limits = "mor";
  document.trained_with = {{"hopper.json", std::string(64, 'a')}};
  return document;
}

std::vector<PolicyDocument> sample_policies() {
  std::vector<PolicyDocument> all;
  for (const ActivationKind kind :
       {ActivationKind::kIdentity, ActivationKind::kRelu, ActivationKind::kLeakyRelu,
        ActivationKind::kElu, ActivationKind::kTanh}) {
    for (const bool has_estimator : {false, true}) {
      all.push_back(sample_policy(kind, has_estimator));
    }
  }
  return all;
}

PolicyDocument policy_along_a_course() {
  PolicyDocument document = sample_policy(ActivationKind::kElu, false);
  document.outputs[0].course = {0.5, -1.0, 2.0};
  document.outputs[1].course = {0.1};
  return document;
}

Eigen::MatrixXd sample_observations(const PolicyDocument& document, Eigen::Index count) {
  Generator generator(12, 0);
  const learning::Normalisation& usual = document.policy.normalisation;
  Eigen::MatrixXd views = drawn_floats(generator, usual.mean.size(), count, 1.0);
  views = (usual.deviation.asDiagonal() * views).colwise() + usual.mean;
  return views.cast<float>().cast<double>();
}

Eigen::VectorXd target_of(const PolicyDocument& document, const Eigen::VectorXd& action,
                          Eigen::Index period) {
  Eigen::VectorXd target(action.size());
  for (Eigen::Index i = 0; i < action.size(); ++i) {
    const PolicyOutput& output = document.outputs[static_cast<std::size_t>(i)];
    target(i) = output.offset + output.scale * action(i);
    if (output.course.empty()) continue;
    const auto last = static_cast<Eigen::Index>(output.course.size()) - 1;
    target(i) += output.course[static_cast<std::size_t>(std::min(period, last))];
  }
  return target;
}

}  // namespace torquewright::hopper::test
