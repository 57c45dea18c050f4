// SPDX-License-Identifier: Apache-2.0
#include "io/files/atomic_file.hpp"

#include <algorithm>
#include <csignal>
#include <utility>

#include "io/faults/refusal.hpp"
#include "io/faults/spec_error.hpp"
#include "io/files/direct_output.hpp"
#include "io/files/long_file.hpp"
#include "io/files/signals_held.hpp"
#include "io/files/staged_file.hpp"

namespace torquewright::io {
namespace {

namespace fs = std::filesystem;

bool is_same_file(const fs::path& a, const fs::path& b) {
  if (a.empty() || b.empty()) return false;  // no file at all
  std::error_code unknown;
  const fs::file_status status = fs::status(a, unknown);
  if (fs::is_other(status)) return false;  // a device takes whatever comes
  if (fs::exists(status)) return fs::equivalent(a, b, unknown);
  // Not there yet: the same name in the same folder, however that is reached.
  const fs::path first = fs::weakly_canonical(fs::absolute(a), unknown);
  const fs::path second = fs::weakly_canonical(fs::absolute(b), unknown);
  return first.filename() == second.filename() &&
         (first == second || fs::equivalent(first.parent_path(), second.parent_path(), unknown));
}

bool contains(const std::vector<fs::path>& files, const fs::path& file) {
  return std::any_of(files.begin(), files.end(),
                     [&](const fs::path& each) { return is_same_file(each, file); });
}

void replace_all_or_none(std::vector<StagedFile> all) {
  const SignalsHeld held;
  std::vector<StagedFile> files = std::move(all);  // gone before the signals come
  for (StagedFile& file : files) file.stage();
  try {
    for (StagedFile& file : files) file.publish();
  } catch (const SpecError&) {
    for (StagedFile& file : files) file.withdraw();
    throw;
  }
}

struct Output {
  Target target;
  std::string_view content;
  TextSource more = nullptr;
};

/// What cannot be replaced is written into at once.
std::string whole(const Output& output) {
  std::string text(output.content);
  if (output.more) output.more([&](std::string_view piece) { text += piece; });
  return text;
}

/// Pipes come first, while a signal still ends the program: they may wait for their reader without
/// end, and what they have taken cannot be taken back.
void write_all_or_none(const std::vector<Output>& outputs) {
  for (const Output& output : outputs) {
    if (output.target.is_direct) write_into(output.target.file, whole(output));
  }
  std::vector<StagedFile> staged;
  for (const auto& [target, content, more] : outputs) {
    if (!target.is_direct) staged.emplace_back(target, content, more);
  }
  replace_all_or_none(std::move(staged));
}

}  // namespace

void write_whole_file(const fs::path& file, std::string_view content) {
  write_all_or_none({{Target(file), content}});
}

void write_whole_files(const std::vector<FileContent>& files) {
  std::vector<Output> outputs;
  for (const auto& [file, content] : files) outputs.push_back({Target(file), content});
  write_all_or_none(outputs);
}

void write_whole_files(const fs::path& file, const TextSource& text,
                       const std::vector<FileContent>& others) {
  std::vector<Output> outputs{{Target(file), "", text}};
  for (const FileContent& each : others) outputs.push_back({Target(each.file), each.content});
  write_all_or_none(outputs);
}

void check_outputs(const std::vector<fs::path>& outputs, const std::vector<fs::path>& inputs) {
  std::vector<Fault> faults;
  std::vector<fs::path> seen;
  for (const fs::path& output : outputs) {
    try {
      require_writable(Target(output));
      if (contains(inputs, output)) refuse_output(output, "it is an input, which would be lost");
      if (contains(seen, output)) refuse_output(output, "it is named for two outputs");
    } catch (const SpecError& error) {
      faults.push_back(error.faults().front());
    }
    seen.push_back(output);
  }
  if (!faults.empty()) throw SpecError(std::move(faults));
}

void ignore_file_size_signal() { std::signal(SIGXFSZ, SIG_IGN); }

}  // namespace torquewright::io
