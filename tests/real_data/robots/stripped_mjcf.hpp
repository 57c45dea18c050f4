// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace torquewright::test {

/// An MJCF file's text with its includes in place and without what needs other files or a newer
/// MuJoCo than 2.2.2 and moves nothing: pictures, meshes, sensors, actuators, sites, constraints.
/// By tinyxml2 alone: an oracle's input, apart from our reader. std::runtime_error where a file is
/// not there.
std::string stripped_mjcf(const std::filesystem::path& file);

}  // namespace torquewright::test
