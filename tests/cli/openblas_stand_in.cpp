// SPDX-License-Identifier: Apache-2.0
// What OpenBLAS 0.3.21 does when it is loaded, as far as memory goes: a buffer of 128 MiB for each
// of its threads, asked for without end. Loaded into the program by the dynamic linker's
// LD_PRELOAD.
#include <sys/mman.h>
#include <time.h>

#include <cstddef>
#include <cstdlib>
#include <cstring>

namespace {

constexpr std::size_t kBuffer_bytes = std::size_t{128} << 20;
constexpr int kBuffersOfAThread = 2;
constexpr int kProcessors = 2;

bool is_one(const char* variable) {
  const char* text = std::getenv(variable);
  return text != nullptr && std::strcmp(text, "1") == 0;
}

void take_buffer() {
  while (::mmap(nullptr, kBuffer_bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1,
                0) == MAP_FAILED) {
    const timespec moment{0, 1'000'000};
    ::nanosleep(&moment, nullptr);  // which OpenBLAS does not
  }
}

[[gnu::constructor]] void begin() {
  const bool is_alone = is_one("OPENBLAS_NUM_THREADS") && is_one("OMP_NUM_THREADS");
  const int threads = is_alone ? 1 : kProcessors;
  for (int i = 0; i < kBuffersOfAThread * threads; ++i) take_buffer();
}

}  // namespace
