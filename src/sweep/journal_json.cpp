// SPDX-License-Identifier: Apache-2.0
#include "src/sweep/journal_json.hpp"

#include <map>
#include <nlohmann/json.hpp>
#include <string_view>

#include "io/files/sha256.hpp"

namespace torquewright::sweep {
namespace {

using nlohmann::ordered_json;

constexpr const char* kFirstLine = R"({"kind":"sweep_journal","version":1})";

/// On one line; bytes that are no UTF-8 become the replacement character.
std::string line_of(const ordered_json& value) {
  return value.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

/// Behind all else on a line: of the bytes before it.
constexpr std::string_view kDigest = R"(,"sha256":")";
constexpr std::string_view kEnd = R"("})";

std::string sealed(std::string line) {
  line.pop_back();  // the brace that ends it
  const std::string digest = io::sha256(line);
  return line.append(kDigest).append(digest).append(kEnd);
}

/// Whether the line is as it was written: a disk may change a byte, and so may somebody.
bool is_sealed(std::string_view line) {
  const std::size_t at = line.rfind(kDigest);
  return at != std::string_view::npos && line == sealed(std::string(line.substr(0, at)) + '}');
}

bool is_text(const ordered_json& entry, const char* key) {
  return entry.contains(key) && entry[key].is_string();
}

}  // namespace

Journal::Journal(const Request& request) : request_(request) {
  if (request.journal_file.empty()) return;
  file_ = std::make_unique<io::JournalFile>(request.journal_file, kFirstLine);
}

std::vector<std::optional<Answer>> Journal::known() const {
  std::vector<std::optional<Answer>> answers(request_.points.size());
  if (!file_) return answers;
  std::map<std::string, std::size_t> points;
  for (std::size_t i = 0; i < request_.points.size(); ++i) points[request_.points[i]] = i;
  for (const std::string& line : file_->lines()) {
    if (!is_sealed(line)) continue;
    const ordered_json entry = ordered_json::parse(line, nullptr, false);
    if (!is_text(entry, "point") || !is_text(entry, "request") || !entry.contains("row")) continue;
    if (entry["request"] != request_.fingerprint) continue;
    const auto point = points.find(entry["point"]);
    if (point != points.end()) answers[point->second] = Answer{false, line_of(entry["row"]), ""};
  }
  return answers;
}

void Journal::add(const PointAnswer& answer) {
  if (!file_) return;
  ordered_json entry{{"point", request_.points[answer.point]}, {"request", request_.fingerprint}};
  if (answer.answer.is_lost) {
    entry["lost"] = answer.answer.why;
  } else {
    entry["row"] = ordered_json::parse(answer.answer.row);
  }
  file_->add(sealed(line_of(entry)));
}

Answer as_kept(Answer answer) {
  if (answer.is_lost) return answer;
  const ordered_json row = ordered_json::parse(answer.row, nullptr, false);
  if (row.is_discarded()) return {true, "", "its answer is no JSON"};
  return {false, line_of(row), ""};
}

void check_journal(const std::string& file) {
  if (!file.empty()) io::check_journal(file, kFirstLine);
}

}  // namespace torquewright::sweep
