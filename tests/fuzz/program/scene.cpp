// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/program/scene.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>

namespace torquewright::fuzz {
namespace {

const fs::path kRepository = TORQUEWRIGHT_SOURCE_DIR;

Stamp stamp_of(const fs::path& file) {
  struct stat status {};
  if (::lstat(file.c_str(), &status) != 0) return {};
  // What goes through a pipe or a device does not change it.
  if (!S_ISREG(status.st_mode)) return {status.st_mode, status.st_ino, 0, 0};
  // Not the time of the status, which changes when another name of the file is taken away.
  const auto written_ns = status.st_mtim.tv_sec * 1'000'000'000 + status.st_mtim.tv_nsec;
  return {status.st_mode, status.st_ino, status.st_size, written_ns};
}

/// Within the scene: neither absolute nor upwards, and a name at its end.
bool is_inside(const std::string& name) {
  if (name.empty() || name.find('\0') != std::string::npos) return false;
  const fs::path path = name;
  return path.is_relative() && path.has_filename() &&
         std::none_of(path.begin(), path.end(), [](const fs::path& p) { return p == ".."; });
}

void place(const Thing& thing, const fs::path& at) {
  std::error_code failed;  // names may be too long, or lead through files
  fs::create_directories(at.parent_path(), failed);
  fs::remove_all(at, failed);
  switch (thing.kind) {
    case Thing::Kind::kFile:
      std::ofstream(at, std::ios::binary) << thing.content;
      break;
    case Thing::Kind::kReadOnlyFile:
      std::ofstream(at, std::ios::binary) << thing.content;
      fs::permissions(at, fs::perms(0444), failed);
      break;
    case Thing::Kind::kFolder:
      fs::create_directory(at, failed);
      break;
    case Thing::Kind::kPipe:
      ::mkfifo(at.c_str(), 0600);
      break;
    case Thing::Kind::kLink:
      fs::create_symlink(thing.content, at, failed);
      break;
    case Thing::Kind::kHardLink:
      break;  // when what it is to lead to stands
  }
}

}  // namespace

Scene::Scene() {
  fs::create_directories(temporary());
  for (const char* top : {"specs", "tests/fuzz/corpus"}) {
    for (const auto& entry : fs::recursive_directory_iterator(kRepository / top)) {
      const bool is_case = entry.path().extension() == ".case";
      if (!entry.is_regular_file() || is_case) continue;
      examples_.push_back(entry.path().lexically_relative(kRepository).string());
    }
  }
  std::sort(examples_.begin(), examples_.end());
  for (const std::string& example : examples_) copy(example);
  untouched_ = look();
}

void Scene::copy(const std::string& example) {
  const fs::path file = path(example);
  fs::remove_all(file);
  fs::create_directories(file.parent_path());
  fs::copy_file(kRepository / example, file);
  fs::permissions(file, fs::perms(0644));
}

void Scene::lay_out(const Case& one) {
  mend();
  for (const auto& [name, thing] : one.things) {
    if (is_inside(name)) place(thing, path(name));
  }
  for (const auto& [name, thing] : one.things) {
    if (thing.kind != Thing::Kind::kHardLink || !is_inside(name)) continue;
    std::error_code failed;
    fs::create_hard_link(path(thing.content), path(name), failed);
  }
}

void Scene::mend() {
  for (const auto& entry : fs::directory_iterator(folder())) {
    const std::string name = entry.path().filename().string();
    const bool is_folder = entry.symlink_status().type() == fs::file_type::directory;
    const bool is_ours = name == "specs" || name == "tests";
    if (!is_ours || !is_folder) fs::remove_all(entry.path());
  }
  for (const auto& entry : fs::directory_iterator(temporary())) fs::remove_all(entry.path());
  const Look now = look();
  for (const auto& [name, stamp] : now) {
    if (!untouched_.contains(name)) fs::remove_all(scratch_.path() / name);
  }
  for (const std::string& example : examples_) {
    const std::string name = "work/" + example;
    const auto found = now.find(name);
    if (found != now.end() && found->second == untouched_[name]) continue;
    copy(example);
    untouched_[name] = stamp_of(scratch_.path() / name);
  }
}

Look Scene::look() const {
  Look look;
  const std::size_t behind_folder = scratch_.path().native().size() + 1;
  for (const auto& entry : fs::recursive_directory_iterator(scratch_.path())) {
    if (entry.symlink_status().type() == fs::file_type::directory) continue;
    look[entry.path().native().substr(behind_folder)] = stamp_of(entry.path());
  }
  return look;
}

std::vector<std::string> changed(const Look& before, const Look& after) {
  std::vector<std::string> names;
  for (const auto& [name, stamp] : before) {
    const auto found = after.find(name);
    if (found == after.end() || found->second != stamp) names.push_back(name);
  }
  for (const auto& [name, stamp] : after) {
    if (!before.contains(name)) names.push_back(name);
  }
  return names;
}

}  // namespace torquewright::fuzz
