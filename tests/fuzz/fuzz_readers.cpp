// SPDX-License-Identifier: Apache-2.0
// Feeds mutated documents to the readers for so many seconds: fuzz_documents SECONDS [SEED]. Every
// one has to be accepted or refused with sentences; anything else ends the program with status 1.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "gearbox/problem_spec.hpp"
#include "io/document.hpp"
#include "io/file_bytes.hpp"
#include "io/schema.hpp"
#include "tests/fuzz/mutation.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::fuzz {
namespace {

namespace fs = std::filesystem;
using Reader = std::function<void(const fs::path&)>;

/// All that reads documents from outside. A further reader is one more line here.
std::vector<Reader> readers() {
  std::vector<Reader> readers;
  for (const std::string& kind : io::document_kinds()) {
    readers.push_back([kind](const fs::path& file) { io::read_document(file, kind); });
  }
  readers.push_back([](const fs::path& file) {
    gearbox::read_problem(io::read_document(file, "gearbox_problem"));
  });
  return readers;
}

std::vector<std::string> corpus() {
  std::vector<fs::path> files;
  for (const char* folder : {"specs", "tests/fuzz/corpus"}) {
    for (const auto& entry :
         fs::recursive_directory_iterator(fs::path(TORQUEWRIGHT_SOURCE_DIR) / folder)) {
      if (entry.path().extension() == ".json") files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  std::vector<std::string> texts;
  for (const fs::path& file : files) texts.push_back(io::read_file_bytes(file));
  return texts;
}

/// Empty if the text is accepted or properly refused.
std::string misbehaviour(const Reader& read, const fs::path& file) {
  try {
    read(file);
  } catch (const io::SpecError& error) {
    const std::string lines = error.what();
    const auto breaks = static_cast<std::size_t>(std::count(lines.begin(), lines.end(), '\n'));
    if (breaks + 1 != error.faults().size()) return "not one line per fault";
    for (const io::Fault& fault : error.faults()) {
      if (fault.message.empty()) return "a fault without a sentence";
    }
  } catch (const std::exception& error) {
    return std::string("another exception: ") + error.what();
  }
  return "";
}

int run(double seconds, std::uint64_t seed) {
  const auto start = std::chrono::steady_clock::now();
  const auto elapsed = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  const std::vector<std::string> texts = corpus();
  const std::vector<Reader> all = readers();
  const test::ScratchFolder folder;
  Random random(seed);
  long executions = 0;
  for (; elapsed() < seconds; ++executions) {
    const std::string text = mutated(texts, random);
    const fs::path file = folder.write("document.json", text);
    for (const Reader& read : all) {
      const std::string what = misbehaviour(read, file);
      if (what.empty()) continue;
      std::printf("execution %ld of seed %lu: %s\n%s\n", executions, seed, what.c_str(),
                  text.c_str());
      return EXIT_FAILURE;
    }
  }
  std::printf("%ld executions in %.1f s, seed %lu\n", executions, elapsed(), seed);
  return executions > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace
}  // namespace torquewright::fuzz

int main(int count, char** arguments) {
  if (count < 2) {
    std::fputs("usage: fuzz_documents SECONDS [SEED]\n", stderr);
    return 2;
  }
  const std::uint64_t seed = count > 2 ? std::strtoull(arguments[2], nullptr, 10) : 1;
  return torquewright::fuzz::run(std::strtod(arguments[1], nullptr), seed);
}
