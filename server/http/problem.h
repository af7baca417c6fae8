// Faults as RFC 9457 problem documents: the one table from code to status.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "server/http/message.h"

namespace lares::http {

struct ProblemKind {
  std::string_view code;  // stable; the type is kProblemBase + code
  int status = 500;
  std::string_view title;
};

inline constexpr std::string_view kProblemBase = "https://w3id.org/lares/problems/";

// Every kind that the interface can answer: one for each Code, and those of the protocol itself.
const std::vector<ProblemKind>& ProblemKinds();
// Throws kInternal for a code that is not in the table.
const ProblemKind& FindProblemKind(std::string_view code);

// A fault that says more than an Error: its own code of the table, further members of the problem
// document, further headers.
class ProblemError : public Error {
 public:
  ProblemError(std::string_view problem_code, const std::string& message);
  ProblemError(std::string_view problem_code, const std::string& message, Place place);

  const std::string& problem_code() const { return problem_code_; }
  // A JSON object whose members join the document's; "" for none.
  const std::string& members_json() const { return members_json_; }
  ProblemError& WithMembers(std::string json) {
    members_json_ = std::move(json);
    return *this;
  }
  const Headers& headers() const { return headers_; }
  ProblemError& WithHeader(std::string_view name, std::string value) {
    headers_.Set(name, std::move(value));
    return *this;
  }

 private:
  std::string problem_code_;
  std::string members_json_;
  Headers headers_;
};

// The document: type, title, status, detail, code, instance (the request's id), and where known
// place {source, line, column}, hint, candidates and the members of a ProblemError.
Response ToProblem(const Error& error, const std::string& request_id);

}  // namespace lares::http
