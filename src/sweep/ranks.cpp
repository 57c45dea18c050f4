// SPDX-License-Identifier: Apache-2.0
#include "src/sweep/ranks.hpp"

#include <cstdlib>

namespace torquewright::sweep {
namespace {

std::size_t number_of(const char* variable, std::size_t otherwise) {
  const char* text = std::getenv(variable);
  return text == nullptr ? otherwise : std::strtoul(text, nullptr, 10);
}

}  // namespace

Ranks ranks_by_environment() {
  return {number_of("OMPI_COMM_WORLD_SIZE", 1), number_of("OMPI_COMM_WORLD_RANK", 0)};
}

}  // namespace torquewright::sweep
