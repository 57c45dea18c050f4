// SPDX-License-Identifier: Apache-2.0
// OpenBLAS, which a system may have put behind Ipopt, takes buffers of 128 MiB for each of its
// threads and asks for it again without end where there is no room: before main, within a search,
// or at the program's end. So in an address space that is limited (`ulimit -v`) it gets one thread,
// and where one has no room the program says so. This runs before the libraries begin, so it uses
// none of theirs that has a beginning of its own.
#include <link.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "io/files/direct_output.hpp"
#include "io/files/own_arguments.hpp"
#include "src/exit_code.hpp"

namespace torquewright::cli {
namespace {

/// Two buffers, which is what one thread of its OpenMP variant takes, and a quarter more for the
/// program's own.
constexpr std::size_t kNeeded_bytes = std::size_t{320} << 20;
constexpr std::string_view kTooSmall =
    "ulimit -v: leaves less than 320 MiB beside the program, too little for OpenBLAS, its linear "
    "algebra; raise it, or make another BLAS the system's\n";

constexpr std::array<std::string_view, 2> kOneThread{"OPENBLAS_NUM_THREADS=1", "OMP_NUM_THREADS=1"};

bool is_limited() {
  rlimit limits{};
  return ::getrlimit(RLIMIT_AS, &limits) == 0 && limits.rlim_cur != RLIM_INFINITY;
}

int is_openblas(dl_phdr_info* library, std::size_t, void*) {
  return std::strstr(library->dlpi_name, "openblas") == nullptr ? 0 : 1;
}

bool has_room() {
  void* room =
      ::mmap(nullptr, kNeeded_bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  return room != MAP_FAILED && ::munmap(room, kNeeded_bytes) == 0;
}

bool holds(char* const* variables, std::string_view wanted) {
  for (; *variables != nullptr; ++variables) {
    if (*variables == wanted) return true;
  }
  return false;
}

/// Of the same variable as one of kOneThread.
bool is_superseded(std::string_view variable) {
  for (const std::string_view one : kOneThread) {
    if (variable.starts_with(one.substr(0, one.find('=') + 1))) return true;
  }
  return false;
}

/// What the C library is about to take as its environment cannot be added to: it is changed by a
/// new start.
void start_again(char* const* variables) {
  std::vector<char*> changed;
  for (; *variables != nullptr; ++variables) {
    if (!is_superseded(*variables)) changed.push_back(*variables);
  }
  for (const std::string_view one : kOneThread) changed.push_back(const_cast<char*>(one.data()));
  changed.push_back(nullptr);
  std::vector<std::string> words = io::own_arguments();
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  // Where it fails: as it is.
  ::execve("/proc/self/exe", arguments.data(), changed.data());
}

void fit_openblas(int, char**, char** variables) {
  if (!is_limited() || ::dl_iterate_phdr(is_openblas, nullptr) == 0) return;
  if (!has_room()) {
    io::write_all(STDERR_FILENO, kTooSmall);
    ::_exit(static_cast<int>(ExitCode::kBadInput));
  }
  for (const std::string_view one : kOneThread) {
    if (!holds(variables, one)) return start_again(variables);
  }
}

[[gnu::section(".preinit_array"), gnu::used]] void (*const before_libraries)(int, char**,
                                                                             char**) = fit_openblas;

}  // namespace
}  // namespace torquewright::cli
