// SPDX-License-Identifier: Apache-2.0
#include "io/table_forms/matio_library.hpp"

#include <dlfcn.h>

#include <optional>

#include "io/faults/refusal.hpp"

namespace torquewright::io {
namespace {

constexpr const char* kSharedObject = "libmatio.so.11";

template <class Function>
bool find(void* library, const char* name, Function& function) {
  function = reinterpret_cast<Function>(::dlsym(library, name));
  return function != nullptr;
}

std::optional<MatioLibrary> loaded() {
  void* const library = ::dlopen(kSharedObject, RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) return std::nullopt;
  MatioLibrary matio;
  const bool is_whole = find(library, "Mat_Open", matio.open) &&
                        find(library, "Mat_Close", matio.close) &&
                        find(library, "Mat_VarReadNext", matio.read_next) &&
                        find(library, "Mat_VarFree", matio.free) &&
                        find(library, "Mat_VarGetNumberOfFields", matio.count_fields) &&
                        find(library, "Mat_VarGetStructFieldnames", matio.field_names) &&
                        find(library, "Mat_VarGetStructFieldByIndex", matio.field);
  return is_whole ? std::optional(matio) : std::nullopt;
}

}  // namespace

const MatioLibrary& matio_library(const std::string& file) {
  static const std::optional<MatioLibrary> kLibrary = loaded();
  if (kLibrary) return *kLibrary;
  refuse(file,
         "is a MATLAB file, and the library that reads it is not installed: apt-get install "
         "libmatio11; or in MATLAB writetable(struct2table(load('FILE')), 'FILE.csv')");
}

}  // namespace torquewright::io
