// SPDX-License-Identifier: Apache-2.0
#include "src/sweep/worker_channel.hpp"

#include <fmt/format.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdlib>
#include <exception>

#include "io/faults/refusal.hpp"
#include "io/files/direct_output.hpp"

namespace torquewright::sweep {
namespace {

std::string on_one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

/// No line where whoever started this process is gone.
std::optional<std::string> next_line(std::string& bytes) {
  while (bytes.find('\n') == std::string::npos) {
    std::array<char, 256> chunk;
    const ssize_t count = ::read(kWorkerReads, chunk.data(), chunk.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return std::nullopt;
    bytes.append(chunk.data(), static_cast<std::size_t>(count));
  }
  const std::size_t end = bytes.find('\n');
  std::string line = bytes.substr(0, end);
  bytes.erase(0, end + 1);
  return line;
}

std::optional<std::size_t> number_in(std::string_view text) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

PointAnswer answered(const Evaluate& evaluate, std::size_t point) {
  try {
    return {point, {false, on_one_line(evaluate(point)), ""}};
  } catch (const std::exception& error) {
    return {point, {true, "", on_one_line(error.what())}};
  }
}

}  // namespace

WorkerLine read_worker_line(std::string_view line) {
  constexpr std::string_view kReady = "ready ";
  if (line.starts_with(kReady)) {
    return {WorkerLine::Kind::kReady, 0, std::string(line.substr(kReady.size()))};
  }
  for (const auto& [word, kind] :
       {std::pair<std::string_view, WorkerLine::Kind>{"done ", WorkerLine::Kind::kDone},
        {"lost ", WorkerLine::Kind::kLost}}) {
    if (!line.starts_with(word)) continue;
    const std::string_view rest = line.substr(word.size());
    const std::size_t blank = rest.find(' ');
    const auto point = number_in(rest.substr(0, blank));
    if (!point || blank == std::string_view::npos) return {};
    return {kind, *point, std::string(rest.substr(blank + 1))};
  }
  return {};
}

std::string written(const PointAnswer& answer) {
  const auto& [is_lost, row, why] = answer.answer;
  return fmt::format("{} {} {}\n", is_lost ? "lost" : "done", answer.point, is_lost ? why : row);
}

std::vector<std::string> take_lines(std::string& bytes) {
  std::vector<std::string> lines;
  std::size_t begin = 0;
  for (std::size_t end = bytes.find('\n'); end != std::string::npos;
       end = bytes.find('\n', begin)) {
    lines.push_back(bytes.substr(begin, end - begin));
    begin = end + 1;
  }
  bytes.erase(0, begin);
  return lines;
}

bool is_worker() { return std::getenv(kWorkerVariable) != nullptr; }

void end_with_starter() {
  if (is_worker()) ::prctl(PR_SET_PDEATHSIG, SIGKILL);
}

void serve(const Request& request, const Evaluate& evaluate) {
  end_with_starter();
  const bool is_orphan = std::to_string(::getppid()) != std::getenv(kWorkerVariable);
  if (is_orphan) {
    io::refuse(kWorkerVariable,
               "is set, by which a sweep knows the processes that it starts, and "
               "this is none of them: unset it");
  }
  if (io::write_all(kWorkerWrites, fmt::format("ready {}\n", request.fingerprint)) != 0) return;
  std::string bytes;
  while (const auto line = next_line(bytes)) {
    const auto point = number_in(*line);
    if (!point || *point >= request.points.size()) return;
    if (io::write_all(kWorkerWrites, written(answered(evaluate, *point))) != 0) return;
  }
}

}  // namespace torquewright::sweep
