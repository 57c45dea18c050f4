// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace torquewright::identification {

/// A topic of a recording of ROS 2: what its messages are and how they are written.
struct Topic {
  std::string name;      ///< "/joint_states".
  std::string type;      ///< "sensor_msgs/msg/JointState"; empty where the file does not say it.
  std::string encoding;  ///< "cdr" or "json", or another that the file names.
};

/// A message as it stands in the recording.
struct RecordedMessage {
  std::size_t topic = 0;         ///< Index of Recording::topics().
  std::int64_t recorded_ns = 0;  ///< When, by the recorder's clock.
  std::string_view bytes;        ///< Valid until the next message is asked for.
};

/// A recording, message by message in the order in which they came, in flat memory.
class Recording {
 public:
  Recording() = default;
  virtual ~Recording() = default;
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;

  /// False at the end. Throws io::SpecError where the file is damaged or holds what is not read, as
  /// another compression.
  virtual bool next(RecordedMessage& message) = 0;
  /// Those that the messages so far, and what stood before them, have named.
  virtual const std::vector<Topic>& topics() const = 0;
  /// A sentence where the file ends within a message, which is left out; else empty.
  virtual std::string cut_end() const { return ""; }
};

}  // namespace torquewright::identification
