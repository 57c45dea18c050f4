// SPDX-License-Identifier: Apache-2.0
#include "hopper/policy/layer_chain.hpp"

#include <utility>

namespace torquewright::hopper {
namespace {

const learning::Activation kNone = learning::activation_of(learning::ActivationKind::kIdentity);

learning::Layer identity_layer(Eigen::Index size) {
  return {Eigen::MatrixXd::Identity(size, size), Eigen::VectorXd::Zero(size), kNone};
}

}  // namespace

LayerChain::LayerChain(Eigen::Index inputs)
    : scale_(Eigen::VectorXd::Ones(inputs)), shift_(Eigen::VectorXd::Zero(inputs)) {}

Eigen::Index LayerChain::outputs() const {
  if (!layers_.empty()) return layers_.back().bias.size();
  return scale_.size() + (estimator_.empty() ? 0 : estimator_.back().bias.size());
}

bool LayerChain::is_linear_so_far() const {
  return !layers_.empty() && layers_.back().activation == kNone;
}

void LayerChain::scale(const Eigen::VectorXd& factor, const Eigen::VectorXd& summand) {
  if (layers_.empty() && estimator_.empty()) {
    scale_ = scale_.cwiseProduct(factor);
    shift_ = shift_.cwiseProduct(factor) + summand;
    return;
  }
  if (!is_linear_so_far()) layers_.push_back(identity_layer(outputs()));
  learning::Layer& last = layers_.back();
  last.weights = factor.asDiagonal() * last.weights;
  last.bias = last.bias.cwiseProduct(factor) + summand;
}

void LayerChain::multiply(const Eigen::MatrixXd& weights, const Eigen::VectorXd& bias) {
  if (!is_linear_so_far()) {
    layers_.push_back({weights, bias, kNone});
    return;
  }
  learning::Layer& last = layers_.back();
  last.bias = weights * last.bias + bias;
  last.weights = weights * last.weights;
}

void LayerChain::activate(const learning::Activation& activation) {
  if (!is_linear_so_far()) layers_.push_back(identity_layer(outputs()));
  layers_.back().activation = activation;
}

bool LayerChain::can_be_guessed_by(const LayerChain& other) const {
  return layers_.empty() && estimator_.empty() && other.estimator_.empty() && other.has_layers() &&
         other.scale_ == scale_ && other.shift_ == shift_;
}

void LayerChain::put_guess(const LayerChain& other) { estimator_ = other.layers_; }

learning::Policy LayerChain::policy() const {
  learning::Policy policy;
  policy.estimator = estimator_;
  policy.layers = layers_;
  if (policy.layers.empty()) policy.layers.push_back(identity_layer(outputs()));
  if (scale_.minCoeff() > 0.0) {
    policy.normalisation = {-shift_.cwiseQuotient(scale_), scale_.cwiseInverse()};
    return policy;
  }
  // A scale that is not above 0 is no deviation: the first layers do its work.
  policy.normalisation = {Eigen::VectorXd::Zero(scale_.size()),
                          Eigen::VectorXd::Ones(scale_.size())};
  const auto take_over = [&](learning::Layer& first) {
    auto of_inputs = first.weights.leftCols(scale_.size());
    first.bias += of_inputs * shift_;
    of_inputs = (of_inputs * scale_.asDiagonal()).eval();
  };
  take_over(policy.layers.front());
  if (!policy.estimator.empty()) take_over(policy.estimator.front());
  return policy;
}

}  // namespace torquewright::hopper
