// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "learning/generator.hpp"
#include "learning/network/activation.hpp"
#include "learning/network/policy.hpp"

namespace torquewright::learning {

/// Numbers from layer to layer, inputs first; the last layer has no activation.
struct NetworkShape {
  std::vector<int> widths;  ///< At least two.
  Activation hidden;        ///< alpha is not negative.
};

/// A fully connected network for many inputs at once (columns of matrices), with exact gradients.
/// Learned with float, as fast as the processor can; derivatives are tested with double.
template <typename Scalar>
class Network {
 public:
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
  using Inputs = Eigen::Ref<const Matrix, 0, Eigen::OuterStride<>>;

  /// What one evaluation leaves behind for its gradient. One object serves one thread at a time;
  /// it keeps its memory.
  struct Pass {
    Matrix inputs;
    std::vector<Matrix> values;  ///< Of each layer, (outputs x samples).
    std::vector<Matrix> errors;  ///< Derivatives with respect to what stands before the activation.
    Matrix product;
  };

  /// All parameters zero.
  explicit Network(NetworkShape shape);

  /// Draws weights of variance 2 / inputs (He et al. 2015), of the last layer last^2 / inputs, and
  /// sets biases to zero.
  void draw(Generator& generator, double last);

  int inputs() const { return shape_.widths.front(); }
  int outputs() const { return shape_.widths.back(); }
  int layers() const { return static_cast<int>(shape_.widths.size()) - 1; }
  int outputs_of(int layer) const { return shape_.widths[static_cast<std::size_t>(layer) + 1]; }

  /// Layer by layer the weights, column by column, then the bias.
  Vector& parameters() { return parameters_; }
  const Vector& parameters() const { return parameters_; }

  Eigen::Map<Matrix> weights(int layer);
  Eigen::Map<const Matrix> weights(int layer) const;
  Eigen::Map<Vector> bias(int layer);
  Eigen::Map<const Vector> bias(int layer) const;

  /// The outputs (outputs x samples) of pass.inputs (inputs x samples).
  const Matrix& evaluate(Pass& pass) const;

  /// After evaluate(): adds to `gradient` that of a loss with respect to the parameters, where
  /// `output_errors` is its derivative with respect to the outputs.
  void add_gradient(const Inputs& output_errors, Pass& pass, Vector& gradient) const;

  /// As it is used once it is learned.
  std::vector<Layer> as_layers() const;

 private:
  NetworkShape shape_;
  std::vector<Eigen::Index> starts_;  // of each layer in parameters_, and their end
  Vector parameters_;
};

extern template class Network<float>;
extern template class Network<double>;

}  // namespace torquewright::learning
