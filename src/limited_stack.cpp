// SPDX-License-Identifier: Apache-2.0
#include "src/limited_stack.hpp"

#include <sys/resource.h>

namespace torquewright::cli {
namespace {

/// Plans take 512 to 768 KiB, the most of all commands.
constexpr rlim_t kNeededStack_bytes = rlim_t{1} << 20;

}  // namespace

std::string_view stack_complaint() {
  rlimit limits{};
  const bool is_enough =
      ::getrlimit(RLIMIT_STACK, &limits) != 0 || limits.rlim_cur >= kNeededStack_bytes;
  return is_enough ? "" : "ulimit -s: leaves less than 1024 KiB, too little; 8192 is usual\n";
}

}  // namespace torquewright::cli
