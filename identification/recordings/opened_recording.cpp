// SPDX-License-Identifier: Apache-2.0
#include "identification/recordings/opened_recording.hpp"

#include "identification/recordings/mcap.hpp"
#include "identification/recordings/sqlite_bag.hpp"
#include "io/faults/refusal.hpp"
#include "io/files/foreign_format.hpp"
#include "io/files/plain_bytes.hpp"

namespace torquewright::identification {

std::unique_ptr<Recording> open_recording(const std::filesystem::path& file) {
  const io::PlainBytes bytes(file);
  const std::string_view first = bytes.first_bytes();
  if (begins_as_mcap(first)) return open_mcap(file);
  if (begins_as_sqlite(first)) return open_sqlite_bag(file);
  const std::string other = io::foreign_format(first);
  io::refuse(file.string(), other.empty() ? "is no recording: neither MCAP nor a database of ROS 2"
                                          : "is no recording of ROS 2 but " + other);
}

}  // namespace torquewright::identification
