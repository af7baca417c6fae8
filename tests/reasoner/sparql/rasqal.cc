#include "tests/reasoner/sparql/rasqal.h"

#include <sys/wait.h>

#include <cstdlib>

#include "base/error.h"

namespace lares::sparql::testing {
namespace {

std::string Quoted(const std::string& text) { return " '" + text + "'"; }

}  // namespace

bool HasRoqet() { return std::system("command -v roqet >/dev/null") == 0; }

std::optional<Expected> AskRasqal(const std::filesystem::path& query, const std::string& base_iri,
                                  const std::vector<std::filesystem::path>& data,
                                  const std::vector<std::filesystem::path>& graphs, Form form,
                                  const std::filesystem::path& folder) {
  const bool is_graph = form == Form::kConstruct || form == Form::kDescribe;
  const std::filesystem::path answer = folder / (is_graph ? "answer.nt" : "answer.srx");
  std::string command = "timeout -s KILL 10 roqet -q -i sparql11-query -r ";
  command += is_graph ? "ntriples" : "xml";
  for (const auto& file : data) command += " -D" + Quoted(file.string());
  for (const auto& file : graphs) command += " -G" + Quoted(file.string());
  command += Quoted(query.string()) + Quoted(base_iri) + " >" + Quoted(answer.string());
  command += " 2>/dev/null";
  const int status = std::system(command.c_str());
  const bool is_done = WIFEXITED(status) && (WEXITSTATUS(status) == 0 || WEXITSTATUS(status) == 2);
  if (!is_done) return std::nullopt;  // 2 is a warning: a variable is used only once
  try {
    return ReadExpected(answer, base_iri, form);
  } catch (const Error&) {
    return std::nullopt;  // it wrote nothing, or no result
  }
}

}  // namespace lares::sparql::testing
