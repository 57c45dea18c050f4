// SPDX-License-Identifier: Apache-2.0
#include "src/loudness.hpp"

namespace torquewright::cli {

Loudness& loudness() {
  static Loudness now;
  return now;
}

}  // namespace torquewright::cli
