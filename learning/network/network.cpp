// SPDX-License-Identifier: Apache-2.0
#include "learning/network/network.hpp"

#include <cmath>
#include <stdexcept>

#include "learning/network/products.hpp"

namespace torquewright::learning {
namespace {

/// Puts activations in the place of what stands before them.
template <typename Matrix>
void activate(const Activation& activation, Matrix& values) {
  using Scalar = typename Matrix::Scalar;
  const auto alpha = static_cast<Scalar>(activation.alpha);
  auto array = values.array();
  switch (activation.kind) {
    case ActivationKind::kIdentity:
      return;
    case ActivationKind::kRelu:
      array = array.max(Scalar(0));
      return;
    case ActivationKind::kLeakyRelu:
      array = array.max(Scalar(0)) + alpha * array.min(Scalar(0));
      return;
    case ActivationKind::kElu:
      array = array.max(Scalar(0)) + alpha * (array.min(Scalar(0)).exp() - Scalar(1));
      return;
    case ActivationKind::kTanh:
      array = array.tanh();
      return;
  }
}

/// Derivative where the activation's value is y; written so that loops over it have no branches.
template <typename Scalar>
Scalar slope_at(ActivationKind kind, Scalar alpha, Scalar y) {
  switch (kind) {
    case ActivationKind::kIdentity:
      return Scalar(1);
    case ActivationKind::kRelu:
      return y > Scalar(0) ? Scalar(1) : Scalar(0);
    case ActivationKind::kLeakyRelu:
      return y > Scalar(0) ? Scalar(1) : alpha;
    case ActivationKind::kElu:
      return y > Scalar(0) ? Scalar(1) : y + alpha;
    case ActivationKind::kTanh:
      return Scalar(1) - y * y;
  }
  return Scalar(1);
}

template <ActivationKind kKind, typename Matrix>
void multiply_by_slopes_of(double alpha, const Matrix& values, Matrix& errors) {
  using Scalar = typename Matrix::Scalar;
  const auto of = static_cast<Scalar>(alpha);
  const Scalar* value = values.data();
  Scalar* error = errors.data();
  const Eigen::Index count = errors.size();
  for (Eigen::Index i = 0; i < count; ++i) error[i] *= slope_at(kKind, of, value[i]);
}

template <typename Matrix>
void multiply_by_slopes(const Activation& activation, const Matrix& values, Matrix& errors) {
  switch (activation.kind) {
    case ActivationKind::kIdentity:
      return;
    case ActivationKind::kRelu:
      return multiply_by_slopes_of<ActivationKind::kRelu>(activation.alpha, values, errors);
    case ActivationKind::kLeakyRelu:
      return multiply_by_slopes_of<ActivationKind::kLeakyRelu>(activation.alpha, values, errors);
    case ActivationKind::kElu:
      return multiply_by_slopes_of<ActivationKind::kElu>(activation.alpha, values, errors);
    case ActivationKind::kTanh:
      return multiply_by_slopes_of<ActivationKind::kTanh>(activation.alpha, values, errors);
  }
}

}  // namespace

template <typename Scalar>
Network<Scalar>::Network(NetworkShape shape) : shape_(std::move(shape)), starts_{0} {
  if (shape_.widths.size() < 2) throw std::invalid_argument("a network has at least one layer");
  if (shape_.hidden.alpha < 0.0) {
    throw std::invalid_argument("an activation's alpha is not negative");
  }
  for (int i = 0; i < layers(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (shape_.widths[at] < 1 || shape_.widths[at + 1] < 1) {
      throw std::invalid_argument("a layer of a network has at least one input and one output");
    }
    const Eigen::Index in = shape_.widths[at];
    const Eigen::Index out = shape_.widths[at + 1];
    starts_.push_back(starts_.back() + (in + 1) * out);
  }
  parameters_ = Vector::Zero(starts_.back());
}

template <typename Scalar>
void Network<Scalar>::draw(Generator& generator, double last) {
  for (int i = 0; i < layers(); ++i) {
    auto drawn = weights(i);
    const double variance = i + 1 == layers() ? last * last : 2.0;
    const double size = std::sqrt(variance / static_cast<double>(drawn.cols()));
    for (Scalar& weight : drawn.reshaped()) weight = static_cast<Scalar>(size * generator.normal());
    bias(i).setZero();
  }
}

template <typename Scalar>
Eigen::Map<typename Network<Scalar>::Matrix> Network<Scalar>::weights(int layer) {
  const auto at = static_cast<std::size_t>(layer);
  return {parameters_.data() + starts_[at], shape_.widths[at + 1], shape_.widths[at]};
}

template <typename Scalar>
Eigen::Map<const typename Network<Scalar>::Matrix> Network<Scalar>::weights(int layer) const {
  const auto at = static_cast<std::size_t>(layer);
  return {parameters_.data() + starts_[at], shape_.widths[at + 1], shape_.widths[at]};
}

template <typename Scalar>
Eigen::Map<typename Network<Scalar>::Vector> Network<Scalar>::bias(int layer) {
  const auto at = static_cast<std::size_t>(layer);
  return {parameters_.data() + starts_[at + 1] - shape_.widths[at + 1], shape_.widths[at + 1]};
}

template <typename Scalar>
Eigen::Map<const typename Network<Scalar>::Vector> Network<Scalar>::bias(int layer) const {
  const auto at = static_cast<std::size_t>(layer);
  return {parameters_.data() + starts_[at + 1] - shape_.widths[at + 1], shape_.widths[at + 1]};
}

template <typename Scalar>
const typename Network<Scalar>::Matrix& Network<Scalar>::evaluate(Pass& pass) const {
  pass.values.resize(static_cast<std::size_t>(layers()));
  for (int i = 0; i < layers(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    Matrix& values = pass.values[at];
    multiply(weights(i), i == 0 ? pass.inputs : pass.values[at - 1], values);
    values.colwise() += bias(i);
    if (i + 1 < layers()) activate(shape_.hidden, values);
  }
  return pass.values.back();
}

template <typename Scalar>
void Network<Scalar>::add_gradient(const Inputs& output_errors, Pass& pass,
                                   Vector& gradient) const {
  pass.errors.resize(static_cast<std::size_t>(layers()));
  pass.errors.back() = output_errors;
  for (int i = layers() - 1; i >= 0; --i) {
    const auto at = static_cast<std::size_t>(i);
    const Matrix& below = i == 0 ? pass.inputs : pass.values[at - 1];
    multiply_right_transposed(pass.errors[at], below, pass.product);
    gradient.segment(starts_[at], pass.product.size()) += pass.product.reshaped();
    gradient.segment(starts_[at + 1] - outputs_of(i), outputs_of(i)) +=
        pass.errors[at].rowwise().sum();
    if (i == 0) break;
    multiply_left_transposed(weights(i), pass.errors[at], pass.errors[at - 1]);
    multiply_by_slopes(shape_.hidden, below, pass.errors[at - 1]);
  }
}

template <typename Scalar>
std::vector<Layer> Network<Scalar>::as_layers() const {
  std::vector<Layer> all;
  for (int i = 0; i < layers(); ++i) {
    const bool is_last = i + 1 == layers();
    all.push_back({weights(i).template cast<double>(), bias(i).template cast<double>(),
                   is_last ? activation_of(ActivationKind::kIdentity) : shape_.hidden});
  }
  return all;
}

template class Network<float>;
template class Network<double>;

}  // namespace torquewright::learning
