// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/program/command_files.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "io/files/file_bytes.hpp"

namespace torquewright::fuzz {
namespace {

constexpr std::array<std::string_view, 20> kOutputOptions{
    "--all",       "-o",           "--output",        "--draw",
    "--plot",      "--plot-loads", "--plot-momentum", "--refined",
    "--export",    "--write-best", "--figures",       "--report",
    "--series",    "--plot-sweep", "--sweep-journal", "--curve",
    "--actuators", "--dxf",        "--step",          "--svg"};

/// Of what is done point by point, beside its output (docs/sweeps.md).
constexpr std::string_view kJournal = ".journal";
/// What a training goes on from, beside its policy.
constexpr std::string_view kState = ".training";

constexpr std::size_t kLongestName = 200;

bool is_option(const std::string& word) { return word.size() > 1 && word.front() == '-'; }

/// The word, and what stands behind a "=" in it.
std::vector<std::string> readings(const std::string& word) {
  std::vector<std::string> all{word};
  const std::size_t equals = word.find('=');
  if (equals != std::string::npos) all.push_back(word.substr(equals + 1));
  return all;
}

/// For a word such as --report=x.html or -ox.json: the file.
std::string attached_output(const std::string& word) {
  for (const std::string_view option : kOutputOptions) {
    const std::string start = std::string(option) + (option.starts_with("--") ? "=" : "");
    if (word.size() > start.size() && word.starts_with(start)) return word.substr(start.size());
  }
  return "";
}

/// And files of these names with an ending behind.
std::set<std::string> with_those_beside(std::set<std::string> outputs, std::string_view ending) {
  const std::set<std::string> plain = outputs;
  for (const std::string& output : plain) outputs.insert(output + std::string(ending));
  return outputs;
}

void add_files_at(const fs::path& path, std::vector<fs::path>& files) {
  if (path.native().find('\0') != std::string::npos) return;  // the system would see its beginning
  std::error_code failed;
  if (fs::is_regular_file(path, failed)) files.push_back(path);
  if (!fs::is_directory(path, failed)) return;
  for (const auto& entry : fs::directory_iterator(path, failed)) {
    if (entry.is_regular_file(failed)) files.push_back(entry.path());
  }
}

/// Files that a document names, as what it is taken to be and as what stands in quotes.
void add_named_in(const fs::path& document, const fs::path& folder, std::vector<fs::path>& files) {
  const std::string text = io::read_file_bytes(document);
  for (std::size_t at = text.find('"'); at != std::string::npos;) {
    const std::size_t end = text.find('"', at + 1);
    if (end == std::string::npos) return;
    const std::string word = text.substr(at + 1, end - at - 1);
    if (word.size() < kLongestName && word.find('.') != std::string::npos) {
      add_files_at(document.parent_path() / word, files);
      add_files_at(folder / word, files);
    }
    at = end;
  }
}

}  // namespace

bool is_journal(const Words& arguments, const std::string& file) {
  if (file.ends_with(kJournal)) return true;
  const Words named{"--sweep-journal", file};
  return std::search(arguments.begin(), arguments.end(), named.begin(), named.end()) !=
         arguments.end();
}

bool names_output(const std::string& word) {
  return std::find(kOutputOptions.begin(), kOutputOptions.end(), word) != kOutputOptions.end();
}

std::set<std::string> outputs_of(const Words& arguments) {
  std::set<std::string> outputs;
  bool follows = false, follows_at_once = false, has_points = false;
  for (const std::string& word : arguments) {
    has_points = has_points || word.starts_with("--sweep") || word.starts_with("--jobs");
    const std::string attached = attached_output(word);
    if (!attached.empty()) outputs.insert(attached);
    // Some take several; the first may look like an option.
    if (follows_at_once || (follows && !is_option(word))) {
      for (const std::string& reading : readings(word)) outputs.insert(reading);
    }
    if (is_option(word) && !follows_at_once) follows = names_output(word);
    follows_at_once = !follows_at_once && names_output(word);
  }
  const bool trains = arguments.size() > 1 && arguments[1] == "train";
  if (trains) outputs = with_those_beside(std::move(outputs), kState);
  return has_points ? with_those_beside(std::move(outputs), kJournal) : outputs;
}

std::set<std::string> inputs_of(const Words& arguments, const Scene& scene) {
  std::vector<fs::path> files;
  std::string before;
  for (const std::string& word : arguments) {
    if (!names_output(before) && attached_output(word).empty()) {
      for (const std::string& reading : readings(word)) {
        if (!reading.empty() && reading.size() < kLongestName) {
          add_files_at(scene.path(reading), files);
        }
      }
    }
    before = word;
  }
  std::set<std::string> inputs;
  while (!files.empty()) {
    const fs::path file = files.back();
    files.pop_back();
    std::error_code failed;
    const fs::path true_file = fs::canonical(file, failed);
    const std::string name = true_file.lexically_relative(fs::canonical(scene.folder())).string();
    if (failed || name.starts_with("..") || !inputs.insert(name).second) continue;
    if (true_file.extension() != ".csv") add_named_in(true_file, scene.folder(), files);
  }
  return inputs;
}

}  // namespace torquewright::fuzz
