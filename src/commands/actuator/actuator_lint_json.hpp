// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>

#include "actuator/lint/examination.hpp"
#include "actuator/winding/winding_estimate.hpp"
#include "io/documents/document.hpp"

namespace torquewright::cli {

/// The lint_report as a text, with the winding behind a curve where it was asked for.
std::string lint_document(const actuator::lint::Report& report,
                          const std::optional<actuator::WindingEstimate>& winding,
                          std::span<const io::Document> documents);

}  // namespace torquewright::cli
