// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "learning/network/panel_product.hpp"

// Included by one file for each kind of processor, which is compiled for it: so nothing here may be
// shared with other files, not even a function of the library, or the linker may give other
// processors these instructions.
namespace torquewright::learning {
namespace {

/// Sums of products of a panel's columns and a panel's rows, `kVectors` vectors of `kWidth` numbers
/// high and `kColumns` wide. They stay in registers.
template <int kWidth, int kVectors, int kColumns>
struct PanelKernel {
  typedef float Vector __attribute__((vector_size(kWidth * 4), aligned(4)));
  static constexpr int kRows = kWidth * kVectors;

  static void store(const Vector (&sums)[kColumns][kVectors], int rows, int columns, float* product,
                    int stride) {
    if (rows == kRows && columns == kColumns) {
      for (int j = 0; j < kColumns; ++j) {
        for (int v = 0; v < kVectors; ++v) {
          *reinterpret_cast<Vector*>(product + j * stride + v * kWidth) = sums[j][v];
        }
      }
      return;
    }
    for (int j = 0; j < columns; ++j) {
      for (int i = 0; i < rows; ++i) product[j * stride + i] = sums[j][i / kWidth][i % kWidth];
    }
  }

  static void multiply_tile(const float* left, const float* right, int inner, int rows, int columns,
                            float* product, int stride) {
    Vector sums[kColumns][kVectors] = {};
    for (int k = 0; k < inner; ++k, left += kRows, right += kColumns) {
      Vector column[kVectors];
      for (int v = 0; v < kVectors; ++v) {
        column[v] = *reinterpret_cast<const Vector*>(left + v * kWidth);
      }
#pragma GCC unroll 16
      for (int j = 0; j < kColumns; ++j) {
#pragma GCC unroll 4
        for (int v = 0; v < kVectors; ++v) sums[j][v] += column[v] * right[j];
      }
    }
    store(sums, rows, columns, product, stride);
  }

  static void multiply(const Panels& panels) {
    const auto rest = [](int of, int at, int most) { return of - at < most ? of - at : most; };
    for (int j = 0; j < panels.columns; j += kColumns) {
      const float* right = panels.right + static_cast<long>(j) * panels.inner;
      for (int i = 0; i < panels.rows; i += kRows) {
        multiply_tile(panels.left + static_cast<long>(i) * panels.inner, right, panels.inner,
                      rest(panels.rows, i, kRows), rest(panels.columns, j, kColumns),
                      panels.product + static_cast<long>(j) * panels.stride + i, panels.stride);
      }
    }
  }
};

}  // namespace
}  // namespace torquewright::learning
