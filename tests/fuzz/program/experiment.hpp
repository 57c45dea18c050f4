// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>

#include "tests/fuzz/program/fork_client.hpp"
#include "tests/fuzz/program/rules.hpp"
#include "tests/fuzz/program/scene.hpp"

namespace torquewright::fuzz {

/// Lays a case out, runs the program once and looks at what came of it.
class Experiment {
 public:
  /// With `copies`, runs are copies of that program (fork_server.cpp).
  Experiment(std::filesystem::path program, const Limits& limits,
             const std::filesystem::path& copies = {});

  Run perform(const Case& one);
  Breach breach_of(const Case& one) { return breach_in(perform(one), limits_); }
  const Scene& scene() const { return scene_; }
  const std::filesystem::path& program() const { return program_; }

 private:
  std::filesystem::path program_;
  Limits limits_;
  Scene scene_;
  std::unique_ptr<ForkClient> copies_;
};

}  // namespace torquewright::fuzz
