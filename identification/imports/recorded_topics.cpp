// SPDX-License-Identifier: Apache-2.0
#include "identification/imports/recorded_topics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <tuple>

#include "identification/recordings/joint_state_reader.hpp"
#include "identification/recordings/opened_recording.hpp"
#include "io/faults/refusal.hpp"
#include "io/text/one_line.hpp"

namespace torquewright::identification::imports {
namespace {

namespace fs = std::filesystem;

/// bag_2.mcap lies before bag_10.mcap: by the number at the end of the name.
std::tuple<std::string, std::size_t> order_of(const fs::path& file) {
  const std::string stem = io::stem_in_text(file);
  const std::size_t digits = stem.find_last_not_of("0123456789") + 1;
  std::size_t number = 0;
  std::from_chars(stem.data() + digits, stem.data() + stem.size(), number);
  return {stem.substr(0, digits), number};
}

RecordedRun run_of_folder(const fs::path& folder) {
  RecordedRun run{io::stem_in_text(folder.has_filename() ? folder : folder.parent_path()), {}};
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const fs::path ending = entry.path().extension();
    if (ending == ".mcap" || ending == ".db3") run.files.push_back(entry.path());
  }
  if (run.files.empty()) {
    io::refuse(folder.string(), "is a folder without recordings (.mcap, .db3)");
  }
  std::sort(run.files.begin(), run.files.end(),
            [](const fs::path& a, const fs::path& b) { return order_of(a) < order_of(b); });
  return run;
}

double value_at(const std::vector<double>& values, std::size_t place) {
  return place < values.size() ? values[place] : std::nan("");
}

class Survey {
 public:
  void add(const fs::path& file) {
    const std::unique_ptr<Recording> recording = open_recording(file);
    for_each_joint_state(
        *recording, file.string(), [](const std::string&) { return true; },
        [&](const std::string& topic, std::int64_t, const JointState& state) {
          add(topics_.of_joints[topic], state);
        });
    for (const Topic& topic : recording->topics()) {
      if (!is_joint_state(topic.type)) topics_.others[topic.name] = topic.type;
    }
    const std::string cut = recording->cut_end();
    if (!cut.empty()) topics_.notes.push_back(fmt::format("{} {}", file.string(), cut));
  }
  RecordedTopics taken() { return std::move(topics_); }

 private:
  static void add(TopicContents& topic, const JointState& state) {
    ++topic.messages;
    topic.unstamped += state.stamp_ns == 0;
    for (std::size_t i = 0; i < state.names.size(); ++i) {
      TopicContents::Joint& joint = joint_named(topic, state.names[i], i);
      ++joint.messages;
      joint.positions += std::isfinite(value_at(state.position, i));
      joint.velocities += std::isfinite(value_at(state.velocity, i));
      joint.efforts += std::isfinite(value_at(state.effort, i));
    }
  }

  /// Most messages have the joints in one order.
  static TopicContents::Joint& joint_named(TopicContents& topic, const std::string& name,
                                           std::size_t place) {
    if (place < topic.joints.size() && topic.joints[place].name == name) return topic.joints[place];
    for (TopicContents::Joint& joint : topic.joints) {
      if (joint.name == name) return joint;
    }
    topic.joints.push_back({name});
    return topic.joints.back();
  }

  RecordedTopics topics_;
};

}  // namespace

std::vector<RecordedRun> recorded_runs(const std::vector<fs::path>& named) {
  std::vector<RecordedRun> runs;
  for (const fs::path& path : named) {
    std::error_code unknown;
    runs.push_back(fs::is_directory(path, unknown) ? run_of_folder(path)
                                                   : RecordedRun{io::stem_in_text(path), {path}});
  }
  return runs;
}

void for_each_joint_state(
    Recording& recording, const std::string& file,
    const std::function<bool(const std::string& topic)>& wants,
    const std::function<void(const std::string& topic, std::int64_t recorded_ns,
                             const JointState& state)>& take) {
  RecordedMessage message;
  JointState state;
  while (recording.next(message)) {
    const Topic& topic = recording.topics()[message.topic];
    if (!is_joint_state(topic.type) || !wants(topic.name)) continue;
    const std::string wrong = read_joint_state(topic.encoding, message.bytes, state);
    if (!wrong.empty()) {
      io::refuse(file, fmt::format("a message of {}, recorded at {} ns, {}", topic.name,
                                   message.recorded_ns, wrong));
    }
    take(topic.name, message.recorded_ns, state);
  }
}

RecordedTopics topics_of(const std::vector<RecordedRun>& runs) {
  Survey survey;
  for (const RecordedRun& run : runs) {
    for (const fs::path& file : run.files) survey.add(file);
  }
  return survey.taken();
}

}  // namespace torquewright::identification::imports
