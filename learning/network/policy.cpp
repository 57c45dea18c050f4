// SPDX-License-Identifier: Apache-2.0
#include "learning/network/policy.hpp"

#include <stdexcept>

namespace torquewright::learning {
namespace {

/// Empty where the layers fit to that many inputs and to each other.
std::string objection_to_layers(const std::vector<Layer>& layers, Eigen::Index inputs,
                                const std::string& name) {
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const Layer& layer = layers[i];
    const std::string which = "layer " + std::to_string(i + 1) + name;
    if (layer.weights.cols() != inputs) {
      return which + " has weights for " + std::to_string(layer.weights.cols()) +
             " inputs, not for the " + std::to_string(inputs) + " that it is given";
    }
    if (layer.weights.rows() != layer.bias.size() || layer.bias.size() == 0) {
      return which + " has " + std::to_string(layer.weights.rows()) + " rows of weights and " +
             std::to_string(layer.bias.size()) + " numbers of bias, which are to be equally many";
    }
    if (!layer.weights.allFinite() || !layer.bias.allFinite()) {
      return which + " has a number that is not finite";
    }
    inputs = layer.bias.size();
  }
  return "";
}

void evaluate(const std::vector<Layer>& layers, const Eigen::Ref<const Eigen::VectorXd>& input,
              std::vector<Eigen::VectorXd>& values) {
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const Layer& layer = layers[i];
    values[i] = layer.bias;
    if (i == 0) {
      values[i].noalias() += layer.weights * input;
    } else {
      values[i].noalias() += layer.weights * values[i - 1];
    }
    for (double& value : values[i]) value = value_of(layer.activation, value);
  }
}

std::vector<Eigen::VectorXd> room_for(const std::vector<Layer>& layers) {
  std::vector<Eigen::VectorXd> values;
  for (const Layer& layer : layers) values.push_back(Eigen::VectorXd::Zero(layer.bias.size()));
  return values;
}

}  // namespace

std::string objection_to(const Policy& policy) {
  const Normalisation& seen = policy.normalisation;
  if (seen.mean.size() != seen.deviation.size() || seen.mean.size() == 0) {
    return "the normalisation has " + std::to_string(seen.mean.size()) + " means and " +
           std::to_string(seen.deviation.size()) + " deviations, which are to be equally many";
  }
  if (!seen.mean.allFinite() || !seen.deviation.allFinite() || seen.deviation.minCoeff() <= 0.0) {
    return "the normalisation has a number that is not finite, or a deviation that is not above 0";
  }
  if (policy.layers.empty()) return "the policy has no layer";
  std::string objection =
      objection_to_layers(policy.estimator, seen.mean.size(), " of the estimator");
  if (!objection.empty()) return objection;
  const Eigen::Index guessed = policy.estimator.empty() ? 0 : policy.estimator.back().bias.size();
  return objection_to_layers(policy.layers, seen.mean.size() + guessed, "");
}

PolicyEvaluation::PolicyEvaluation(Policy policy) : policy_(std::move(policy)) {
  const std::string objection = objection_to(policy_);
  if (!objection.empty()) throw std::invalid_argument(objection);
  guessed_ = room_for(policy_.estimator);
  values_ = room_for(policy_.layers);
  seen_ = Eigen::VectorXd::Zero(policy_.layers.front().weights.cols());
}

const Eigen::VectorXd& PolicyEvaluation::action(
    const Eigen::Ref<const Eigen::VectorXd>& observation) {
  const Normalisation& usual = policy_.normalisation;
  seen_.head(policy_.inputs()) = (observation - usual.mean).cwiseQuotient(usual.deviation);
  if (!guessed_.empty()) {
    evaluate(policy_.estimator, seen_.head(policy_.inputs()), guessed_);
    seen_.tail(guessed_.back().size()) = guessed_.back();
  }
  evaluate(policy_.layers, seen_, values_);
  return values_.back();
}

Eigen::Ref<const Eigen::VectorXd> PolicyEvaluation::guess() const {
  return seen_.tail(seen_.size() - policy_.inputs());
}

}  // namespace torquewright::learning
