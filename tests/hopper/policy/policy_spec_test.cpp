// SPDX-License-Identifier: Apache-2.0
// Oracle: what was written; arithmetic by hand of the document that the schema shows.
#include "hopper/policy/policy_spec.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "hopper/policy/c_source.hpp"
#include "hopper/policy/onnx_export.hpp"
#include "io/documents/published_schema.hpp"
#include "io/faults/spec_error.hpp"
#include "tests/hopper/policy/sample_policies.hpp"

namespace torquewright::hopper {
namespace {

using nlohmann::json;

PolicyDocument read_back(const std::string& text) {
  return policy_of(io::check_document(json::parse(text), "policy", "policy.json", "")).policy;
}

void expect_same_layers(const std::vector<learning::Layer>& a,
                        const std::vector<learning::Layer>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].weights, b[i].weights);
    EXPECT_EQ(a[i].bias, b[i].bias);
    EXPECT_EQ(a[i].activation, b[i].activation);
  }
}

TEST(PolicySpec, ReadsWhatItWroteToTheBit) {
  for (PolicyDocument document : test::sample_policies()) {
    document.name = "a \"name\" of \\";
    document.policy.layers[0].bias(0) = 0.1;  // no float
    document.policy.layers[1].activation = learning::activation_of(learning::ActivationKind::kElu);
    document.policy.layers[1].activation.alpha = 0.3;
    document.outputs[1].course = {0.25, -0.1, 1e-3};
    const PolicyDocument read = read_back(policy_text(document));
    EXPECT_EQ(read.name, document.name);
    EXPECT_EQ(read.task, "stand");
    EXPECT_EQ(read.limits, "mor");
    EXPECT_EQ(read.control_period_s, 0.01);
    EXPECT_EQ(read.policy.normalisation.mean, document.policy.normalisation.mean);
    EXPECT_EQ(read.policy.normalisation.deviation, document.policy.normalisation.deviation);
    expect_same_layers(read.policy.layers, document.policy.layers);
    expect_same_layers(read.policy.estimator, document.policy.estimator);
    ASSERT_EQ(read.inputs.size(), 5U);
    EXPECT_EQ(read.inputs[3].delay_steps, 1);
    EXPECT_EQ(read.outputs[1].scale, 0.7);
    EXPECT_TRUE(read.outputs[0].course.empty());
    EXPECT_FALSE(read.filters_sensors);
    EXPECT_EQ(read.outputs[1].course, (std::vector<double>{0.25, -0.1, 1e-3}));
    EXPECT_EQ(read.gains[1].drive, "knee");
    EXPECT_EQ(read.gains[1].damping_Nm_s_rad, 5.0);
    EXPECT_EQ(read.trained_with[0].sha256, std::string(64, 'a'));
  }
}

// Who deploys a policy has to know that a filter stands before it.
TEST(PolicySpec, SaysWhetherItSeesWhatAFilterLeaves) {
  PolicyDocument document = test::sample_policies()[0];
  document.training_task = R"({"filters_sensors": true})";
  const PolicyDocument read = read_back(policy_text(document));
  EXPECT_TRUE(read.filters_sensors);
  EXPECT_NE(c_source_of(read, {}).find("a filter's estimates"), std::string::npos);
  EXPECT_EQ(onnx_graph_of(read).metadata.back(),
            std::make_pair(std::string("sensors"), std::string("filtered")));
  document.training_task = R"({"filters_sensors": "yes"})";  // the replay refuses it
  EXPECT_FALSE(read_back(policy_text(document)).filters_sensors);
}

TEST(PolicySpec, TheDocumentToStartFromIsWhatOneComputesByHand) {
  const PolicyDocument document = read_back(io::document_to_start_from("policy"));
  learning::PolicyEvaluation policy(document.policy);
  const double z1 = 0.1 / 0.2;
  const double z2 = -0.3 / 1.5;
  const double guess = 0.1 * z1 - 0.2 * z2 + 0.05;
  const double first = 0.8 * z1 + 0.2 * z2 + 0.1 * guess;  // above 0
  const double second = -0.4 * z1 + 0.3 * z2 + 0.1;        // below
  const double action = 0.5 * first - 0.5 * (std::exp(second) - 1.0);
  EXPECT_NEAR(policy.action(Eigen::Vector2d(0.1, -0.3))(0), action, 1e-15);
}

std::vector<std::string> faults_of(const std::function<void(json&)>& change) {
  json document = json::parse(policy_text(test::sample_policies()[1]));
  change(document);
  try {
    read_back(document.dump());
    return {};
  } catch (const io::SpecError& error) {
    std::vector<std::string> all;
    for (const io::Fault& fault : error.faults()) all.push_back(fault.path + ": " + fault.message);
    return all;
  }
}

TEST(PolicySpec, RefusesWhatDoesNotFitTogether) {
  EXPECT_TRUE(faults_of([](json&) {}).empty());
  EXPECT_EQ(faults_of([](json& keys) { keys["inputs"].erase(0); }).at(0),
            ": 4 inputs are named, where the policy sees 5 numbers");
  EXPECT_EQ(faults_of([](json& keys) { keys["outputs"].erase(0); }).at(0),
            ": 1 outputs are named, where the last layer has 2");
  EXPECT_EQ(faults_of([](json& keys) { keys["layers"][1]["weights"][2].erase(0); }).at(0),
            "/layers/1/weights/2: 15 numbers, where the first row has 16");
  EXPECT_EQ(faults_of([](json& keys) { keys["layers"][1]["bias"].erase(0); }).at(0),
            ": layer 2 has 9 rows of weights and 8 numbers of bias, which are to be equally many");
  EXPECT_EQ(faults_of([](json& keys) { keys.erase("estimator"); }).at(0),
            ": layer 1 has weights for 8 inputs, not for the 5 that it is given");
  EXPECT_EQ(faults_of([](json& keys) { keys["gains"]["damping_Nm_s_rad"].erase("knee"); }).at(0),
            "/gains/damping_Nm_s_rad: \"knee\" has no damping, which the others have");
  EXPECT_FALSE(faults_of([](json& keys) { keys["normalisation"]["deviation"][0] = 0; }).empty());
  EXPECT_FALSE(faults_of([](json& keys) { keys["activation"] = "swish"; }).empty());
  const auto with_hash = [](const std::string& sha256) {
    return faults_of([&](json& keys) {
      keys["trained_with"] = json::array({{{"path", "knee.json"}, {"sha256", sha256}}});
    });
  };
  EXPECT_TRUE(with_hash(std::string(64, 'a')).empty());
  for (const std::string& sha256 : {std::string(63, 'a'), std::string(64, 'A'), std::string("x")}) {
    EXPECT_EQ(with_hash(sha256).at(0),
              "/trained_with/0/sha256: must be 64 hexadecimal digits in lower case");
  }
}

TEST(PolicyCourse, HoldsItsLastBehindItsEnd) {
  const PolicyOutput output{"knee_target_rad", "rad", 1.0, 1.0, {0.25, -0.5}};
  EXPECT_EQ(course_at(output, 0), 0.25);
  EXPECT_EQ(course_at(output, 1), -0.5);
  EXPECT_EQ(course_at(output, 70), -0.5);
  EXPECT_EQ(course_at({"knee_target_rad", "rad", 1.0, 1.0}, 3), 0.0);
}

TEST(PolicyNames, EndInUnits) {
  EXPECT_EQ(unit_in_name("knee_rate_rad_s"), "rad/s");
  EXPECT_EQ(unit_in_name("knee_rad"), "rad");
  EXPECT_EQ(unit_in_name("base_speed_m_s"), "m/s");
  EXPECT_EQ(unit_in_name("base_pitch_sin"), "1");
  EXPECT_EQ(unit_in_name("phase"), "1");
  EXPECT_EQ(unit_in_name("knee_torque_Nm"), "Nm");
}

}  // namespace
}  // namespace torquewright::hopper
