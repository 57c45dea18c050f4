// SPDX-License-Identifier: Apache-2.0
#include "io/documents/schema.hpp"

#include <memory>
#include <string>

#include "io/documents/published_schema.hpp"
#include "io/files/atomic_file.hpp"
#include "io/text/wording.hpp"
#include "src/commands/shared/schema_commands.hpp"
#include "src/options/output_files.hpp"
#include "src/report/parts/key_table.hpp"
#include "src/standard_output.hpp"

namespace torquewright::cli {
namespace {

struct SchemaOptions {
  std::string kind;
  std::string output_file;
  bool is_page = false;
};

ExitCode run_schema(const SchemaOptions& options) {
  check_written(named({options.output_file}), {});
  deliver_result(options.is_page ? report::key_table_markdown(options.kind)
                                 : io::published_schema(options.kind),
                 options.output_file);
  return ExitCode::kPasses;
}

}  // namespace

void add_schema_command(command_line::Command& program) {
  auto options = std::make_shared<SchemaOptions>();
  command_line::Command command =
      program.add_command("schema", "Print the JSON Schema of a kind of documents, for editors");
  command.add_option("kind", options->kind, "Kind of document")
      .required()
      .one_of(io::document_kinds());
  command.add_option("-o,--output", options->output_file, "Write the schema to this file")
      .otherwise("-, standard output")
      .names_a_file();
  command.add_flag("--markdown", options->is_page,
                   "Print the page docs/documents/KIND.md: every key with its meaning");
  command.example("torquewright schema actuator");
  command.works([options] { return run_schema(*options); });
}

}  // namespace torquewright::cli
