// SPDX-License-Identifier: Apache-2.0
#include "src/sweep/journal_json.hpp"

#include <nlohmann/json.hpp>
#include <string_view>

#include "io/files/sha256.hpp"
#include "src/sweep/ranks.hpp"

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

/// A run that has a name is of several.
io::JournalFile::Writers writers_of(const std::string& run) {
  return run.empty() ? io::JournalFile::Writers::kOne : io::JournalFile::Writers::kSeveral;
}

}  // namespace

Journal::Journal(const Request& request, const std::string& run)
    : request_(request), run_(run), known_(request.points.size()), is_begun_(known_.size()) {
  if (request.journal_file.empty()) return;
  file_ = std::make_unique<io::JournalFile>(request.journal_file, kFirstLine, writers_of(run));
  for (std::size_t i = 0; i < request.points.size(); ++i) points_[request.points[i]] = i;
  read_on();
}

void Journal::read_on() {
  for (; read_ < file_->lines().size(); ++read_) read(file_->lines()[read_]);
}

void Journal::read(const std::string& line) {
  if (!is_sealed(line)) return;
  const ordered_json entry = ordered_json::parse(line, nullptr, false);
  if (!is_text(entry, "point") || !is_text(entry, "request")) return;
  const auto point = points_.find(entry["point"]);
  if (entry["request"] != request_.fingerprint || point == points_.end()) return;
  const bool is_of_this_run = !run_.empty() && is_text(entry, "run") && entry["run"] == run_;
  if (entry.contains("row")) {
    known_[point->second] = Answer{false, line_of(entry["row"]), ""};
  } else if (is_of_this_run && is_text(entry, "lost")) {
    known_[point->second] = Answer{true, "", entry["lost"]};
  } else if (is_of_this_run && entry.contains("begun")) {
    is_begun_[point->second] = true;
  }
}

void Journal::write(std::size_t point, const char* key, const std::string& json) {
  ordered_json entry{{"point", request_.points[point]}, {"request", request_.fingerprint}};
  if (!run_.empty()) entry["run"] = run_;
  entry[key] = ordered_json::parse(json);
  file_->add(sealed(line_of(entry)));
}

void Journal::add(const PointAnswer& answer) {
  known_[answer.point] = answer.answer;
  if (!file_) return;
  if (answer.answer.is_lost) {
    write(answer.point, "lost", line_of(answer.answer.why));
  } else {
    write(answer.point, "row", answer.answer.row);
  }
  if (!run_.empty()) file_->give_back(answer.point);
}

std::optional<std::size_t> Journal::claim() {
  const auto look = [this] {
    file_->read_on();
    read_on();
  };
  look();
  for (std::size_t point = 0; point < known_.size(); ++point) {
    if (known_[point] || !file_->take(point)) continue;
    look();  // whoever had it may have answered meanwhile
    if (!known_[point] && !is_begun_[point]) {
      write(point, "begun", "true");
      return point;
    }
    if (!known_[point]) add({point, {true, "", "its rank of mpirun is gone"}});
    file_->give_back(point);
  }
  return std::nullopt;
}

Answer as_kept(Answer answer) {
  if (answer.is_lost) return answer;
  const ordered_json row = ordered_json::parse(answer.row, nullptr, false);
  if (row.is_discarded()) return {true, "", "its answer is not JSON"};
  return {false, line_of(row), ""};
}

void check_journal(const std::string& file) {
  if (!file.empty()) io::check_journal(file, kFirstLine, writers_of(ranks_by_environment().run));
}

}  // namespace torquewright::sweep
