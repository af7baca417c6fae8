#include "server/http/problem.h"

#include <nlohmann/json.hpp>
#include <utility>

namespace lares::http {
namespace {

using Json = nlohmann::ordered_json;

Json PlaceToJson(const Place& place) {
  Json json = Json::object();
  if (!place.source.empty()) json["source"] = place.source;
  if (place.line > 0) json["line"] = place.line;
  if (place.column > 0) json["column"] = place.column;
  return json;
}

void MergeMembers(const ProblemError& error, Json& document) {
  if (error.members_json().empty()) return;
  const Json members = Json::parse(error.members_json());
  for (const auto& [name, value] : members.items()) {
    if (!document.contains(name)) document[name] = value;
  }
}

}  // namespace

const std::vector<ProblemKind>& ProblemKinds() {
  static const std::vector<ProblemKind> kinds = {
      // One for each lares::Code.
      {"invalid", 422, "The input is not valid"},
      {"not-found", 404, "There is nothing of that name"},
      {"ambiguous", 409, "The name means several things"},
      {"conflict", 409, "It conflicts with what is there"},
      {"precondition-failed", 412, "It has changed meanwhile"},
      {"too-large", 413, "It is larger than allowed"},
      {"timeout", 504, "It took longer than allowed"},
      {"unsupported", 415, "That format is not supported"},
      {"forbidden", 403, "That is not allowed from there"},
      {"unavailable", 503, "The server cannot do that now"},
      {"io", 500, "A file or connection failed"},
      {"internal", 500, "A fault inside the server"},
      // Of the protocol.
      {"bad-request", 400, "The request is malformed"},
      {"method-not-allowed", 405, "That method is not allowed here"},
      {"not-acceptable", 406, "None of the accepted formats can be given"},
      {"request-timeout", 408, "The request came too slowly"},
      {"length-unknown", 411, "The request does not say how long its body is"},
      {"uri-too-long", 414, "The address is too long"},
      {"range-not-satisfiable", 416, "The range lies outside of the content"},
      {"headers-too-large", 431, "The request's headers are too large"},
      // Of access.
      {"token-missing", 401, "A token is needed"},
      {"token-invalid", 401, "That token is not known here"},
      {"token-expired", 401, "The token has expired"},
      {"token-revoked", 401, "The token was revoked"},
      {"role-too-low", 403, "The token's role does not allow that"},
      {"too-many-requests", 429, "The token asks more often than it may"},
      {"too-many-bytes", 429, "The token has stored as much as it may today"},
      {"too-many-queries", 429, "The token runs as many queries as it may at once"},
      // Of requests that are sent again.
      {"idempotency-key-reused", 422, "That key belongs to another request"},
      {"request-in-progress", 409, "The same request is being answered"},
      // Of resumable uploads (tus 1.0).
      {"tus-version", 412, "That version of tus is not supported"},
      {"upload-locked", 423, "Another request uses the upload"},
      {"checksum-mismatch", 460, "The bytes are not those of the checksum"},
      // Of documents: well written, but not to be taken.
      {"foreign-term", 422, "It says new things about terms of others"},
      {"contradiction", 422, "It contradicts what is known"},
      // Of versions.
      {"merge-conflict", 409, "Both versions changed the same"},
      // Of plans: the question was understood, and the answer is no.
      {"not-feasible", 422, "The robot cannot do that"},
      {"choice-needed", 422, "A person has to choose"},
      {"recipe-unusable", 422, "The recipe gives no plan"},
      // Of Prolog goals.
      {"goal-error", 422, "The goal ended with an error"},
  };
  return kinds;
}

const ProblemKind& FindProblemKind(std::string_view code) {
  for (const ProblemKind& kind : ProblemKinds()) {
    if (kind.code == code) return kind;
  }
  throw Error(Code::kInternal, "no problem kind '" + std::string(code) + "'");
}

ProblemError::ProblemError(std::string_view problem_code, const std::string& message)
    : Error(Code::kInvalid, message), problem_code_(problem_code) {
  FindProblemKind(problem_code);
}

ProblemError::ProblemError(std::string_view problem_code, const std::string& message, Place place)
    : Error(Code::kInvalid, message, std::move(place)), problem_code_(problem_code) {
  FindProblemKind(problem_code);
}

Response ToProblem(const Error& error, const std::string& request_id) {
  const auto* problem = dynamic_cast<const ProblemError*>(&error);
  const ProblemKind& kind =
      FindProblemKind(problem != nullptr ? problem->problem_code() : ToString(error.code()));
  Json document;
  document["type"] = std::string(kProblemBase) + std::string(kind.code);
  document["title"] = kind.title;
  document["status"] = kind.status;
  document["detail"] = error.what();
  document["code"] = kind.code;
  document["instance"] = request_id;
  if (error.place()) document["place"] = PlaceToJson(*error.place());
  if (!error.hint().empty()) document["hint"] = error.hint();
  if (!error.candidates().empty()) document["candidates"] = error.candidates();
  if (problem != nullptr) MergeMembers(*problem, document);
  Response response;
  response.status = kind.status;
  if (problem != nullptr) response.headers = problem->headers();
  response.headers.Set("Content-Type", "application/problem+json");
  response.body = document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  return response;
}

}  // namespace lares::http
