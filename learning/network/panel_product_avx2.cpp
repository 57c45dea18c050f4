// SPDX-License-Identifier: Apache-2.0
#include "learning/network/panel_kernel.hpp"

namespace torquewright::learning {

PanelProduct avx2_product() {
  using Kernel = PanelKernel<8, 2, 6>;
  return {Kernel::kRows, 6, Kernel::multiply};
}

}  // namespace torquewright::learning
