// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "io/documents/document.hpp"
#include "io/faults/spec_error.hpp"
#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// Adds what stands under "followers" of the document.
void read_followers(const io::Document& document, Robot& robot, std::vector<io::Fault>& faults);

/// One entry of it.
nlohmann::ordered_json follower_json(const Robot& robot, const Follower& follower);

}  // namespace torquewright::hopper
