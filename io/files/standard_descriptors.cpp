// SPDX-License-Identifier: Apache-2.0
#include "io/files/standard_descriptors.hpp"

#include <fcntl.h>
#include <unistd.h>

namespace torquewright::io {

void fill_standard_descriptors() {
  // The other way round for stdin and stdout: what uses them is told that they are not there.
  constexpr int kModes[] = {O_WRONLY, O_RDONLY, O_WRONLY};
  for (int descriptor = STDIN_FILENO; descriptor <= STDERR_FILENO; ++descriptor) {
    if (::fcntl(descriptor, F_GETFD) >= 0) continue;
    ::open("/dev/null", kModes[descriptor]);  // takes the lowest that is free: this one
  }
}

}  // namespace torquewright::io
