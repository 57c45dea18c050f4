// SPDX-License-Identifier: Apache-2.0
// Oracles: ONNX Runtime (npm's onnxruntime-web, in node) and OpenCV's networks, where they are.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <string>
#include <vector>

#include "hopper/policy/onnx_export.hpp"
#include "tests/hopper/policy/sample_policies.hpp"

namespace torquewright::hopper {
namespace {

namespace fs = std::filesystem;

constexpr Eigen::Index kViews = 40;
constexpr int kAbsent = 77;
constexpr int kNoCommand = 127;

// Both compute with floats: sums of up to 16 numbers. Of an output above 1 this is a share.
constexpr double kTolerance = 1e-6;

/// A folder with models and what they are shown.
fs::path folder_with(const std::vector<PolicyDocument>& documents) {
  fs::path folder = fs::path(testing::TempDir()) / "onnx_runtime";
  fs::create_directories(folder);
  for (std::size_t i = 0; i < documents.size(); ++i) {
    const std::string name = (folder / std::to_string(i)).string();
    std::ofstream(name + ".onnx", std::ios::binary) << onnx_bytes(onnx_graph_of(documents[i]));
    std::ofstream(name + ".in") << std::setprecision(9)
                                << test::sample_observations(documents[i], kViews).transpose()
                                << "\n";
    std::ofstream course(name + ".course");
    for (long period = 0; period < kViews; ++period) {
      for (const PolicyOutput& output : documents[i].outputs) {
        course << course_at(output, period) << " ";
      }
      course << "\n";
    }
  }
  return folder;
}

void expect_said(const PolicyDocument& document, std::istream& out) {
  learning::PolicyEvaluation policy(document.policy);
  const Eigen::MatrixXd views = test::sample_observations(document, kViews);
  for (Eigen::Index period = 0; period < kViews; ++period) {
    const Eigen::VectorXd action = policy.action(views.col(period));
    Eigen::VectorXd expected(2 * action.size());
    expected << action, test::target_of(document, action, period);
    for (Eigen::Index i = 0; i < expected.size(); ++i) {
      double found = 1e9;
      out >> found;
      EXPECT_NEAR(found, expected(i), kTolerance * std::max(1.0, std::abs(expected(i))));
    }
  }
}

void expect_same(const std::string& runtime, const std::string& name) {
  std::vector<PolicyDocument> documents = test::sample_policies();
  documents.push_back(test::policy_along_a_course());
  const std::string folder = folder_with(documents).string();
  const std::string command =
      runtime + " " + folder + " " + std::to_string(documents.size()) + " > " + folder + "/out";
  const int code = WEXITSTATUS(std::system((command + " 2> " + folder + "/err").c_str()));
  if (code == kAbsent || code == kNoCommand) GTEST_SKIP() << name << " is not installed";
  ASSERT_EQ(code, 0) << name;
  std::ifstream out(folder + "/out");
  for (const PolicyDocument& document : documents) expect_said(document, out);
}

TEST(OnnxRuntime, SaysWhatThePolicySays) {
  const char* named = std::getenv("TORQUEWRIGHT_NODE_MODULES");
  const std::string modules = named != nullptr ? named : TORQUEWRIGHT_SOURCE_DIR "/build";
  expect_same("node " TORQUEWRIGHT_SOURCE_DIR "/tests/hopper/policy/run_onnx.mjs " + modules,
              "onnxruntime-web (npm install --prefix build onnxruntime-web)");
}

TEST(OpenCvNetwork, SaysWhatThePolicySays) {
  expect_same("/usr/bin/python3 " TORQUEWRIGHT_SOURCE_DIR "/tests/hopper/policy/run_onnx.py",
              "python3-opencv");
}

}  // namespace
}  // namespace torquewright::hopper
