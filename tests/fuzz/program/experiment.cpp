// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/program/experiment.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <utility>

#include "tests/fuzz/program/command_files.hpp"

namespace torquewright::fuzz {
namespace {

/// As they are spelt, and as what they lead to.
std::set<std::string> by_all_names(const std::set<std::string>& files, const Scene& scene) {
  std::set<std::string> names;
  for (const std::string& file : files) {
    names.insert(file);
    names.insert(fs::path(file).lexically_normal().string());
    std::error_code failed;
    const fs::path true_file = fs::weakly_canonical(scene.path(file), failed);
    if (failed || file.empty()) continue;
    names.insert(true_file.lexically_relative(fs::canonical(scene.folder())).string());
  }
  return names;
}

std::vector<fs::path> pipes_in(const Case& one, const Scene& scene) {
  std::vector<fs::path> pipes;
  for (const auto& [name, thing] : one.things) {
    if (thing.kind == Thing::Kind::kPipe) pipes.push_back(scene.path(name));
  }
  return pipes;
}

/// Workers begin with the command line of the process, which a copy does not have.
bool may_have_workers(const Words& words) {
  return std::any_of(words.begin(), words.end(), [](const std::string& word) {
    return word.starts_with("--sweep") || word.starts_with("--trial") || word.starts_with("--jobs");
  });
}

std::string bytes_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::size_t total_bytes(const std::set<std::string>& files, const Scene& scene) {
  std::size_t total = 0;
  for (const std::string& file : files) {
    std::error_code failed;
    const auto bytes = fs::file_size(scene.path(file), failed);
    if (!failed) total += bytes;
  }
  return total;
}

}  // namespace

Experiment::Experiment(std::filesystem::path program, const Limits& limits,
                       const std::filesystem::path& copies)
    : program_(std::move(program)),
      limits_(limits),
      copies_(copies.empty() ? nullptr : std::make_unique<ForkClient>(copies)) {}

Run Experiment::perform(const Case& one) {
  scene_.lay_out(one);
  Run run;
  run.one = one;
  run.inputs = inputs_of(one.arguments, scene_);
  run.outputs = by_all_names(outputs_of(one.arguments), scene_);
  run.input_bytes = total_bytes(run.inputs, scene_);
  const Look before = scene_.look();
  const double clock_s = works_until_told(one.arguments) ? kShortPatience_s : limits_.clock_s;
  const auto patience = std::chrono::milliseconds(static_cast<long>(1e3 * clock_s));
  ForkClient* const copies = may_have_workers(one.arguments) ? nullptr : copies_.get();
  run.outcome = fuzz::run(one.arguments, {program_, scene_.folder(), scene_.temporary(), patience,
                                          pipes_in(one, scene_), copies});
  const Look after = scene_.look();
  run.changed = changed(before, after);
  for (const std::string& name : run.changed) {
    const fs::path file = scene_.folder() / ".." / name;
    std::error_code failed;
    if (fs::is_regular_file(file, failed)) run.written.emplace_back(name, bytes_of(file));
  }
  return run;
}

}  // namespace torquewright::fuzz
