// SPDX-License-Identifier: Apache-2.0
#include "identification/imports/recorded_joints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <memory>
#include <optional>
#include <utility>

#include "identification/imports/recorded_topics.hpp"
#include "identification/recordings/opened_recording.hpp"
#include "io/faults/refusal.hpp"
#include "io/text/name_pattern.hpp"
#include "io/text/nearest.hpp"
#include "io/text/one_line.hpp"
#include "io/text/wording.hpp"

namespace torquewright::identification::imports {
namespace {

constexpr std::int64_t kPerSecond_ns = 1'000'000'000;
/// A recorder's and a sender's clock may drift, and messages wait: a jump of one against the other
/// by more is another clock. A choice of ours.
constexpr std::int64_t kOtherClock_ns = kPerSecond_ns;

using Joint = TopicContents::Joint;

/// What a column holds: a number of a joint, measured or commanded.
struct RecordedColumn {
  std::size_t joint = 0;
  Quantity quantity = Quantity::kOutputPosition;
};

/// What is read of recordings.
struct Choice {
  std::vector<RecordedRun> runs;
  std::string topic, commands;
  bool is_by_stamp = false;
  std::vector<std::string> joints;
  std::vector<RecordedColumn> columns;
};

std::string names_of(const std::map<std::string, TopicContents>& topics) {
  std::vector<std::string> names;
  for (const auto& [name, contents] : topics) names.push_back(name);
  return io::listed(names);
}

std::string listed_others(const std::map<std::string, std::string>& others) {
  std::vector<std::string> named;
  for (const auto& [name, type] : others) named.push_back(fmt::format("{} ({})", name, type));
  return io::listed(named);
}

class Chooser {
 public:
  Chooser(const ImportRequest& request, std::vector<RecordedRun> runs)
      : request_(request), file_(request.files.front().string()), topics_(topics_of(runs)) {
    choice_.runs = std::move(runs);
  }

  Choice choose() {
    choice_.topic = chosen_topic();
    if (!request_.commands.empty()) choice_.commands = asked_topic("--commands", request_.commands);
    choose_clock();
    choose_joints();
    choose_columns();
    return choice_;
  }
  std::vector<std::string> notes() const { return topics_.notes; }

 private:
  const TopicContents& contents() const { return topics_.of_joints.at(choice_.topic); }

  std::string chosen_topic() const {
    if (!request_.topic.empty()) return asked_topic("--topic", request_.topic);
    std::map<std::string, TopicContents> topics = topics_.of_joints;
    topics.erase(request_.commands);
    if (topics.size() == 1) return topics.begin()->first;
    if (topics.empty()) {
      io::refuse(
          file_,
          fmt::format(
              "holds no messages of joint states (sensor_msgs/msg/JointState){}",
              topics_.others.empty() ? "" : "; its topics are " + listed_others(topics_.others)));
    }
    io::refuse(file_, fmt::format("holds several topics of joint states: {}; say --topic for what "
                                  "was measured, and --commands for what was commanded",
                                  names_of(topics)));
  }

  std::string asked_topic(const char* option, const std::string& name) const {
    if (topics_.of_joints.contains(name)) return name;
    if (const auto other = topics_.others.find(name); other != topics_.others.end()) {
      io::refuse(option, fmt::format("{} holds {}, no joint states (sensor_msgs/msg/JointState)",
                                     name, other->second));
    }
    io::refuse(option,
               fmt::format("{} holds no topic {} of joint states; there {} {}", file_, name,
                           topics_.of_joints.size() == 1 ? "is" : "are",
                           topics_.of_joints.empty() ? "none" : names_of(topics_.of_joints)));
  }

  /// Stamps say when something was measured, the recorder's times when it came.
  void choose_clock() {
    const TopicContents& all = contents();
    choice_.is_by_stamp = !request_.by_recorders_clock && all.unstamped == 0;
    if (all.unstamped == 0 || request_.by_recorders_clock) return;
    if (all.unstamped == all.messages) {
      topics_.notes.push_back(fmt::format(
          "messages of {} have no stamp: times are when they came to the recorder", choice_.topic));
      return;
    }
    io::refuse(file_, fmt::format("{} of {} messages of {} have no stamp, so that two clocks would "
                                  "be mixed; --clock recorder takes the recorder's for all",
                                  all.unstamped, all.messages, choice_.topic));
  }

  void choose_joints() {
    std::vector<std::string> known;
    for (const Joint& joint : contents().joints) known.push_back(joint.name);
    if (request_.joint.empty()) choice_.joints = known;
    std::string_view left = request_.joint;
    while (!left.empty()) {
      const std::size_t comma = std::min(left.find(','), left.size());
      add_joints(std::string(left.substr(0, comma)), known);
      left.remove_prefix(std::min(comma + 1, left.size()));
    }
    for (const Joint& joint : contents().joints) {
      if (const auto found = io::unprintable_in(joint.name)) {
        io::refuse(file_, fmt::format("a joint's name holds {}; must be one line of text", *found));
      }
      require_always_there(joint);
    }
  }

  void add_joints(const std::string& pattern, const std::vector<std::string>& known) {
    const std::size_t before = choice_.joints.size();
    for (const std::string& name : known) {
      if (io::fits_pattern(name, pattern) && !is_chosen(name)) choice_.joints.push_back(name);
    }
    if (choice_.joints.size() > before) return;
    const auto near = io::nearest(pattern, known);
    io::refuse("--joint", fmt::format("\"{}\" fits no joint of {}{}; {}", pattern, choice_.topic,
                                      before > 0 ? " that was not named before" : "",
                                      near ? fmt::format("did you mean \"{}\"?", *near)
                                           : "they are " + io::listed(known)));
  }

  bool is_chosen(const std::string& name) const {
    return std::find(choice_.joints.begin(), choice_.joints.end(), name) != choice_.joints.end();
  }

  /// A row holds all joints at one time.
  void require_always_there(const Joint& joint) const {
    if (!is_chosen(joint.name)) return;
    const Joint& first = *std::find_if(contents().joints.begin(), contents().joints.end(),
                                       [&](const Joint& each) { return is_chosen(each.name); });
    if (joint.messages == first.messages) return;
    io::refuse(file_, fmt::format("messages of {} have not all the same joints: {} is in {} of "
                                  "{}, {} in {}; choose those that come together by --joint",
                                  choice_.topic, first.name, first.messages, contents().messages,
                                  joint.name, joint.messages));
  }

  void choose_columns() {
    for (std::size_t i = 0; i < choice_.joints.size(); ++i) {
      const Joint& joint = joint_of(contents(), choice_.joints[i]);
      if (joint.positions + joint.velocities == 0) {
        io::refuse(file_, fmt::format("{} of {} has neither a position nor a velocity", joint.name,
                                      choice_.topic));
      }
      add_column(i, Quantity::kOutputPosition, joint.positions);
      add_column(i, Quantity::kOutputVelocity, joint.velocities);
      add_column(i, Quantity::kReportedTorque, joint.efforts);
      if (choice_.commands.empty()) continue;
      const TopicContents& commands = topics_.of_joints.at(choice_.commands);
      add_column(i, Quantity::kCommandedPosition, joint_of(commands, joint.name).positions);
    }
  }

  static Joint joint_of(const TopicContents& topic, const std::string& name) {
    const auto found = std::find_if(topic.joints.begin(), topic.joints.end(),
                                    [&](const Joint& each) { return each.name == name; });
    return found == topic.joints.end() ? Joint{} : *found;
  }

  void add_column(std::size_t joint, Quantity quantity, std::size_t numbers) {
    if (numbers > 0) choice_.columns.push_back({joint, quantity});
  }

  const ImportRequest& request_;
  std::string file_;
  RecordedTopics topics_;
  Choice choice_;
};

/// Rows of one run.
class Rows {
 public:
  Rows(const Choice& choice, const RecordedRun& run, const RowSink& sink)
      : choice_(choice),
        run_(run),
        sink_(sink),
        cells_(1 + choice.columns.size()),
        commanded_rad_(choice.joints.size(), std::nan("")) {}

  void read(const std::filesystem::path& file) {
    file_ = file.string();
    for_each_joint_state(
        *open_recording(file), file_,
        [&](const std::string& topic) {
          return topic == choice_.topic || topic == choice_.commands;
        },
        [&](const std::string& topic, std::int64_t recorded_ns, const JointState& state) {
          if (topic == choice_.commands) take_command(state);
          if (topic == choice_.topic) take_row(recorded_ns, state);
        });
  }

 private:
  /// Where each chosen joint stands in a message; false where none does.
  bool find_places(const JointState& state) {
    if (state.names == last_names_) return has_any_;
    last_names_ = state.names;
    places_.clear();
    for (const std::string& joint : choice_.joints) {
      const auto found = std::find(state.names.begin(), state.names.end(), joint);
      places_.push_back(static_cast<std::size_t>(found - state.names.begin()));
    }
    has_any_ = std::any_of(places_.begin(), places_.end(),
                           [&](std::size_t place) { return place < state.names.size(); });
    return has_any_;
  }

  double value(const std::vector<double>& values, std::size_t joint) const {
    return places_[joint] < values.size() ? values[places_[joint]] : std::nan("");
  }

  /// It holds until another comes.
  void take_command(const JointState& state) {
    if (!find_places(state)) return;
    for (std::size_t joint = 0; joint < commanded_rad_.size(); ++joint) {
      const double command_rad = value(state.position, joint);
      if (std::isfinite(command_rad)) commanded_rad_[joint] = command_rad;
    }
  }

  void take_row(std::int64_t recorded_ns, const JointState& state) {
    if (!find_places(state)) return;
    const std::int64_t time_ns = choice_.is_by_stamp ? state.stamp_ns : recorded_ns;
    if (!first_ns_) first_ns_ = time_ns;
    if (last_ns_) check_clocks(time_ns, recorded_ns);
    last_ns_ = time_ns;
    last_recorded_ns_ = recorded_ns;
    cells_[0] = fmt::format("{:.9f}", static_cast<double>(time_ns - *first_ns_) / kPerSecond_ns);
    for (std::size_t i = 0; i < choice_.columns.size(); ++i) {
      write(number(choice_.columns[i], state), cells_[i + 1]);
    }
    sink_(run_.name, cells_);
  }

  void check_clocks(std::int64_t time_ns, std::int64_t recorded_ns) const {
    const std::int64_t step_ns = time_ns - *last_ns_;
    const std::int64_t recorders_ns = recorded_ns - last_recorded_ns_;
    const bool is_backwards = step_ns < 0;
    const bool jumps = step_ns > kOtherClock_ns && step_ns - recorders_ns > kOtherClock_ns;
    if (!is_backwards && !jumps) return;
    io::refuse(
        file_,
        fmt::format("times of {} {} by {:.3f} s between messages that came {:.3f} s apart (at {} "
                    "ns): there are two clocks, or two recordings in one{}",
                    choice_.topic, is_backwards ? "go back" : "jump",
                    static_cast<double>(std::abs(step_ns)) / kPerSecond_ns,
                    static_cast<double>(recorders_ns) / kPerSecond_ns, recorded_ns,
                    choice_.is_by_stamp ? "; --clock recorder takes the recorder's times" : ""));
  }

  double number(const RecordedColumn& column, const JointState& state) const {
    switch (column.quantity) {
      case Quantity::kOutputPosition:
        return value(state.position, column.joint);
      case Quantity::kOutputVelocity:
        return value(state.velocity, column.joint);
      case Quantity::kReportedTorque:
        return value(state.effort, column.joint);
      default:
        return commanded_rad_[column.joint];
    }
  }

  /// What is no number was not measured: an empty cell.
  static void write(double value, std::string& cell) {
    cell.clear();
    if (std::isfinite(value)) fmt::format_to(std::back_inserter(cell), "{}", value);
  }

  const Choice& choice_;
  const RecordedRun& run_;
  const RowSink& sink_;
  std::string file_;
  std::vector<std::string> cells_, last_names_;
  std::vector<double> commanded_rad_;
  std::vector<std::size_t> places_;
  bool has_any_ = false;
  std::optional<std::int64_t> first_ns_, last_ns_;
  std::int64_t last_recorded_ns_ = 0;
};

std::string column_name(const Choice& choice, const RecordedColumn& column) {
  const std::string& joint = choice.joints[column.joint];
  switch (column.quantity) {
    case Quantity::kOutputPosition:
      return joint + "_rad";
    case Quantity::kOutputVelocity:
      return joint + "_rad_s";
    case Quantity::kReportedTorque:
      return joint + "_Nm";
    default:
      return joint + "_commanded_rad";
  }
}

}  // namespace

ImportedLog read_recorded_joints(const ImportRequest& request) {
  Chooser chooser(request, recorded_runs(request.files));
  const auto choice = std::make_shared<const Choice>(chooser.choose());
  ImportedLog log;
  log.notes = chooser.notes();
  log.header = {"time_s"};
  log.columns = {{"time_s", Quantity::kTime, 1.0, 0.0, "", false}};
  for (const RecordedColumn& column : choice->columns) {
    log.header.push_back(column_name(*choice, column));
    log.columns.push_back({log.header.back(), column.quantity, 1.0, 0.0,
                           choice->joints.size() > 1 ? choice->joints[column.joint] : "", false});
  }
  for (const RecordedRun& run : choice->runs) log.runs.push_back({run.name, {}});
  log.stream = [choice](const RowSink& sink) {
    for (const RecordedRun& run : choice->runs) {
      Rows rows(*choice, run, sink);
      for (const std::filesystem::path& file : run.files) rows.read(file);
    }
  };
  log.notes.emplace_back(
      "positions are taken for rad, effort for the driver's own estimate of the output's torque");
  if (!choice->commands.empty()) {
    log.notes.emplace_back("a row has the last command that was recorded before it");
  }
  return log;
}

}  // namespace torquewright::identification::imports
