// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "robot/draft/draft.hpp"
#include "robot/draft/import_options.hpp"

namespace torquewright::hopper {

/// The contact points of what a user named: of a link the sole that is stated, else what its shapes
/// that collide touch with, else its origin; of a geom the same; of a site its place. Notes say
/// what was taken. io::SpecError where a name fits nothing, where all that it fits are meshes that
/// are not there, or where the base does not float. Requires that no draft is welded.
void add_named_feet(const std::vector<DraftBody>& draft, const std::vector<NamedFeet>& named,
                    Robot& robot, std::vector<std::string>& notes);

}  // namespace torquewright::hopper
