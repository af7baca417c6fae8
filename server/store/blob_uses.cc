#include "server/store/blob_uses.h"

#include "base/hash.h"

namespace lares::store {
namespace {

void AddDocuments(Query& query, std::vector<BlobUse>& uses) {
  while (query.Next()) {
    BlobUse use;
    use.media_type = query.Text(0);
    use.file_name = query.Text(1);
    use.document_kind = query.Text(2);
    use.document = query.Text(3);
    uses.push_back(std::move(use));
  }
}

}  // namespace

std::vector<BlobUse> BlobUses(Database& database, const std::string& sha256) {
  std::vector<BlobUse> uses;
  if (!IsSha256Hex(sha256)) return uses;
  Query layers = database.Ask(
      "SELECT DISTINCT l.media_type, l.file_name, e.id FROM layers l "
      "JOIN environment_versions v ON v.key = l.version "
      "JOIN environments e ON e.key = v.environment WHERE l.sha256 = ?",
      {sha256});
  while (layers.Next()) {
    BlobUse use;
    use.media_type = layers.Text(0);
    use.file_name = layers.Text(1);
    use.environment = layers.Text(2);
    uses.push_back(std::move(use));
  }
  Query documents = database.Ask(
      "SELECT DISTINCT v.media_type, v.file_name, d.kind, d.id FROM document_versions v "
      "JOIN documents d ON d.key = v.document WHERE v.sha256 = ?",
      {sha256});
  AddDocuments(documents, uses);
  if (!uses.empty()) return uses;
  // Files beside an object model or a robot are told in its details, which the store does not
  // interpret.
  const std::string quoted = "%\"" + sha256 + "\"%";
  Query files = database.Ask(
      "SELECT DISTINCT '', '', d.kind, d.id FROM document_versions v "
      "JOIN documents d ON d.key = v.document "
      "WHERE d.kind IN ('object-model', 'robot') AND v.details LIKE ?",
      {quoted});
  AddDocuments(files, uses);
  return uses;
}

}  // namespace lares::store
