// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "robot/draft/draft.hpp"
#include "robot/loops/rod_loop.hpp"
#include "robot/mjcf/mjcf_context.hpp"

namespace torquewright::hopper {

/// Where the bodies and sites of a file are in the drafts that were read.
struct MjcfLandmarks {
  std::map<std::string, DraftPlace> bodies;
  std::map<std::string, dynamics::BodyPoint> sites;

  /// A body whose frame stands so, and the sites that it holds.
  void add(const Element& body, const std::vector<Placed>& held, const DraftPlace& place,
           const MjcfContext& context);
};

/// A <connect>, in drafts without welds: by bodies and the anchor in the first one, which the other
/// has where all bodies stand as the file puts them; or by sites. `merged_places` are those of the
/// drafts as they were read. A fault, and nothing, where an end is no part of the robot. Of one
/// that is_opened() its names alone.
std::optional<Connect> read_connect(const Element& connect, const MjcfLandmarks& landmarks,
                                    const std::vector<DraftPlace>& merged_places,
                                    const std::vector<DraftBody>& draft,
                                    const std::vector<std::string>& opened,
                                    const MjcfContext& context);

}  // namespace torquewright::hopper
