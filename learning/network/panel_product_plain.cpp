// SPDX-License-Identifier: Apache-2.0
#include "learning/network/panel_kernel.hpp"

namespace torquewright::learning {

PanelProduct plain_product() {
  using Kernel = PanelKernel<4, 2, 4>;
  return {Kernel::kRows, 4, Kernel::multiply};
}

}  // namespace torquewright::learning
