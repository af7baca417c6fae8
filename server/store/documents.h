// Documents and their versions in the database. Each function runs in the caller's transaction.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "server/store/database.h"
#include "server/store/store.h"

namespace lares::store {

// Throws kInvalid when the id or a text cannot be stored.
void CheckNewDocument(const NewDocument& document);

// Throws kPreconditionFailed when `if_match` does not hold. The current version when it has the
// same bytes (`sha256`), media type and file name already; nothing when a version is to be added.
std::optional<DocumentInfo> AlreadyStored(Database& database, const NewDocument& document,
                                          const std::string& sha256);

// Adds the next version, its bytes being in `blob`.
DocumentInfo AddDocument(Database& database, const NewDocument& document, const Blob& blob);

// As the members of Store.
std::optional<DocumentInfo> FindDocument(Database& database, DocumentKind kind,
                                         const std::string& id);
DocumentInfo GetDocument(Database& database, DocumentKind kind, const std::string& id, int version);
std::vector<DocumentInfo> ListDocuments(Database& database, DocumentKind kind);
std::vector<DocumentInfo> DocumentLog(Database& database, DocumentKind kind, const std::string& id);
void DeleteDocument(Database& database, DocumentKind kind, const std::string& id);
std::vector<std::pair<DocumentInfo, DocumentName>> FindByName(Database& database, DocumentKind kind,
                                                              const std::string& text);

}  // namespace lares::store
