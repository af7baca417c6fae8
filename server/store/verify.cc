#include "server/store/verify.h"

#include "base/error.h"

namespace lares::store {
namespace {

using Problems = std::vector<std::string>;

// Documents' versions are numbered 1 … latest, environments' 1 … count, the head among them.
void VerifyNumbers(Database& database, Problems& problems) {
  constexpr std::string_view kGaps[] = {
      "SELECT d.kind || ' ' || d.id, d.latest, count(v.key), coalesce(max(v.number), 0) "
      "FROM documents d LEFT JOIN document_versions v ON v.document = d.key "
      "GROUP BY d.key HAVING count(v.key) <> d.latest OR coalesce(max(v.number), 0) <> d.latest "
      "OR min(v.number) <> 1",
      "SELECT 'environment ' || e.id, e.count, count(v.key), coalesce(max(v.number), 0) "
      "FROM environments e LEFT JOIN environment_versions v ON v.environment = e.key "
      "GROUP BY e.key HAVING count(v.key) <> e.count OR coalesce(max(v.number), 0) <> e.count "
      "OR min(v.number) <> 1 OR e.latest > e.count OR e.latest < 1"};
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
      "WHERE n.current <> CASE WHEN v.number = d.latest AND d.deleted = 0 THEN 1 ELSE 0 END");
  while (query.Next()) {
    problems.push_back(query.Text(0) + " " + query.Text(1) + " version " + query.Text(2) +
                       ": name '" + query.Text(3) + "' is wrongly current or not current");
  }
}

// Tags, pins and parents name versions that there are.
void VerifyNumbersNamed(Database& database, Problems& problems) {
  constexpr std::string_view kNamed[] = {
      "SELECT 'tag ' || t.name || ' of environment ' || t.environment, t.number FROM tags t "
      "JOIN environments e ON e.id = t.environment WHERE t.number < 1 OR t.number > e.count",
      "SELECT 'the pin of robot ' || p.robot || ' in environment ' || p.environment, p.number "
      "FROM pins p JOIN environments e ON e.id = p.environment "
      "WHERE p.number < 1 OR p.number > e.count",
      "SELECT 'environment ' || e.id, v.base FROM environment_versions v JOIN environments e "
      "ON e.key = v.environment WHERE v.base < 0 OR v.base >= v.number"};
  for (const std::string_view sql : kNamed) {
    Query query = database.Ask(sql);
    while (query.Next()) {
      problems.push_back(query.Text(0) + " refers to version " + query.Text(1) +
                         ", which there is not");
    }
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

std::vector<std::string> VerifyRows(Database& database, const BlobFolder& blobs) {
  Problems problems;
  VerifyNumbers(database, problems);
  VerifyLayers(database, problems);
  VerifyNames(database, problems);
  VerifyNumbersNamed(database, problems);
  VerifyReferences(database, blobs, problems);
  return problems;
}

}  // namespace lares::store
