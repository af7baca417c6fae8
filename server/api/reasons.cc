// Why something holds, why not, and how far apart two classes are.
#include <nlohmann/json.hpp>

#include "base/aside.h"
#include "base/error.h"
#include "reasoner/owl/on_demand.h"
#include "reasoner/owl/phrases.h"
#include "reasoner/owl/prover.h"
#include "reasoner/owl/taxonomy.h"
#include "reasoner/owl/why_not.h"
#include "server/api/answers.h"
#include "server/api/context.h"
#include "server/api/environments.h"
#include "server/http/media_type.h"
#include "server/http/problem.h"
#include "server/knowledge/terms.h"

namespace lares::api {
namespace {

using PlainJson = nlohmann::json;

struct Format {
  const char* name;  // of ?as=
  const char* media_type;
};
constexpr Format kProofFormats[] = {{"json", "application/json"},
                                    {"text", "text/plain"},
                                    {"svg", "image/svg+xml"},
                                    {"dot", "text/vnd.graphviz"}};
constexpr Format kLackFormats[] = {{"json", "application/json"}, {"text", "text/plain"}};

const Format& ChooseFormat(const http::Request& request, std::span<const Format> formats) {
  std::string names;
  std::vector<std::string> offered;
  for (const Format& format : formats) {
    names += std::string(names.empty() ? "" : ", ") + format.name;
    offered.emplace_back(format.media_type);
  }
  const auto as = request.Query("as");
  const auto accepted = http::ChooseMediaType(request.headers.GetList("Accept"), offered);
  for (const Format& format : formats) {
    if (as ? *as == format.name : accepted == format.media_type) return format;
  }
  if (as) throw Error(Code::kInvalid, "?as= is one of " + names + ", not '" + *as + "'");
  throw http::ProblemError("not-acceptable", "the answer is given as " + names);
}

rdf::View ViewAsked(const http::Request& request, Context& context) {
  server::ViewRequest view;
  view.recipe = request.Query("recipe").value_or("");
  view.robot = request.Query("robot").value_or("");
  view.environment = request.Query("environment").value_or("");
  view.environment_version = ChosenVersion(request, context.store, view.environment);
  return context.knowledge.ViewFor(view);
}

rdf::TermId TermAsked(const http::Request& request, const char* name, const rdf::View& view,
                      Context& context) {
  const auto text = request.Query(name);
  if (!text) throw Error(Code::kInvalid, "?" + std::string(name) + "= is missing");
  return server::ResolveTerm(view, context.knowledge.aliases(), *text);
}

rdf::Triple TripleAsked(const http::Request& request, const rdf::View& view, Context& context) {
  return {TermAsked(request, "subject", view, context),
          TermAsked(request, "predicate", view, context),
          TermAsked(request, "object", view, context)};
}

http::Response Answer(const Format& format, std::string body) {
  http::Response response;
  response.headers.Set("Content-Type", format.media_type);
  response.body = std::move(body);
  return response;
}

http::Response Why(const http::Request& request, Context& context) {
  const Format& format = ChooseFormat(request, kProofFormats);
  const rdf::View view = ViewAsked(request, context);
  owl::Prover prover(view);
  std::optional<owl::Proof> proof;
  if (request.Query("contradiction").value_or("") == "true") {
    proof = Aside([&] { return prover.WhyContradiction(); });
    if (!proof) throw Error(Code::kNotFound, "there is no contradiction");
  } else {
    const rdf::Triple triple = TripleAsked(request, view, context);
    proof = Aside([&] { return prover.Why(triple); });
    if (!proof) {
      throw Error(Code::kNotFound, "it does not hold that " + owl::PhraseOf(triple, view))
          .WithHint("why-not tells what is missing");
    }
  }
  const std::string name = format.name;
  if (name == "text") return Answer(format, owl::ToText(*proof, view));
  if (name == "svg") return Answer(format, owl::ToSvg(*proof, view));
  if (name == "dot") return Answer(format, owl::ToDot(*proof, view));
  return Answer(format, owl::ToJson(*proof, view));
}

http::Response WhyNot(const http::Request& request, Context& context) {
  const Format& format = ChooseFormat(request, kLackFormats);
  const rdf::View view = ViewAsked(request, context);
  const rdf::Triple triple = TripleAsked(request, view, context);
  if (owl::Holds(view, triple)) {
    throw Error(Code::kConflict, "it holds that " + owl::PhraseOf(triple, view))
        .WithHint("why tells what it follows from");
  }
  const std::vector<owl::Lack> lacks = Aside([&] { return owl::WhyNot(view, triple); });
  const bool as_text = std::string(format.name) == "text";
  return Answer(format,
                as_text ? owl::ToText(triple, lacks, view) : owl::ToJson(triple, lacks, view));
}

PlainJson Named(const rdf::View& view, rdf::TermId term) {
  return {{"iri", std::string(view.dictionary().Get(term).value)}, {"label", view.Label(term)}};
}

PlainJson ToJson(const std::optional<owl::Taxonomy::Way>& way, const rdf::View& view) {
  if (!way) return nullptr;
  PlainJson path = PlainJson::array();
  for (const rdf::TermId term : way->path) path.push_back(Named(view, term));
  return {{"edges", way->edges},
          {"similarity", way->similarity},
          {"common", Named(view, way->common)},
          {"path", path}};
}

http::Response Distances(const http::Request& request, Context& context) {
  const rdf::View view = ViewAsked(request, context);
  const rdf::TermId from = TermAsked(request, "from", view, context);
  const rdf::TermId to = TermAsked(request, "to", view, context);
  const owl::Taxonomy taxonomy(view);
  for (const rdf::TermId term : {from, to}) {
    if (!taxonomy.Contains(term)) {
      throw Error(Code::kNotFound, "'" + view.Label(term) + "' is no named class");
    }
  }
  const PlainJson json{{"from", Named(view, from)},
                       {"to", Named(view, to)},
                       {"rada", ToJson(taxonomy.Rada(from, to), view)},
                       {"wu_palmer", ToJson(taxonomy.WuPalmer(from, to), view)}};
  return Answer(kLackFormats[0], json.dump(2) + "\n");
}

}  // namespace

void AddReasonRoutes(http::Router& router, Context& context) {
  const auto add = [&](const char* path, const char* id,
                       http::Response (*answer)(const http::Request&, Context&)) {
    router.Add(
        {"GET",
         path,
         id,
         [&context, answer](const http::Request& request) { return answer(request, context); },
         {},
         0});
  };
  add("/v1/why", "explainTriple", &Why);
  add("/v1/why-not", "explainAbsence", &WhyNot);
  add("/v1/distances", "measureDistance", &Distances);
}

}  // namespace lares::api
