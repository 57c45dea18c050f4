// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace torquewright::learning {

/// Two matrices cut into panels, of which the last may be filled up with zeros:
///
///   left:  panels of `left_rows` rows, each holding its entries column by column,
///   right: panels of `right_columns` columns, each holding its entries row by row.
struct Panels {
  const float* left;
  const float* right;
  int rows, columns, inner;  ///< Of the product, and the length of its sums.
  float* product;            ///< Column by column,
  int stride;                ///< which stand so far apart.
};

/// A product of panels for one kind of processor, and the panels that it wants.
struct PanelProduct {
  int left_rows;
  int right_columns;
  void (*multiply)(const Panels&);
};

PanelProduct plain_product();
PanelProduct avx2_product();    ///< Only where the processor has AVX2 and FMA.
PanelProduct avx512_product();  ///< Only where it has AVX-512 F.

}  // namespace torquewright::learning
