// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "io/documents/document.hpp"

namespace torquewright::cli {

/// Files that an actuator's document names relative to itself, named from its new place.
void move_actuator(nlohmann::ordered_json& document, const std::filesystem::path& from,
                   const std::filesystem::path& to);

/// Throws io::SpecError where that would leave no text that a document can hold.
void require_movable_actuator(const io::Document& document, const std::filesystem::path& to);

/// The same of a robot's document.
void move_robot(nlohmann::json& document, const std::filesystem::path& from,
                const std::filesystem::path& to);
void move_robot(nlohmann::ordered_json& document, const std::filesystem::path& from,
                const std::filesystem::path& to);

}  // namespace torquewright::cli
