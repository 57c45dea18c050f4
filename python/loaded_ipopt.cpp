// SPDX-License-Identifier: Apache-2.0
// In the place of optimization's ipopt_program.cpp and ipopt_relaxation.cpp, which the linker then
// leaves where they are: Ipopt is loaded when a search first asks for it.
#include <fmt/format.h>

#include "io/faults/refusal.hpp"
#include "python/ipopt_entries.hpp"
#include "python/solver_library.hpp"

namespace torquewright {
namespace {

const python::IpoptEntries& loaded() {
  const python::SolverLibrary library = python::load_solver("_ipopt.so", "torquewright_ipopt");
  if (library.entries == nullptr) {
    io::refuse("Ipopt",
               fmt::format("cannot be loaded ({}); plans of motions and large searches for "
                           "gearboxes need it: install coinor-libipopt1v5 (Debian)",
                           library.absence));
  }
  return *static_cast<const python::IpoptEntries*>(library.entries);
}

/// Where it was refused it is tried anew by the next search.
const python::IpoptEntries& ipopt() {
  static const python::IpoptEntries& entries = loaded();
  return entries;
}

}  // namespace

optimization::SearchEnd optimization::run_ipopt(Search& search) { return ipopt().run(search); }

optimization::DualPoint optimization::solve(const Relaxation& relaxation, double ceiling) {
  return ipopt().relax(relaxation, ceiling);
}

}  // namespace torquewright
