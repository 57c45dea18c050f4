// SPDX-License-Identifier: Apache-2.0
#include "src/standard_output.hpp"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "io/faults/spec_error.hpp"
#include "io/files/print.hpp"
#include "src/held_output.hpp"
#include "src/loudness.hpp"
#include "src/window_text.hpp"

namespace torquewright::cli {

void print_result(const std::string& text) {
  if (HeldOutput* held = held_output()) return held->add(text);
  io::print(text);
}

bool is_standard_output(const std::filesystem::path& file) { return file == "-"; }

void check_written(std::vector<std::filesystem::path> outputs,
                   const std::vector<std::filesystem::path>& inputs) {
  const auto printed = std::remove_if(outputs.begin(), outputs.end(), is_standard_output);
  if (outputs.end() - printed > 1) {
    throw io::SpecError({{"-", "", "standard output takes one of the files that were asked for"}});
  }
  outputs.erase(printed, outputs.end());
  io::check_outputs(outputs, inputs);
}

void deliver(std::vector<io::FileContent> files, const std::string& text) {
  std::string printed = text;
  const auto is_printed = [](const io::FileContent& each) { return is_standard_output(each.file); };
  const auto dash = std::find_if(files.begin(), files.end(), is_printed);
  if (dash != files.end()) {
    printed = std::move(dash->content);
    files.erase(dash);
  }
  io::write_whole_files(files);
  if (!printed.empty()) print_result(printed);
}

void deliver_result(const std::string& text, const std::string& file,
                    std::vector<io::FileContent> beside) {
  const bool is_named = !file.empty();
  if (is_named) beside.push_back({file, text});
  deliver(std::move(beside), is_named ? std::string() : text);
}

void deliver_report(const Report& report, const std::string& file, bool json_wanted,
                    std::vector<io::FileContent> beside) {
  const bool is_document =
      json_wanted || is_standard_output(file) || std::filesystem::path(file).extension() == ".json";
  if (file.empty() || is_document) {
    if (!file.empty()) beside.push_back({file, report.json});
    return deliver(std::move(beside),
                   json_wanted ? report.json : for_window(report.text, report.answer));
  }
  beside.push_back({file, report.text});
  deliver(std::move(beside), "");
  say_old_spelling(file, "the text for people", "> " + file);
}

void say_old_spelling(const std::string& file, const std::string& what,
                      const std::string& instead) {
  if (loudness().is_quiet) return;
  std::fprintf(stderr,
               "note: -o %s writes %s in this version only; from the next one on, write %s\n",
               file.c_str(), what.c_str(), instead.c_str());
}

}  // namespace torquewright::cli
