// SPDX-License-Identifier: Apache-2.0
// A system that starts no further process (`ulimit -u` binds everybody but root). Loaded into the
// program by the dynamic linker's LD_PRELOAD.
#include <spawn.h>

#include <cerrno>

extern "C" int posix_spawn(pid_t*, const char*, const posix_spawn_file_actions_t*,
                           const posix_spawnattr_t*, char* const*, char* const*) noexcept {
  return EAGAIN;
}

extern "C" int posix_spawnp(pid_t*, const char*, const posix_spawn_file_actions_t*,
                            const posix_spawnattr_t*, char* const*, char* const*) noexcept {
  return EAGAIN;
}
