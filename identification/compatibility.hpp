// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "identification/model.hpp"

namespace torquewright::identification {

/// True if `whole` holds the columns of the effect called `part` as well.
bool contains(const Variant& whole, const std::string& part);

/// True if a variant may stand together with members in one model: no effect twice (waves: no order
/// twice), none beside one that holds it, and no pair that no log can tell apart.
bool is_compatible(const Dictionary& dictionary, const Members& members, std::size_t added,
                   bool target_is_motor_side, bool is_free_load);

}  // namespace torquewright::identification
