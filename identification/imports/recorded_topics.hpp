// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "identification/recordings/joint_state.hpp"
#include "identification/recordings/recording.hpp"

namespace torquewright::identification::imports {

/// What all messages of a topic of joint states hold.
struct TopicContents {
  std::size_t messages = 0;
  std::size_t unstamped = 0;  ///< Messages whose sender did not say when.
  /// Joints by how many messages have a number of each, in the order of their first message.
  struct Joint {
    std::string name;
    std::size_t messages = 0, positions = 0, velocities = 0, efforts = 0;
  };
  std::vector<Joint> joints;
};

/// What recordings hold: topics of joint states by name, and all others.
struct RecordedTopics {
  std::map<std::string, TopicContents> of_joints;
  std::map<std::string, std::string> others;  ///< Their type, by name.
  std::vector<std::string> notes;             ///< Sentences for the user.
};

/// A run: files that follow one another.
struct RecordedRun {
  std::string name;
  std::vector<std::filesystem::path> files;
};

/// The runs of what a user names: files, and folders of them. Throws io::SpecError for a folder
/// without recordings.
std::vector<RecordedRun> recorded_runs(const std::vector<std::filesystem::path>& named);

/// Gives each message of joint states of a recording that `wants` a topic of, in order. Throws
/// io::SpecError where one cannot be read.
void for_each_joint_state(
    Recording& recording, const std::string& file,
    const std::function<bool(const std::string& topic)>& wants,
    const std::function<void(const std::string& topic, std::int64_t recorded_ns,
                             const JointState& state)>& take);

/// Reads all of the files for what they hold.
RecordedTopics topics_of(const std::vector<RecordedRun>& runs);

}  // namespace torquewright::identification::imports
