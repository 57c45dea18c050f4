// SPDX-License-Identifier: Apache-2.0
#include "learning/training/judging.hpp"

#include <algorithm>
#include <cmath>

#include "learning/formulas/advantages.hpp"

namespace torquewright::learning {
namespace {

constexpr double kLeastAdvantageDeviation = 1e-8;

/// Values of one copy's samples, and of what lies beyond them.
void value_copy(const Model& model, const ValueScale& scale, int copy, Samples& samples) {
  thread_local Network<float>::Pass pass;
  const int first = copy * samples.steps;
  const auto at = static_cast<std::size_t>(copy);
  const auto beyond = static_cast<Eigen::Index>(samples.beyond_count[at]);
  pass.inputs.resize(samples.critic_views.rows(), samples.steps + beyond);
  for (int t = 0; t < samples.steps; ++t) {
    model.critic_inputs.show(samples.critic_views.col(first + t), pass.inputs.col(t));
  }
  for (Eigen::Index i = 0; i < beyond; ++i) {
    model.critic_inputs.show(samples.beyond[at][static_cast<std::size_t>(i)].critic_view,
                             pass.inputs.col(samples.steps + i));
  }
  thread_local Eigen::MatrixXd values;
  values.resize(pass.inputs.cols(), samples.values.cols());
  write_values(model, scale, pass, values);
  samples.values.middleRows(first, samples.steps) = values.topRows(samples.steps);
  for (int t = 0; t < samples.steps; ++t) {
    const bool goes_on = samples.goes_on[static_cast<std::size_t>(first + t)] != 0;
    samples.next_values.row(first + t).setZero();
    if (goes_on && t + 1 < samples.steps) {
      samples.next_values.row(first + t) = values.row(t + 1);
    }
  }
  for (Eigen::Index i = 0; i < beyond; ++i) {
    samples.next_values.row(samples.beyond[at][static_cast<std::size_t>(i)].sample) =
        values.row(samples.steps + i);
  }
}

void advantages_of_copy(const TrainerOptions& options, int copy, Samples& samples) {
  const int first = copy * samples.steps;
  const auto begin = samples.goes_on.begin() + first;
  thread_local std::vector<char> goes_on;
  goes_on.assign(begin, begin + samples.steps);
  for (Eigen::Index head = 0; head < samples.values.cols(); ++head) {
    const bool is_common = options.discounts.size() == 1;
    const double discount = options.discounts[is_common ? 0 : static_cast<std::size_t>(head)];
    advantages_of({samples.rewards.col(head).segment(first, samples.steps),
                   samples.values.col(head).segment(first, samples.steps),
                   samples.next_values.col(head).segment(first, samples.steps), goes_on},
                  discount, options.lambda,
                  samples.advantages_of_heads.col(head).segment(first, samples.steps));
  }
}

/// What the critics are to say of each sample: the advantage and the value that it was over.
void set_targets(Model& model, Samples& samples) {
  samples.targets = (samples.advantages_of_heads + samples.values).transpose().cast<float>();
  renew_value_scale(samples.targets, model);
  const ValueScale scale = value_scale_of(model);
  const Eigen::VectorXf mean = scale.mean.cast<float>();
  const Eigen::VectorXf inverse = scale.deviation.cwiseInverse().cast<float>();
  samples.targets = inverse.asDiagonal() * (samples.targets.colwise() - mean);
}

void add_advantages(Samples& samples) {
  const Eigen::VectorXd sum = samples.advantages_of_heads.rowwise().sum();
  const double mean = sum.mean();
  const double deviation = std::sqrt((sum.array() - mean).square().mean());
  samples.advantages =
      ((sum.array() - mean) / std::max(deviation, kLeastAdvantageDeviation)).cast<float>();
}

}  // namespace

void write_values(const Model& model, const ValueScale& scale, Network<float>::Pass& pass,
                  Eigen::Ref<Eigen::MatrixXd> values) {
  for (int critic = 0; critic < static_cast<int>(model.critics.size()); ++critic) {
    const auto& outputs = model.critics[static_cast<std::size_t>(critic)].network.evaluate(pass);
    for (int head = 0; head < static_cast<int>(values.cols()); ++head) {
      if (model.critic_of(head) != critic) continue;
      values.col(head) =
          outputs.row(model.output_of(head)).transpose().cast<double>() * scale.deviation(head) +
          Eigen::VectorXd::Constant(values.rows(), scale.mean(head));
    }
  }
}

void judge(const TrainerOptions& options, Model& model, Team& team, Samples& samples) {
  const ValueScale scale = value_scale_of(model);
  team.run(samples.copies, [&](int copy, int) {
    value_copy(model, scale, copy, samples);
    advantages_of_copy(options, copy, samples);
  });
  set_targets(model, samples);
  add_advantages(samples);
}

}  // namespace torquewright::learning
