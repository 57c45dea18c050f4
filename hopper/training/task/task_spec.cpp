// SPDX-License-Identifier: Apache-2.0
#include "hopper/training/task/task_spec.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <utility>

#include "hopper/training/rewards/library.hpp"
#include "hopper/training/task/embedded_tasks.hpp"
#include "io/faults/spec_error.hpp"
#include "io/text/nearest.hpp"
#include "io/text/wording.hpp"

namespace torquewright::hopper {
namespace {

using nlohmann::json;

std::optional<double> number(const json& keys, const char* key) {
  if (!keys.contains(key)) return std::nullopt;
  return keys[key].get<double>();
}

class TaskReader {
 public:
  explicit TaskReader(io::Document document) : document_(std::move(document)) {}

  Task read() {
    task_.file = document_.file;
    task_.text = root().dump();
    task_.name = root().value("name", "");
    task_.in_plane = root().value("in_plane", task_.in_plane);
    task_.control_period_s = root().value("control_period_s", task_.control_period_s);
    task_.step_s = root().value("step_s", task_.step_s);
    task_.duration_s = root()["duration_s"];
    task_.filters_sensors = root().value("filters_sensors", task_.filters_sensors);
    task_.scale_rad = root().value("scale_rad", task_.scale_rad);
    task_.full_torque_error_rad =
        root().value("full_torque_error_rad", task_.full_torque_error_rad);
    task_.damping_time_s = root().value("damping_time_s", task_.damping_time_s);
    task_.clearance_m = root().value("clearance_m", 0.0);
    task_.overload_probability = root().value("overload_probability", 0.0);
    task_.history_steps = root().value("history_steps", task_.history_steps);
    read_phase();
    read_start();
    read_joints();
    read_goal();
    read_commands();
    read_learning();
    for (const json& keys : root()["rewards"]) add_reward(keys);
    require_order();
    if (!faults_.empty()) throw io::SpecError(std::move(faults_));
    return std::move(task_);
  }

 private:
  const json& root() const { return document_.root; }
  json part(const char* key) const { return root().value(key, json::object()); }

  void fault(const std::string& path, std::string message) {
    faults_.push_back({document_.file, document_.path + path, std::move(message)});
  }

  void read_phase() {
    const json keys = part("phase");
    task_.phase = {keys.value("take_off_s", 0.0), keys.value("landing_s", 0.0),
                   keys.value("end_s", 0.0), keys.value("period_s", 0.0)};
  }

  void read_start() {
    const json keys = part("start");
    task_.posture = keys.value("posture", task_.posture);
    task_.start_joint_rad = keys.value("joint_position_rad", 0.0);
    task_.start_joint_rad_s = keys.value("joint_velocity_rad_s", 0.0);
  }

  void read_joints() {
    const json joints = part("joints");
    for (const auto& [name, keys] : joints.items()) {
      task_.joints[name] = {number(keys, "offset_rad"), number(keys, "scale_rad"),
                            number(keys, "stiffness_Nm_rad"), number(keys, "damping_Nm_s_rad")};
    }
  }

  void read_goal() {
    const json keys = part("goal");
    Goal& goal = task_.goal;
    goal.turn_rad = keys.value("turn_rad", 0.0);
    goal.least_flights = keys.value("least_flights", 0);
    goal.most_flights = keys.value("most_flights", goal.least_flights);
    goal.rests = keys.value("rests", true);
    goal.landing_s = task_.phase.landing_s;
    goal.forward_tolerance_m_s = keys.value("forward_tolerance_m_s", goal.forward_tolerance_m_s);
    if (goal.least_flights > goal.most_flights) {
      fault("/goal/least_flights",
            fmt::format("{} is above most_flights, {}", goal.least_flights, goal.most_flights));
    }
  }

  void read_commands() {
    const json keys = part("commands");
    if (!keys.contains("forward_m_s")) return;
    const json& ends = keys["forward_m_s"];
    task_.forward_m_s = Range{ends["least"], ends["greatest"]};
    if (task_.forward_m_s->least > task_.forward_m_s->greatest) {
      fault("/commands/forward_m_s", "least is above greatest");
    }
  }

  void read_learning() {
    const json keys = part("learning");
    TaskLearning& learning = task_.learning;
    learning.copies = keys.value("copies", learning.copies);
    learning.steps_per_iteration = keys.value("steps", learning.steps_per_iteration);
    learning.minibatch = keys.value("minibatch", learning.minibatch);
    learning.discount = keys.value("discount", learning.discount);
    learning.first_deviation = keys.value("first_deviation", learning.first_deviation);
    learning.least_deviation = keys.value("least_deviation", learning.least_deviation);
    learning.entropy = keys.value("entropy", learning.entropy);
    learning.layers = keys.value("layers", learning.layers);
  }

  void add_reward(const json& keys) {
    const std::string name = keys["term"];
    TaskReward reward;
    reward.term = reward_named(name);
    const std::string path = fmt::format("/rewards/{}", task_.rewards.size());
    if (reward.term == nullptr) {
      const auto nearest = io::nearest(name, reward_names());
      fault(path + "/term",
            fmt::format("no term is named \"{}\"{}", name,
                        nearest ? fmt::format(" (did you mean \"{}\"?)", *nearest) : ""));
    }
    reward.weight = number(keys, "weight");
    reward.rate = number(keys, "rate");
    reward.least = number(keys, "least");
    reward.greatest = number(keys, "greatest");
    reward.softness = number(keys, "softness");
    const json joints = keys.value("joints", json::object());
    for (const auto& [joint, numbers] : joints.items()) {
      reward.joints[joint] = {numbers.value("weight", 1.0), number(numbers, "least"),
                              number(numbers, "greatest")};
    }
    task_.rewards.push_back(std::move(reward));
  }

  void require_order() {
    const PhaseTimes& phase = task_.phase;
    if (phase.take_off_s > phase.landing_s) {
      fault("/phase/take_off_s",
            fmt::format("{:g} s is after landing_s, {:g} s", phase.take_off_s, phase.landing_s));
    }
    if (task_.step_s > task_.control_period_s) {
      fault("/step_s", fmt::format("{:g} s is longer than control_period_s, {:g} s", task_.step_s,
                                   task_.control_period_s));
    }
  }

  io::Document document_;
  Task task_;
  std::vector<io::Fault> faults_;
};

}  // namespace

std::vector<std::string> training_task_names() {
  std::vector<std::string> names;
  for (const EmbeddedTask& task : embedded_tasks()) names.emplace_back(task.name);
  return names;
}

namespace {

[[noreturn]] void refuse_unknown(const std::string& name_or_file) {
  std::vector<std::string> names;
  for (const EmbeddedTask& task : embedded_tasks()) names.emplace_back(task.name);
  const auto near = io::nearest(name_or_file, names);
  throw io::SpecError({{name_or_file, "",
                        fmt::format("no file, and no task of that name; {}",
                                    near ? fmt::format("did you mean {}?", *near)
                                         : "there are " + io::listed(names))}});
}

}  // namespace

Task read_task(const std::string& name_or_file) {
  for (const EmbeddedTask& task : embedded_tasks()) {
    if (task.name == name_or_file) return task_of(std::string(task.text), name_or_file);
  }
  if (!std::filesystem::exists(name_or_file)) refuse_unknown(name_or_file);
  return TaskReader(io::read_document(name_or_file, "training_task")).read();
}

Task task_of(const std::string& text, const std::string& file) {
  return TaskReader(io::check_document(json::parse(text), "training_task", file, "")).read();
}

Task with_flight(const Task& task, double from_s, double until_s) {
  if (!(task.phase.landing_s > 0.0)) {
    throw io::SpecError({{task.file, "/phase/landing_s", "a task that goes by a motion has one"}});
  }
  const double later_s = until_s - task.phase.landing_s;
  json root = json::parse(task.text);
  root["phase"]["take_off_s"] = from_s;
  root["phase"]["landing_s"] = until_s;
  if (task.phase.end_s > 0.0) root["phase"]["end_s"] = task.phase.end_s + later_s;
  root["duration_s"] = task.duration_s + later_s;
  return task_of(root.dump(), task.file);
}

}  // namespace torquewright::hopper
