// SPDX-License-Identifier: Apache-2.0
#include "src/sweep/ranks.hpp"

#include <fmt/format.h>

#include <cstdlib>

#include "io/faults/refusal.hpp"

namespace torquewright::sweep {
namespace {

std::size_t number_of(const char* variable, std::size_t otherwise) {
  const char* text = std::getenv(variable);
  return text == nullptr ? otherwise : std::strtoul(text, nullptr, 10);
}

}  // namespace

Ranks ranks_by_environment() {
  Ranks ranks{number_of("OMPI_COMM_WORLD_SIZE", 1), number_of("OMPI_COMM_WORLD_RANK", 0), ""};
  if (ranks.count < 2) return ranks;
  const char* job = std::getenv("OMPI_MCA_ess_base_jobid");
  ranks.run = fmt::format("mpirun {}", job == nullptr ? "" : job);
  return ranks;
}

void require_possible(const Ranks& ranks) {
  if (ranks.own < ranks.count) return;
  io::refuse(
      "OMPI_COMM_WORLD_RANK",
      fmt::format("{} is not one of the {} ranks that OMPI_COMM_WORLD_SIZE states; unset both, "
                  "or start with mpirun",
                  ranks.own, ranks.count));
}

}  // namespace torquewright::sweep
