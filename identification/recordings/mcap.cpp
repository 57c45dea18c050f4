// SPDX-License-Identifier: Apache-2.0
#include "identification/recordings/mcap.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <map>
#include <optional>
#include <string>
#include <utility>

#include "identification/recordings/little_endian.hpp"
#include "identification/recordings/unpacked_chunk.hpp"
#include "io/faults/refusal.hpp"
#include "io/files/plain_bytes.hpp"

namespace torquewright::identification {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view kMcapMagic = "\x89MCAP0\r\n"sv;

/// Opcodes of records; those that are not among them hold nothing that is asked for.
constexpr unsigned char kFooter = 0x02, kSchema = 0x03, kChannel = 0x04, kMessage = 0x05,
                        kChunk = 0x06;

struct Record {
  unsigned char opcode = 0;
  std::string_view content;
};

class Mcap : public Recording {
 public:
  explicit Mcap(const std::filesystem::path& file) : file_(file.string()), bytes_(file) {
    read_exactly(kMcapMagic.size());
  }

  bool next(RecordedMessage& message) override {
    while (const std::optional<Record> record = next_record()) {
      if (record->opcode == kSchema) add_schema(record->content);
      if (record->opcode == kChannel) add_channel(record->content);
      if (record->opcode == kChunk) open_chunk(record->content);
      if (record->opcode != kMessage) continue;
      LittleEndian fields(record->content);
      const auto channel = static_cast<std::uint16_t>(fields.number(2));
      fields.number(4);  // the sequence number
      message.recorded_ns = static_cast<std::int64_t>(fields.number(8));
      fields.number(8);  // when it was published
      const auto topic = topic_of_channel_.find(channel);
      if (fields.is_short() || topic == topic_of_channel_.end()) {
        refuse_record("is a message of a channel that stands nowhere before it");
      }
      message.topic = topic->second;
      message.bytes = fields.rest();
      return true;
    }
    return false;
  }
  const std::vector<Topic>& topics() const override { return topics_; }
  std::string cut_end() const override { return cut_end_; }

 private:
  [[noreturn]] void refuse_record(const std::string& what) const {
    io::refuse(file_, fmt::format("its record at byte {} {}", record_at_, what));
  }

  /// Of the chunk that is open, else of the file; none at the end.
  std::optional<Record> next_record() {
    if (!left_of_chunk_.empty()) return record_of_chunk();
    record_at_ = at_;
    if (!read_exactly(1 + 8)) return std::nullopt;
    LittleEndian head(buffer_);
    const auto opcode = static_cast<unsigned char>(head.number(1));
    const std::uint64_t length = head.number(8);
    if (opcode == kFooter) return std::nullopt;
    if (opcode == 0) refuse_record("is of no kind");
    if (length > kMostUnpackedBytes) {
      refuse_record(
          fmt::format("holds {} bytes, more than the allowed {}", length, kMostUnpackedBytes));
    }
    if (!read_exactly(static_cast<std::size_t>(length))) return std::nullopt;
    return Record{opcode, buffer_};
  }

  std::optional<Record> record_of_chunk() {
    LittleEndian fields(left_of_chunk_);
    const auto opcode = static_cast<unsigned char>(fields.number(1));
    const std::string_view content = fields.counted(8);
    if (fields.is_short()) refuse_record("is a chunk that ends within one of its own records");
    left_of_chunk_ = fields.rest();
    return Record{opcode, content};
  }

  void open_chunk(std::string_view content) {
    LittleEndian fields(content);
    fields.take(8 + 8);  // times of its messages
    const auto size = static_cast<std::size_t>(fields.number(8));
    const auto sum = static_cast<std::uint32_t>(fields.number(4));
    const std::string compression(fields.counted(4));
    const std::string_view packed = fields.counted(8);
    if (fields.is_short()) refuse_record("is a chunk that is longer than its record");
    const std::string wrong = unpack(compression, packed, size, chunk_);
    if (!wrong.empty()) refuse_record("is a chunk that " + wrong);
    const auto made =
        crc32(0, reinterpret_cast<const Bytef*>(chunk_.data()), static_cast<uInt>(chunk_.size()));
    if (sum != 0 && made != sum) {
      refuse_record("is a chunk that is damaged: it has not the sum that stands beside it");
    }
    left_of_chunk_ = chunk_;
  }

  void add_schema(std::string_view content) {
    LittleEndian fields(content);
    const auto id = static_cast<std::uint16_t>(fields.number(2));
    schemas_[id] = fields.counted(4);
  }

  /// It stands before its messages, and again behind all of them.
  void add_channel(std::string_view content) {
    LittleEndian fields(content);
    const auto id = static_cast<std::uint16_t>(fields.number(2));
    const auto schema = static_cast<std::uint16_t>(fields.number(2));
    const std::string topic(fields.counted(4)), encoding(fields.counted(4));
    if (!topic_of_channel_.emplace(id, topics_.size()).second) return;
    topics_.push_back({topic, schemas_[schema], encoding});
  }

  /// Puts so many bytes into the buffer; false, and a sentence, where the file ends before.
  bool read_exactly(std::size_t count) {
    buffer_.resize(count);
    std::size_t held = 0;
    while (held < count) {
      const std::size_t more = bytes_.read(buffer_.data() + held, count - held);
      if (more == 0) {
        cut_end_ = fmt::format(
            "ends at byte {} in the middle of a record that begins at byte {}: it is left out", at_,
            record_at_);
        if (held == 0 && at_ == record_at_) {
          cut_end_ = fmt::format("ends at byte {} without an end: its recorder was stopped", at_);
        }
        return false;
      }
      held += more;
      at_ += more;
    }
    return true;
  }

  std::string file_;
  io::PlainBytes bytes_;
  std::size_t at_ = 0, record_at_ = 0;
  std::string buffer_, chunk_;
  std::string_view left_of_chunk_;
  std::map<std::uint16_t, std::string> schemas_;
  std::map<std::uint16_t, std::size_t> topic_of_channel_;
  std::vector<Topic> topics_;
  std::string cut_end_;
};

}  // namespace

bool begins_as_mcap(std::string_view first_bytes) { return first_bytes.starts_with(kMcapMagic); }

std::unique_ptr<Recording> open_mcap(const std::filesystem::path& file) {
  return std::make_unique<Mcap>(file);
}

}  // namespace torquewright::identification
