// SPDX-License-Identifier: Apache-2.0
#include "src/commands/gearbox/gearbox_result_json.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "gearbox/problem_spec.hpp"
#include "gearbox/search/result_spec.hpp"
#include "gearbox/strength/problem_strength.hpp"
#include "io/documents/json_reader.hpp"
#include "io/files/file_bytes.hpp"
#include "src/commands/shared/result_json.hpp"
#include "src/commands/shared/stated_json.hpp"
#include "src/interrupt.hpp"
#include "src/report/gearbox/proof_json.hpp"

namespace torquewright::cli {
namespace {

void refuse_evaluation(const nlohmann::json& result, const std::string& file) {
  if (!result.is_object() || !result.contains("rank")) return;
  throw io::SpecError({{file, "/certificate",
                        "holds no claims: this is what `gearbox evaluate` says of one design; "
                        "`gearbox verify` checks the proof in a result of `gearbox optimize`"}});
}

}  // namespace

std::string optimization_json(const OptimizeRequest& request, const ReadProblem& read,
                              const gearbox::DesignSearchResult& found, double seconds) {
  nlohmann::ordered_json result = gearbox::result_json(read.problem, found);
  result["held_fixed"] = gearbox::held_fixed(read.problem);
  result["not_asked"] = gearbox::not_asked(read.problem, found.designs);
  if (request.timing) result["search"]["seconds"] = seconds;
  result["problem"] = read.document.root;
  add_provenance(result, {&read.document, 1});
  result["options"] = stated_json(*request.declared);
  return io::json_text(result);
}

std::string evaluation_json(const ReadProblem& read, const gearbox::DesignReport& report,
                            const gearbox::Standing& standing) {
  nlohmann::ordered_json result = gearbox::evaluation_json(read.problem, report, standing);
  result["problem"] = read.document.root;
  return result_text(std::move(result), {&read.document, 1});
}

std::string with_verdict(const std::string& result, const gearbox::Verification& check) {
  nlohmann::ordered_json printed = nlohmann::ordered_json::parse(result);
  printed["verification"] = report::proof_json(check);
  return io::json_text(printed);
}

gearbox::Verification verified_result(const std::string& text) {
  const nlohmann::json result = as_read(text);
  const io::Document problem =
      io::check_document(result["problem"], "gearbox_problem", "the result", "/problem");
  return gearbox::verify(gearbox::read_open_problem(problem), result, is_interrupted);
}

io::Document read_result(const std::string& file) {
  io::JsonText text = io::read_json_text(io::read_file_bytes(file), file);
  if (!text.faults.empty()) throw io::SpecError(std::move(text.faults));
  refuse_evaluation(text.root, file);
  return io::check_document(std::move(text.root), "gearbox_result", file, "");
}

}  // namespace torquewright::cli
