// SPDX-License-Identifier: Apache-2.0
#include "io/documents/read_notes.hpp"

#include <algorithm>
#include <mutex>
#include <nlohmann/json.hpp>

namespace torquewright::io {
namespace {

/// Documents may be read side by side.
struct Notebook {
  std::mutex mutex;
  bool is_kept = false;
  std::vector<ReadNote> notes;
};

Notebook& notebook() {
  static Notebook living;
  return living;
}

}  // namespace

void keep_read_notes() {
  Notebook& book = notebook();
  const std::lock_guard lock(book.mutex);
  book.is_kept = true;
  book.notes.clear();
}

std::vector<ReadNote> read_notes() {
  Notebook& book = notebook();
  const std::lock_guard lock(book.mutex);
  return book.notes;
}

void note_read(const std::string& file, const nlohmann::json& root) {
  Notebook& book = notebook();
  const std::lock_guard lock(book.mutex);
  if (!book.is_kept) return;
  const auto is_same = [&](const ReadNote& note) { return note.file == file; };
  if (std::any_of(book.notes.begin(), book.notes.end(), is_same)) return;
  ReadNote note{file, root.value("kind", ""), {}};
  for (const auto& pointer : root.value("assumed", nlohmann::json::array())) {
    if (pointer.is_string()) note.assumed.push_back(pointer);
  }
  book.notes.push_back(std::move(note));
}

}  // namespace torquewright::io
