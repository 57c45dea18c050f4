// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "hopper/policy/policy_document.hpp"

namespace torquewright::hopper {

/// The policy as a header of C99 and C++ that needs no library but, for ELU and tanh, <math.h>:
/// `policy_action` and `policy_target`, in floats. `origin` are the lines that head it. Requires a
/// document without objection.
std::string c_source_of(const PolicyDocument& document, const std::vector<std::string>& origin);

}  // namespace torquewright::hopper
