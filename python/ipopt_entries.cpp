// SPDX-License-Identifier: Apache-2.0
#include "python/ipopt_entries.hpp"

extern "C" __attribute__((visibility("default"))) const void* torquewright_ipopt() {
  using namespace torquewright;
  static constexpr python::IpoptEntries entries{optimization::run_ipopt, optimization::solve};
  return &entries;
}
