// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "optimization/discrete/relaxation.hpp"
#include "optimization/nonlinear/ipopt_program.hpp"

namespace torquewright::python {

/// What _ipopt.so holds: the functions of optimization/ that Ipopt stands behind.
struct IpoptEntries {
  optimization::SearchEnd (*run)(optimization::Search&);
  optimization::DualPoint (*relax)(const optimization::Relaxation&, double ceiling);
};

}  // namespace torquewright::python
