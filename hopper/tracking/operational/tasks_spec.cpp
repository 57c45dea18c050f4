// SPDX-License-Identifier: Apache-2.0
#include "hopper/tracking/operational/tasks_spec.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "robot/find_name.hpp"
#include "robot/model/whole_body.hpp"

namespace torquewright::hopper {
namespace {

using nlohmann::json;

TaskKind kind_named(const std::string& name) {
  for (const TaskKind kind : {TaskKind::kCenterOfMass, TaskKind::kBaseAttitude, TaskKind::kPoint}) {
    if (name == name_of(kind)) return kind;
  }
  return TaskKind::kJoint;  // the schema has no fifth
}

TaskTime time_named(const std::string& name) {
  if (name == "stance") return TaskTime::kStance;
  return name == "flight" ? TaskTime::kFlight : TaskTime::kAlways;
}

class TasksReader {
 public:
  TasksReader(io::Document document, const Robot& robot)
      : document_(std::move(document)), robot_(robot), whole_(robot) {}

  ReadTasks read() {
    const json& root = document_.root;
    OperationalTasks all;
    all.name = root.value("name", all.name);
    require_robot();
    for (const json& keys : root["tasks"]) {
      all.tasks.push_back(task(keys, fmt::format("/tasks/{}", all.tasks.size())));
    }
    const json springs = root.value("rigid_joints", json::array());
    for (std::size_t i = 0; i < springs.size(); ++i) {
      if (const auto found = spring(springs[i], i)) all.rigid.push_back(*found);
    }
    all.contact_weight = root.value("contact_weight", all.contact_weight);
    all.contact_time_s = root.value("contact_time_s", all.contact_time_s);
    all.rigid_rate_time_s = root.value("rigid_rate_time_s", all.rigid_rate_time_s);
    all.effort_weight = root.value("effort_weight", all.effort_weight);
    all.friction_share = root.value("friction_share", all.friction_share);
    if (!faults_.empty()) throw io::SpecError(std::move(faults_));
    return {std::move(all), std::move(document_)};
  }

 private:
  void add(const std::string& path, std::string message) {
    faults_.push_back({document_.file, path, std::move(message)});
  }

  void require_robot() {
    const std::string of = document_.root.value("robot", robot_.name);
    if (of == robot_.name) return;
    add("/robot", fmt::format("is for \"{}\", and the robot is \"{}\"", of, robot_.name));
  }

  std::vector<std::string> joint_names() const {
    std::vector<std::string> names;
    for (std::size_t i = 1; i < robot_.tree.bodies.size(); ++i) {
      names.push_back(robot_.tree.bodies[i].joint.name);
    }
    return names;
  }

  std::vector<std::string> contact_names() const {
    std::vector<std::string> names;
    for (const ContactPoint& contact : robot_.contacts) names.push_back(contact.name);
    return names;
  }

  /// What a task moves, under the key that its kind needs and no other has.
  std::optional<std::size_t> named(const json& keys, const std::string& path, const char* key,
                                   bool is_needed, const std::vector<std::string>& names) {
    if (keys.contains(key) != is_needed) {
      add(path, is_needed ? fmt::format("a {} task names its \"{}\"", keys["task"].dump(), key)
                          : fmt::format("\"{}\" is for no {} task", key, keys["task"].dump()));
      return std::nullopt;
    }
    if (!is_needed) return std::nullopt;
    return find_name(names, keys[key], key, {document_.file, path + "/" + key, ""}, faults_);
  }

  OperationalTask task(const json& keys, const std::string& path) {
    OperationalTask task;
    task.kind = kind_named(keys["task"]);
    const auto joint = named(keys, path, "joint", task.kind == TaskKind::kJoint, joint_names());
    const auto contact =
        named(keys, path, "contact", task.kind == TaskKind::kPoint, contact_names());
    if (joint) task.of = *joint + 1;
    if (contact) task.of = *contact;
    if (keys.contains("along")) {
      if (task.kind == TaskKind::kJoint) add(path, "\"along\" is for no \"joint\" task");
      task.along.fill(false);
      for (const std::string axis : keys["along"]) {
        task.along[static_cast<std::size_t>(axis.front() - 'x')] = true;
      }
    }
    task.when = time_named(keys.value("when", "always"));
    task.weight = keys.value("weight", task.weight);
    task.frequency_rad_s = keys.value("frequency_rad_s", task.frequency_rad_s);
    task.damping_ratio = keys.value("damping_ratio", task.damping_ratio);
    return task;
  }

  /// Of the robot's own joints, then of links that follow.
  std::optional<RigidJoint> spring(const std::string& name, std::size_t number) {
    std::vector<std::string> names = joint_names();
    const std::size_t own = names.size();
    for (const dynamics::Body& link : whole_.links()) names.push_back(link.joint.name);
    const std::string path = fmt::format("/rigid_joints/{}", number);
    const auto found = find_name(names, name, "joint", {document_.file, path, ""}, faults_);
    if (!found) return std::nullopt;
    const bool is_link = *found >= own;
    const dynamics::Joint& joint =
        is_link ? whole_.links()[*found - own].joint : robot_.tree.bodies[*found + 1].joint;
    if (!(joint.passive.stiffness > 0.0)) {
      add(path, fmt::format("\"{}\" has no spring (stiffness 0) that could count as rigid", name));
      return std::nullopt;
    }
    return RigidJoint{is_link, is_link ? *found - own : *found + 1};
  }

  io::Document document_;
  const Robot& robot_;
  WholeBody whole_;
  std::vector<io::Fault> faults_;
};

}  // namespace

ReadTasks read_tasks(const std::filesystem::path& file, const Robot& robot) {
  return tasks_of(io::read_document(file, "controller"), robot);
}

ReadTasks tasks_of(io::Document document, const Robot& robot) {
  return TasksReader(std::move(document), robot).read();
}

}  // namespace torquewright::hopper
