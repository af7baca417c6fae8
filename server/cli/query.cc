#include "server/cli/query.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <regex>

#include "ontology/rdf/vocabulary.h"
#include "server/cli/print.h"

namespace lares::cli {
namespace {

constexpr std::uintmax_t kMaxQuery = 1u << 20;

bool IsLocalName(std::string_view name) {
  if (name.empty() || name.back() == '.' || name.front() == '.' || name.front() == '-')
    return false;
  return std::all_of(name.begin(), name.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-' || c == '.';
  });
}

// Control characters and quotes escaped, so that a row stays on its line.
std::string Quote(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      quoted += std::string("\\") + c;
    } else if (c == '\n') {
      quoted += "\\n";
    } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
      char escape[8];
      std::snprintf(escape, sizeof escape, "\\u%04X", static_cast<unsigned>(c));
      quoted += escape;
    } else {
      quoted += c;
    }
  }
  return quoted + "\"";
}

}  // namespace

void AddQueryOptions(CLI::App& command, QueryOptions& query) {
  command.add_option("FILE", query.file, "file with the query; -: standard input");
  command.add_option("-q,--query", query.text, "the query itself");
  command.add_option("--recipe", query.recipe, "ask about this recipe too");
  command.add_option("--robot", query.robot, "ask about this robot too");
  command.add_option("--environment", query.environment, "ask about this environment too");
  command.add_option("--version", query.version, "of the environment (default: the newest)")
      ->check(CLI::PositiveNumber);
}

std::string ReadQuery(const QueryOptions& query) {
  if (!query.file.empty() && !query.text.empty()) {
    throw CLI::ValidationError("FILE", "give a file or -q, not both");
  }
  if (query.file == "-") {
    std::string text(std::istreambuf_iterator<char>(std::cin), {});
    if (text.size() > kMaxQuery) throw Error(Code::kTooLarge, "the query is larger than 1 MiB");
    return text;
  }
  return query.file.empty() ? query.text : ReadLocalFile(query.file, kMaxQuery);
}

std::multimap<std::string, std::string> AboutParameters(const QueryOptions& query) {
  std::multimap<std::string, std::string> parameters;
  const auto give = [&](const char* name, const std::string& value) {
    if (!value.empty()) parameters.emplace(name, value);
  };
  give("recipe", query.recipe);
  give("robot", query.robot);
  give("environment", query.environment);
  if (query.version > 0) give("version", std::to_string(query.version));
  return parameters;
}

TermPrinter::TermPrinter(const std::string& query) {
  prefix_by_namespace_ = {{std::string(rdf::kLares), "lares"},
                          {std::string(rdf::kRdf), "rdf"},
                          {std::string(rdf::kRdfs), "rdfs"},
                          {std::string(rdf::kOwl), "owl"},
                          {std::string(rdf::kXsd), "xsd"}};
  static const std::regex kPrefix(R"(prefix\s+([\w-]{0,64}):\s*<([^<>\s]{1,500})>)",
                                  std::regex::icase);
  const std::string head = query.substr(0, 16 * 1024);
  for (std::sregex_iterator match(head.begin(), head.end(), kPrefix), end; match != end; ++match) {
    prefix_by_namespace_[(*match)[2]] = (*match)[1];
  }
}

std::string TermPrinter::Shorten(const std::string& iri) const {
  const std::size_t cut = iri.find_last_of("#/:");
  if (cut != std::string::npos) {
    const auto found = prefix_by_namespace_.find(iri.substr(0, cut + 1));
    const std::string local = iri.substr(cut + 1);
    if (found != prefix_by_namespace_.end() && IsLocalName(local)) {
      return found->second + ":" + local;
    }
  }
  return "<" + iri + ">";
}

std::string TermPrinter::Print(const Json& term) const {
  if (term.is_boolean()) return term.get<bool>() ? "yes" : "no";
  const std::string type = TextOf(term, "type");
  const std::string value = TextOf(term, "value");
  if (type == "uri") return Shorten(value);
  if (type == "bnode") return "_:" + value;
  const std::string language = TextOf(term, "xml:lang");
  if (!language.empty()) return Quote(value) + "@" + language;
  const std::string datatype = Shorten(TextOf(term, "datatype"));
  for (const char* plain : {"xsd:integer", "xsd:decimal", "xsd:double", "xsd:boolean"}) {
    if (datatype == plain) return value;
  }
  return Quote(value) + (datatype == "<>" || datatype == "xsd:string" ? "" : "^^" + datatype);
}

std::string TermPrinter::PrintRow(const Json& row) const {
  if (!row.is_object()) return "";
  if (row.contains("boolean")) return Print(row["boolean"]);
  std::string text;
  for (const auto& [name, term] : row.items()) {
    text += (text.empty() ? "?" : ", ?") + name + " = " + Print(term);
  }
  return text.empty() ? "(nothing bound)" : text;
}

}  // namespace lares::cli
