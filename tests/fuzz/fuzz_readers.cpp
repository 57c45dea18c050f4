// SPDX-License-Identifier: Apache-2.0
// Feeds mutated files to all readers: fuzz_readers [SECONDS [SEED]]. Every one has to be accepted
// or refused with sentences, and soon; anything else ends the program with status 1. Without
// SECONDS the environment variable TORQUEWRIGHT_FUZZ_SECONDS counts, or else 20.
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "io/faults/spec_error.hpp"
#include "io/files/file_bytes.hpp"
#include "tests/fuzz/mutation.hpp"
#include "tests/fuzz/readers.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::fuzz {
namespace {

namespace fs = std::filesystem;

constexpr double kDefaultSeconds = 20.0;
/// For one file: two orders of magnitude above the slowest, for slow machines and sanitizers.
constexpr unsigned kMostSecondsPerFile = 100;

using Corpus = std::map<std::string, std::vector<std::string>>;  ///< Texts by the files' ending.

Corpus read_corpus() {
  std::vector<fs::path> files;
  for (const char* folder : {"specs", "tests/fuzz/corpus"}) {
    for (const auto& entry :
         fs::recursive_directory_iterator(fs::path(TORQUEWRIGHT_SOURCE_DIR) / folder)) {
      if (entry.is_regular_file()) files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  Corpus corpus;
  for (const fs::path& file : files) {
    corpus[file.extension()].push_back(io::read_file_bytes(file));
  }
  return corpus;
}

struct Counts {
  long files = 0;
  std::map<std::string, long> accepted;  ///< By the reader's name.
};

/// Empty if the file is accepted or properly refused.
std::string misbehaviour(const Reader& reader, const fs::path& file, Counts& counts) {
  try {
    reader.read(file);
    ++counts.accepted[reader.name];
  } catch (const io::SpecError& error) {
    const std::string lines = error.what();
    const auto breaks = static_cast<std::size_t>(std::count(lines.begin(), lines.end(), '\n'));
    if (breaks + 1 != error.faults().size()) return "not one line per fault";
    for (const io::Fault& fault : error.faults()) {
      if (fault.message.empty()) return "a fault without a sentence";
    }
  } catch (const Misbehaviour& error) {
    return error.what();
  } catch (const std::exception& error) {
    return std::string("another exception: ") + error.what();
  }
  return "";
}

extern "C" void on_alarm(int) {
  constexpr std::string_view kMessage = "a reader does not come to an end\n";
  if (::write(STDOUT_FILENO, kMessage.data(), kMessage.size()) < 0) ::_exit(2);
  ::_exit(EXIT_FAILURE);
}

int run(double seconds, std::uint64_t seed) {
  const auto start = std::chrono::steady_clock::now();
  const auto elapsed = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  const Corpus corpus = read_corpus();
  const std::vector<Reader> all = readers();
  const test::ScratchFolder folder;
  Random random(seed);
  Counts counts;
  // Who ends this by a crash leaves the file behind.
  std::printf("seed %lu, each file in turn is %s\n", seed, (folder.path() / "file*").c_str());
  std::fflush(stdout);
  for (; elapsed() < seconds; ++counts.files) {
    for (const auto& [ending, texts] : corpus) {
      const std::string text = mutated(texts, random);
      const fs::path file = folder.write("file" + ending, text);
      for (const Reader& reader : all) {
        if (reader.ending != ending) continue;
        ::alarm(kMostSecondsPerFile);
        const std::string what = misbehaviour(reader, file, counts);
        ::alarm(0);
        if (what.empty()) continue;
        std::printf("%s, file %ld of seed %lu: %s\n%s\n", reader.name.c_str(), counts.files, seed,
                    what.c_str(), text.c_str());
        return EXIT_FAILURE;
      }
    }
  }
  std::printf("%ld files in %.1f s; accepted by:\n", counts.files, elapsed());
  for (const Reader& reader : all) {
    std::printf("  %-26s %ld\n", reader.name.c_str(), counts.accepted[reader.name]);
  }
  return counts.files > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

double default_seconds() {
  const char* text = std::getenv("TORQUEWRIGHT_FUZZ_SECONDS");
  return text == nullptr ? kDefaultSeconds : std::strtod(text, nullptr);
}

}  // namespace
}  // namespace torquewright::fuzz

int main(int count, char** arguments) {
  std::signal(SIGALRM, torquewright::fuzz::on_alarm);
  const double seconds =
      count > 1 ? std::strtod(arguments[1], nullptr) : torquewright::fuzz::default_seconds();
  const std::uint64_t seed = count > 2 ? std::strtoull(arguments[2], nullptr, 10) : 1;
  return torquewright::fuzz::run(seconds, seed);
}
