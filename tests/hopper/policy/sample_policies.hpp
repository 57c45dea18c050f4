// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "hopper/policy/policy_document.hpp"

namespace torquewright::hopper::test {

/// A policy of 5 inputs and 2 outputs with drawn weights, of that activation, with or without an
/// estimator of 3 guesses.
PolicyDocument sample_policy(learning::ActivationKind kind, bool has_estimator);

/// One of every activation, with and without an estimator.
std::vector<PolicyDocument> sample_policies();

/// One whose targets go by the time too.
PolicyDocument policy_along_a_course();

/// Observations (inputs x count) for it, within three deviations of what is usual.
Eigen::MatrixXd sample_observations(const PolicyDocument& document, Eigen::Index count);

/// offset + course + scale * action.
Eigen::VectorXd target_of(const PolicyDocument& document, const Eigen::VectorXd& action,
                          Eigen::Index period = 0);

}  // namespace torquewright::hopper::test
