// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "learning/team.hpp"
#include "learning/training/model.hpp"
#include "learning/training/samples.hpp"
#include "learning/training/trainer_options.hpp"

namespace torquewright::learning {

/// Says of every sample how much better it was than expected: values by the critics, advantages of
/// each head, their sum, and what the critics are to learn. Renews the critics' scale.
void judge(const TrainerOptions& options, Model& model, Team& team, Samples& samples);

/// The critics' values (views x heads) of the pass's inputs, in units of rewards.
void write_values(const Model& model, const ValueScale& scale, Network<float>::Pass& pass,
                  Eigen::Ref<Eigen::MatrixXd> values);

}  // namespace torquewright::learning
