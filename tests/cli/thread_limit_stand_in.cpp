// SPDX-License-Identifier: Apache-2.0
// A system that allows a process two threads more (`ulimit -u` binds everybody but root). Loaded
// into the program by the dynamic linker's LD_PRELOAD.
#include <dlfcn.h>
#include <pthread.h>

#include <atomic>
#include <cerrno>

namespace {

using Start = void* (*)(void*);
using Create = int (*)(pthread_t*, const pthread_attr_t*, Start, void*);

std::atomic<int> left{2};

}  // namespace

extern "C" int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, Start start,
                              void* argument) noexcept {
  static const auto create = reinterpret_cast<Create>(::dlsym(RTLD_NEXT, "pthread_create"));
  return left-- > 0 ? create(thread, attributes, start, argument) : EAGAIN;
}
