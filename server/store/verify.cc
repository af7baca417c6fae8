#include "server/store/verify.h"

#include "base/error.h"

namespace lares::store {
namespace {

using Problems = std::vector<std::string>;

void VerifyFile(Database& database, Problems& problems) {
  Query pages = database.Ask("PRAGMA integrity_check");
  while (pages.Next()) {
    if (pages.Text(0) != "ok") problems.push_back("database: " + pages.Text(0));
  }
  Query keys = database.Ask("PRAGMA foreign_key_check");
  while (keys.Next()) {
    problems.push_back("database: a row of " + keys.Text(0) + " refers to no row of " +
                       keys.Text(2));
  }
}

// Versions are numbered 1 … latest.
void VerifyNumbers(Database& database, Problems& problems) {
  constexpr std::string_view kGaps[] = {
      "SELECT d.kind || ' ' || d.id, d.latest, count(v.key), coalesce(max(v.number), 0) "
      "FROM documents d LEFT JOIN document_versions v ON v.document = d.key "
      "GROUP BY d.key HAVING count(v.key) <> d.latest OR coalesce(max(v.number), 0) <> d.latest "
      "OR min(v.number) <> 1",
      "SELECT 'environment ' || e.id, e.latest, count(v.key), coalesce(max(v.number), 0) "
      "FROM environments e LEFT JOIN environment_versions v ON v.environment = e.key "
      "GROUP BY e.key HAVING count(v.key) <> e.latest OR coalesce(max(v.number), 0) <> e.latest "
      "OR min(v.number) <> 1"};
  for (const std::string_view sql : kGaps) {
    Query query = database.Ask(sql);
    while (query.Next()) {
      problems.push_back(query.Text(0) + " should have versions 1 to " + query.Text(1) + ", has " +
                         query.Text(2) + " up to " + query.Text(3));
    }
  }
}

void VerifyLayers(Database& database, Problems& problems) {
  Query query = database.Ask(
      "SELECT e.id, v.number FROM environments e JOIN environment_versions v "
      "ON v.environment = e.key WHERE NOT EXISTS (SELECT 1 FROM layers l WHERE l.version = v.key)");
  while (query.Next()) {
    problems.push_back("environment " + query.Text(0) + " version " + query.Text(1) +
                       " has no layer");
  }
}

// Exactly the names of newest versions of documents that are not deleted are current.
void VerifyNames(Database& database, Problems& problems) {
  Query query = database.Ask(
      "SELECT d.kind, d.id, v.number, n.text FROM document_names n "
      "JOIN document_versions v ON v.key = n.version JOIN documents d ON d.key = v.document "
      "WHERE n.current <> (v.number = d.latest AND d.deleted = 0)");
  while (query.Next()) {
    problems.push_back(query.Text(0) + " " + query.Text(1) + " version " + query.Text(2) +
                       ": name '" + query.Text(3) + "' is wrongly current or not current");
  }
}

void VerifyReferences(Database& database, const BlobFolder& blobs, Problems& problems) {
  Query query = database.Ask(
      "SELECT sha256, size FROM document_versions UNION SELECT sha256, size FROM layers");
  while (query.Next()) {
    const std::string sha256 = query.Text(0);
    try {
      const std::uint64_t size = blobs.SizeOf(sha256);
      if (size != static_cast<std::uint64_t>(query.Int(1))) {
        problems.push_back("blob '" + sha256 + "' has " + std::to_string(size) + " bytes, not " +
                           query.Text(1));
      }
    } catch (const Error& error) {
      problems.push_back(std::string("a row refers to a blob, but ") + error.what());
    }
  }
}

}  // namespace

std::vector<std::string> VerifyDatabase(Database& database, const BlobFolder& blobs) {
  Problems problems;
  VerifyFile(database, problems);
  VerifyNumbers(database, problems);
  VerifyLayers(database, problems);
  VerifyNames(database, problems);
  VerifyReferences(database, blobs, problems);
  return problems;
}

}  // namespace lares::store
