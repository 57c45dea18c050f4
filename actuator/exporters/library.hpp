// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "actuator/exporters/exporter.hpp"

namespace torquewright::actuator {

/// Every exporter, in the order of every_exporter.hpp.
std::span<const Exporter* const> exporter_library();

/// The exporter of that name; nullptr if there is none.
const Exporter* find_exporter(std::string_view name);

}  // namespace torquewright::actuator
