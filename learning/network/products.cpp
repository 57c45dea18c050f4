// SPDX-License-Identifier: Apache-2.0
#include "learning/network/products.hpp"

#include <algorithm>
#include <vector>

#include "learning/network/panel_product.hpp"

namespace torquewright::learning {
namespace {

PanelProduct product_of_this_processor() {
#if defined(TORQUEWRIGHT_WIDE_PRODUCTS)
  if (__builtin_cpu_supports("avx512f")) return avx512_product();
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return avx2_product();
#endif
  return plain_product();
}

/// A matrix by its entries' places: entry (i, j) is data[i * down + j * across].
struct Strided {
  const float* data;
  Eigen::Index rows, columns;
  Eigen::Index down, across;
};

Strided as_it_is(const FloatBlock& a) { return {a.data(), a.rows(), a.cols(), 1, a.outerStride()}; }

Strided transposed(const FloatBlock& a) {
  return {a.data(), a.cols(), a.rows(), a.outerStride(), 1};
}

/// Writes the columns of a matrix, `width` rows at a time, one panel behind the other.
void write_panels(const Strided& a, Eigen::Index width, std::vector<float>& panels) {
  const Eigen::Index count = (a.rows + width - 1) / width;
  panels.resize(static_cast<std::size_t>(count * width * a.columns));
  float* out = panels.data();
  for (Eigen::Index first = 0; first < a.rows; first += width) {
    const Eigen::Index here = std::min(width, a.rows - first);
    for (Eigen::Index j = 0; j < a.columns; ++j, out += width) {
      const float* in = a.data + first * a.down + j * a.across;
      for (Eigen::Index i = 0; i < here; ++i) out[i] = in[i * a.down];
      std::fill(out + here, out + width, 0.0F);
    }
  }
}

void multiply_strided(const Strided& a, const Strided& b, FloatMatrix& product) {
  static const PanelProduct kProduct = product_of_this_processor();
  thread_local std::vector<float> left;
  thread_local std::vector<float> right;
  product.resize(a.rows, b.columns);
  write_panels(a, kProduct.left_rows, left);
  const Strided turned{b.data, b.columns, b.rows, b.across, b.down};
  write_panels(turned, kProduct.right_columns, right);
  kProduct.multiply({left.data(), right.data(), static_cast<int>(a.rows),
                     static_cast<int>(b.columns), static_cast<int>(a.columns), product.data(),
                     static_cast<int>(a.rows)});
}

}  // namespace

void multiply(const FloatBlock& a, const FloatBlock& b, FloatMatrix& product) {
  multiply_strided(as_it_is(a), as_it_is(b), product);
}

void multiply_left_transposed(const FloatBlock& a, const FloatBlock& b, FloatMatrix& product) {
  multiply_strided(transposed(a), as_it_is(b), product);
}

void multiply_right_transposed(const FloatBlock& a, const FloatBlock& b, FloatMatrix& product) {
  multiply_strided(as_it_is(a), transposed(b), product);
}

void multiply(const Eigen::Ref<const Eigen::MatrixXd>& a,
              const Eigen::Ref<const Eigen::MatrixXd>& b, Eigen::MatrixXd& product) {
  product.noalias() = a * b;
}

void multiply_left_transposed(const Eigen::Ref<const Eigen::MatrixXd>& a,
                              const Eigen::Ref<const Eigen::MatrixXd>& b,
                              Eigen::MatrixXd& product) {
  product.noalias() = a.transpose() * b;
}

void multiply_right_transposed(const Eigen::Ref<const Eigen::MatrixXd>& a,
                               const Eigen::Ref<const Eigen::MatrixXd>& b,
                               Eigen::MatrixXd& product) {
  product.noalias() = a * b.transpose();
}

}  // namespace torquewright::learning
