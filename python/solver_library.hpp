// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace torquewright::python {

/// A shared library of ours beside this one, with a solver of other people's in it: this one can be
/// loaded where that solver is not installed.
struct SolverLibrary {
  const void* entries = nullptr;  ///< What its one function returned; null: it cannot be loaded.
  std::string absence;            ///< Why not, in the dynamic linker's words.
};

/// Loads the library of that file name and asks its function of that name.
SolverLibrary load_solver(const char* file, const char* function);

}  // namespace torquewright::python
