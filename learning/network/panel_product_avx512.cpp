// SPDX-License-Identifier: Apache-2.0
#include "learning/network/panel_kernel.hpp"

namespace torquewright::learning {

PanelProduct avx512_product() {
  using Kernel = PanelKernel<16, 2, 12>;
  return {Kernel::kRows, 12, Kernel::multiply};
}

}  // namespace torquewright::learning
