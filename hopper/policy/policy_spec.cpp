// SPDX-License-Identifier: Apache-2.0
#include "hopper/policy/policy_spec.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace torquewright::hopper {
namespace {

using nlohmann::json;

class PolicyReader {
 public:
  explicit PolicyReader(io::Document document) : document_{std::move(document)} {}

  ReadPolicy read() {
    PolicyDocument read;
    read.name = root().value("name", "");
    read.task = root().value("task", "");
    read.limits = root().value("limits", "");
    read.control_period_s = root()["control_period_s"];
    read.inputs = inputs();
    read.outputs = outputs();
    read.policy.normalisation = {vector(root()["normalisation"]["mean"]),
                                 vector(root()["normalisation"]["deviation"])};
    read.policy.layers = layers(root()["layers"], "/layers");
    if (root().contains("estimator")) {
      read.policy.estimator = layers(root()["estimator"]["layers"], "/estimator/layers");
    }
    read.gains = gains();
    read_trained_with(read);
    if (root().contains("training_task")) {
      read.training_task = root()["training_task"].dump();
      read.filters_sensors = root()["training_task"].value("filters_sensors", json()) == true;
    }
    read.file = document_.file;
    read.sha256 = document_.sha256;
    if (faults_.empty()) object(objection_to(read), "");
    if (!faults_.empty()) throw io::SpecError(std::move(faults_));
    return {std::move(read), std::move(document_)};
  }

 private:
  const json& root() const { return document_.root; }

  void object(const std::string& sentence, const std::string& path) {
    if (!sentence.empty()) faults_.push_back({document_.file, document_.path + path, sentence});
  }

  void read_trained_with(PolicyDocument& read) {
    for (const json& keys : root().value("trained_with", json::array())) {
      const std::string sha256 = keys["sha256"];
      if (sha256.size() != 64 || sha256.find_first_not_of("0123456789abcdef") != sha256.npos) {
        object("must be 64 hexadecimal digits in lower case",
               "/trained_with/" + std::to_string(read.trained_with.size()) + "/sha256");
      }
      read.trained_with.push_back({keys["path"], sha256});
    }
  }

  std::vector<PolicyInput> inputs() const {
    std::vector<PolicyInput> list;
    for (const json& keys : root()["inputs"]) {
      list.push_back({keys["name"], keys["unit"], keys.value("delay_steps", 0)});
    }
    return list;
  }

  std::vector<PolicyOutput> outputs() const {
    std::vector<PolicyOutput> list;
    for (const json& keys : root()["outputs"]) {
      list.push_back({keys["name"], keys["unit"], keys.value("offset", 0.0),
                      keys.value("scale", 1.0), keys.value("course", std::vector<double>{})});
    }
    return list;
  }

  std::vector<PolicyGain> gains() {
    std::vector<PolicyGain> list;
    if (!root().contains("gains")) return list;
    const json& stiffness = root()["gains"]["stiffness_Nm_rad"];
    const json& damping = root()["gains"]["damping_Nm_s_rad"];
    for (const auto& [drive, value] : stiffness.items()) {
      list.push_back({drive, value, damping.value(drive, 0.0)});
      if (damping.contains(drive)) continue;
      object(fmt::format("\"{}\" has no damping, which the others have", drive),
             "/gains/damping_Nm_s_rad");
    }
    for (const auto& [drive, value] : damping.items()) {
      if (stiffness.contains(drive)) continue;
      object(fmt::format("\"{}\" has no stiffness, which the others have", drive),
             "/gains/stiffness_Nm_rad");
    }
    return list;
  }

  static Eigen::VectorXd vector(const json& numbers) {
    Eigen::VectorXd vector(static_cast<Eigen::Index>(numbers.size()));
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      vector(static_cast<Eigen::Index>(i)) = numbers[i];
    }
    return vector;
  }

  learning::Activation activation(const json& keys) const {
    const bool is_own = keys.contains("activation");
    const json& named = is_own ? keys : root();
    const std::string name = named["activation"];
    learning::Activation activation = learning::activation_of(*learning::activation_named(name));
    activation.alpha = named.value("alpha", activation.alpha);
    return activation;
  }

  std::vector<learning::Layer> layers(const json& list, const std::string& path) {
    std::vector<learning::Layer> all;
    for (const json& keys : list) {
      const bool is_last = all.size() + 1 == list.size() && !keys.contains("activation");
      all.push_back({matrix(keys["weights"], fmt::format("{}/{}/weights", path, all.size())),
                     vector(keys["bias"]),
                     is_last ? learning::activation_of(learning::ActivationKind::kIdentity)
                             : activation(keys)});
    }
    return all;
  }

  Eigen::MatrixXd matrix(const json& rows, const std::string& path) {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(rows.size()),
                                                   static_cast<Eigen::Index>(rows[0].size()));
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (rows[i].size() != rows[0].size()) {
        object(
            fmt::format("{} numbers, where the first row has {}", rows[i].size(), rows[0].size()),
            fmt::format("{}/{}", path, i));
        continue;
      }
      matrix.row(static_cast<Eigen::Index>(i)) = vector(rows[i]).transpose();
    }
    return matrix;
  }

  io::Document document_;
  std::vector<io::Fault> faults_;
};

}  // namespace

ReadPolicy read_policy(const std::filesystem::path& file) {
  return policy_of(io::read_document(file, "policy"));
}

void require_readable(const std::string& text, const std::string& file) {
  policy_of(io::check_document(json::parse(text), "policy", file, ""));
}

ReadPolicy policy_of(io::Document document) { return PolicyReader(std::move(document)).read(); }

}  // namespace torquewright::hopper
