// What all kinds of documents have in common over HTTP: put, list, get, delete, versions.
#pragma once

#include <string>
#include <vector>

#include "server/api/context.h"
#include "server/http/message.h"

namespace lares::api {

inline constexpr std::uint64_t kMaxDocumentBytes = 256u << 20;

// The media types that RDF documents come in; "application/octet-stream" lets the file name or
// the first bytes tell, "multipart/form-data" carries the document as its part "file".
const std::vector<std::string>& RdfUploadTypes();

// A document as it was sent: raw with ?file_name= (or Content-Disposition), or as a form.
struct Upload {
  std::string media_type;  // "" when the type says nothing
  std::string file_name;
  std::string bytes;
  std::string id;  // of the route, of ?id=, of a form's field "id", else the file name's stem
};
// Throws kInvalid when there is neither an id nor a file name, unless none is needed.
Upload ReadUpload(const http::Request& request, bool needs_id = true);

// The request as PutRequest without the kind's own fields: If-Match, ?recover= and the upload.
server::PutRequest ToPutRequest(store::DocumentKind kind, const http::Request& request,
                                const store::Store& store);

// 201 for a first version, 200 for a later one, with ETag and Location; 202 for one kept aside,
// with the Location of that.
http::Response PutAnswerToResponse(const server::PutAnswer& answer, const std::string& collection,
                                   bool existed);

// Registers PUT and DELETE {collection}/{id}, POST and GET {collection}, GET {collection}/{id} (the
// bytes as received, ?version=; ?as=info the description) and GET {collection}/{id}/versions.
// `noun` names the operations: "recipe" → putRecipe, listRecipes, ….
struct DocumentRoutes {
  store::DocumentKind kind;
  std::string collection;  // "/v1/recipes"
  std::string noun;        // "Recipe"
  std::string nouns;       // "Recipes"
};
void AddDocumentPutRoutes(const DocumentRoutes& routes, http::Router& router, Context& context);
void AddDocumentReadRoutes(const DocumentRoutes& routes, http::Router& router, Context& context);

}  // namespace lares::api
