// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/program/draw.hpp"

#include "io/files/file_bytes.hpp"
#include "tests/fuzz/program/argument_mutation.hpp"
#include "tests/fuzz/program/chance.hpp"
#include "tests/fuzz/program/command_files.hpp"
#include "tests/fuzz/program/document_mutation.hpp"
#include "tests/fuzz/program/example_commands.hpp"
#include "tests/fuzz/program/output_mutation.hpp"
#include "tests/fuzz/program/table_mutation.hpp"

namespace torquewright::fuzz {
namespace {

std::string changed_text(const std::string& file, const std::string& text, Random& random) {
  if (fs::path(file).extension() == ".csv") return changed_table(text, random);
  return once_in(2, random) ? with_other_numbers(text, random) : mutated({text}, random);
}

/// One file that the command reads, itself or by way of another, with changes.
void change_input(Case& one, const Scene& scene, Random& random) {
  const auto all = inputs_of(one.arguments, scene);
  const std::vector<std::string> files(all.begin(), all.end());
  if (files.empty()) return;
  // Files that are named come more often than the many that these name.
  std::string file = one_of(files, random);
  for (const std::string& word : one.arguments) {
    const std::string name = word.substr(word.find('=') + 1);
    if (all.contains(name) && once_in(2, random)) file = name;
  }
  const bool is_there = one.things.contains(file);
  const std::string text =
      is_there ? one.things[file].content : io::read_file_bytes(scene.path(file));
  if (text.empty()) return;
  one.things[file] = {Thing::Kind::kFile, changed_text(file, text, random)};
}

/// Something that is no plain file in an input's place.
void obstruct_input(Case& one, const Scene& scene, Random& random) {
  const auto all = inputs_of(one.arguments, scene);
  const std::vector<std::string> files(all.begin(), all.end());
  if (files.empty()) return;
  const std::vector<Thing> things{{Thing::Kind::kFolder, ""},
                                  {Thing::Kind::kLink, "absent"},
                                  {Thing::Kind::kLink, "../actuator"},
                                  {Thing::Kind::kFile, ""},
                                  {Thing::Kind::kReadOnlyFile, "{}"}};
  one.things[one_of(files, random)] = one_of(things, random);
}

}  // namespace

Case draw_case(std::uint64_t seed, std::uint64_t number,
               const std::vector<DeclaredCommand>& vocabulary, const Scene& scene) {
  std::seed_seq words{seed, seed >> 32, number, number >> 32};
  Random random(words);
  Case one{one_of(example_commands(), random), {}};
  // One alone gets deepest: of the others, one is mostly refused.
  const std::vector<std::size_t> counts{1, 1, 1, 1, 1, 1, 2, 2, 2, 3};
  for (std::size_t count = one_of(counts, random); count > 0; --count) {
    const std::size_t kind = one_below(100, random);
    if (kind < 45) {
      change_arguments(one.arguments, vocabulary, scene.examples(), random);
    } else if (kind < 82) {
      change_input(one, scene, random);
    } else if (kind < 97) {
      change_output(one, vocabulary, random);
    } else {
      obstruct_input(one, scene, random);
    }
  }
  // No argument holds a zero byte: none could be passed.
  for (std::string& word : one.arguments) word = word.substr(0, word.find('\0'));
  return one;
}

}  // namespace torquewright::fuzz
