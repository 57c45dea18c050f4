// SPDX-License-Identifier: Apache-2.0
#include "python/solver_library.hpp"

#include <dlfcn.h>

#include <filesystem>

namespace torquewright::python {
namespace {

/// Where this library lies.
std::filesystem::path own_folder() {
  static const char here = 0;
  Dl_info own{};
  if (::dladdr(&here, &own) == 0 || own.dli_fname == nullptr) return {};
  return std::filesystem::path(own.dli_fname).parent_path();
}

std::string why_not() {
  const char* reason = ::dlerror();
  return reason == nullptr ? "the dynamic linker does not say why" : reason;
}

}  // namespace

SolverLibrary load_solver(const char* file, const char* function) {
  void* library = ::dlopen((own_folder() / file).c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) return {nullptr, why_not()};
  void* symbol = ::dlsym(library, function);
  if (symbol == nullptr) return {nullptr, why_not()};
  using Entries = const void* (*)();
  return {reinterpret_cast<Entries>(symbol)(), {}};
}

}  // namespace torquewright::python
