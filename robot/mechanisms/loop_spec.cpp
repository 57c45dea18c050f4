// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "robot/mechanisms/every_mechanism.hpp"
#include "robot/mechanisms/loop.hpp"
#include "robot/mechanisms/loop_geometry_spec.hpp"

namespace torquewright::hopper {
namespace {

constexpr std::string_view kNeeds[] = {"links", "closures", "turned"};

std::shared_ptr<const Mechanism> read(const MechanismKeys& keys) {
  auto geometry = read_loop_geometry(keys);
  return geometry ? std::make_shared<Loop>(*std::move(geometry)) : nullptr;
}

nlohmann::ordered_json write(const Mechanism& mechanism) {
  return loop_geometry_keys(dynamic_cast<const Loop&>(mechanism).geometry());
}

}  // namespace

namespace mechanisms {

const MechanismType loop = {
    .name = "loop", .joints = 0, .needs = kNeeds, .may_state = {}, .read = read, .write = write};

}  // namespace mechanisms
}  // namespace torquewright::hopper
