// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace torquewright::gearbox {

// The formulas of this folder are templates over a scalar T: double here, a node of an expression
// in the search. A template calls these by their plain names, so that for another T its own
// namespace answers. Roots and angles come from <cmath> by a using-declaration in the function.

inline double square(double x) { return x * x; }
inline double min(double a, double b) { return b < a ? b : a; }
inline double max(double a, double b) { return a < b ? b : a; }

}  // namespace torquewright::gearbox
