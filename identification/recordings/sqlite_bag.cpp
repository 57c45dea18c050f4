// SPDX-License-Identifier: Apache-2.0
#include "identification/recordings/sqlite_bag.hpp"

#include <fmt/format.h>
#include <sqlite3.h>
#include <zstd.h>

#include <map>
#include <string>

#include "identification/recordings/unpacked_chunk.hpp"
#include "io/faults/refusal.hpp"

namespace torquewright::identification {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view kZstdMagic = "\x28\xb5\x2f\xfd"sv;

class SqliteBag : public Recording {
 public:
  explicit SqliteBag(const std::filesystem::path& file) : file_(file.string()) {
    try {
      if (sqlite3_open_v2(file_.c_str(), &database_, SQLITE_OPEN_READONLY, nullptr) != SQLITE_OK) {
        refuse_database();
      }
      read_topics();
      prepare("SELECT topic_id, timestamp, data FROM messages ORDER BY timestamp, id");
    } catch (...) {
      close();
      throw;
    }
  }
  SqliteBag(const SqliteBag&) = delete;
  SqliteBag& operator=(const SqliteBag&) = delete;
  ~SqliteBag() override { close(); }

  bool next(RecordedMessage& message) override {
    if (!step()) return false;
    const auto topic = topic_of_id_.find(sqlite3_column_int64(statement_, 0));
    message.recorded_ns = sqlite3_column_int64(statement_, 1);
    if (topic == topic_of_id_.end()) {
      io::refuse(file_, fmt::format("its message at {} ns is of topic {}, which it does not have",
                                    message.recorded_ns, sqlite3_column_int64(statement_, 0)));
    }
    message.topic = topic->second;
    const void* const data = sqlite3_column_blob(statement_, 2);
    message.bytes = {static_cast<const char*>(data),
                     static_cast<std::size_t>(sqlite3_column_bytes(statement_, 2))};
    if (message.bytes.starts_with(kZstdMagic)) unpack_message(message);
    return true;
  }
  const std::vector<Topic>& topics() const override { return topics_; }

 private:
  [[noreturn]] void refuse_database() const {
    io::refuse(file_, fmt::format("cannot be read as a bag of ROS 2: {}",
                                  database_ == nullptr ? "no memory" : sqlite3_errmsg(database_)));
  }

  void close() {
    sqlite3_finalize(statement_);
    sqlite3_close(database_);
  }

  void prepare(const char* query) {
    sqlite3_finalize(statement_);
    statement_ = nullptr;
    if (sqlite3_prepare_v2(database_, query, -1, &statement_, nullptr) != SQLITE_OK) {
      refuse_database();
    }
  }

  /// False behind the last row.
  bool step() {
    const int result = sqlite3_step(statement_);
    if (result != SQLITE_ROW && result != SQLITE_DONE) refuse_database();
    return result == SQLITE_ROW;
  }

  std::string text(int column) const {
    const unsigned char* const letters = sqlite3_column_text(statement_, column);
    return letters == nullptr ? "" : reinterpret_cast<const char*>(letters);
  }

  void read_topics() {
    prepare("SELECT id, name, type, serialization_format FROM topics ORDER BY id");
    while (step()) {
      topic_of_id_[sqlite3_column_int64(statement_, 0)] = topics_.size();
      topics_.push_back({text(1), text(2), text(3)});
    }
  }

  void unpack_message(RecordedMessage& message) {
    const auto size = ZSTD_getFrameContentSize(message.bytes.data(), message.bytes.size());
    const bool is_known = size != ZSTD_CONTENTSIZE_UNKNOWN && size != ZSTD_CONTENTSIZE_ERROR;
    const std::string wrong =
        is_known ? unpack("zstd", message.bytes, static_cast<std::size_t>(size), unpacked_)
                 : "is compressed by zstd and does not say how long it was";
    if (!wrong.empty()) {
      io::refuse(file_, fmt::format("its message at {} ns {}", message.recorded_ns, wrong));
    }
    message.bytes = unpacked_;
  }

  std::string file_;
  sqlite3* database_ = nullptr;
  sqlite3_stmt* statement_ = nullptr;
  std::map<std::int64_t, std::size_t> topic_of_id_;
  std::vector<Topic> topics_;
  std::string unpacked_;
};

}  // namespace

bool begins_as_sqlite(std::string_view first_bytes) {
  return first_bytes.starts_with("SQLite format 3\0"sv);
}

std::unique_ptr<Recording> open_sqlite_bag(const std::filesystem::path& file) {
  return std::make_unique<SqliteBag>(file);
}

}  // namespace torquewright::identification
