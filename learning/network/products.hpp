// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace torquewright::learning {

using FloatMatrix = Eigen::MatrixXf;
using FloatBlock = Eigen::Ref<const Eigen::MatrixXf, 0, Eigen::OuterStride<>>;

/// The three products that a layer needs, of any sizes that fit. Each entry is the sum of its terms
/// in their order, so that it does not depend on what stands beside it; with fused products where
/// the processor has them. Some two and a half times as fast there as Eigen in a program for all
/// processors, which may not use their wide registers (bench/learning).
void multiply(const FloatBlock& a, const FloatBlock& b, FloatMatrix& product);  ///< a b
void multiply_left_transposed(const FloatBlock& a, const FloatBlock& b,
                              FloatMatrix& product);  ///< a' b
void multiply_right_transposed(const FloatBlock& a, const FloatBlock& b,
                               FloatMatrix& product);  ///< a b'

/// The same with double numbers, by Eigen: for tests of derivatives.
void multiply(const Eigen::Ref<const Eigen::MatrixXd>& a,
              const Eigen::Ref<const Eigen::MatrixXd>& b, Eigen::MatrixXd& product);
void multiply_left_transposed(const Eigen::Ref<const Eigen::MatrixXd>& a,
                              const Eigen::Ref<const Eigen::MatrixXd>& b, Eigen::MatrixXd& product);
void multiply_right_transposed(const Eigen::Ref<const Eigen::MatrixXd>& a,
                               const Eigen::Ref<const Eigen::MatrixXd>& b,
                               Eigen::MatrixXd& product);

}  // namespace torquewright::learning
