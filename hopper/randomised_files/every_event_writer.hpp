// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/randomised_files/event_writer.hpp"

// One line for each simulator; its file defines the constant of that name.
#define TORQUEWRIGHT_EVERY_EVENT_WRITER(writer)                                                 \
  writer(isaac_lab_events) writer(mjlab_events) writer(playground_events) writer(newton_events) \
      writer(genesis_events)

namespace torquewright::hopper::event_writers {

#define TORQUEWRIGHT_DECLARE(name) extern const EventWriter name;
TORQUEWRIGHT_EVERY_EVENT_WRITER(TORQUEWRIGHT_DECLARE)
#undef TORQUEWRIGHT_DECLARE

}  // namespace torquewright::hopper::event_writers
