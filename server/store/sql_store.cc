#include "server/store/sql_store.h"

#include <optional>
#include <utility>

#include "base/error.h"
#include "base/hash.h"
#include "server/store/audit.h"
#include "server/store/blob_uses.h"
#include "server/store/copy.h"
#include "server/store/documents.h"
#include "server/store/environments.h"
#include "server/store/search.h"
#include "server/store/tags.h"
#include "server/store/tokens.h"
#include "server/store/verify.h"

namespace lares::store {

namespace fs = std::filesystem;

namespace {

// Enough for the database and small files; an upload that needs more finds out by itself.
constexpr std::uintmax_t kRoomBytes = std::uintmax_t{16} << 20;

bool HasRoom(const std::filesystem::path& folder) {
  std::error_code error;
  const std::filesystem::space_info space = std::filesystem::space(folder, error);
  return error || space.available >= kRoomBytes;
}

}  // namespace

SqlStore::SqlStore(const fs::path& blobs, Files& files, std::unique_ptr<FolderLock> lock)
    : lock_(std::move(lock)),
      blobs_(blobs, files, health_, lock_ ? BlobFolder::Use::kAlone : BlobFolder::Use::kShared),
      uploads_(blobs, files, health_, blobs_) {
  health_.WatchRoom([blobs] { return HasRoom(blobs); });
}

template <typename Function>
auto SqlStore::Read(Function function) const {
  std::optional<decltype(function(std::declval<Database&>()))> result;
  Reading([&](Database& database) { result.emplace(function(database)); });
  return *std::move(result);
}

template <typename Function>
auto SqlStore::Write(Function function) {
  std::optional<decltype(function(std::declval<Database&>()))> result;
  Writing([&](Database& database) {
    result.emplace(function(database));
    database.Run("UPDATE store_state SET value = value + 1 WHERE name = 'revision'");
  });
  return *std::move(result);
}

std::unique_ptr<BlobWriter> SqlStore::NewBlob() { return blobs_.New(); }

fs::path SqlStore::BlobPath(const std::string& sha256) const { return blobs_.PathOf(sha256); }

std::string SqlStore::ReadBlob(const std::string& sha256) const { return blobs_.Read(sha256); }

DocumentInfo SqlStore::PutDocument(const NewDocument& document) {
  CheckNewDocument(document);
  health_.Check();
  const std::string sha256 = Sha256Hex(document.bytes);
  const auto already_stored = [&](Database& database) {
    return AlreadyStored(database, document, sha256);
  };
  // Asked before the bytes are written, so that refusals and repetitions leave nothing behind, and
  // again in the transaction, where it counts.
  if (std::optional<DocumentInfo> same = Read(already_stored)) return *std::move(same);
  const Blob blob = blobs_.Put(document.bytes);
  return Write([&](Database& database) {
    if (std::optional<DocumentInfo> same = already_stored(database)) return *std::move(same);
    return AddDocument(database, document, blob);
  });
}

std::optional<DocumentInfo> SqlStore::FindDocument(DocumentKind kind, const std::string& id) const {
  return Read([&](Database& database) { return store::FindDocument(database, kind, id); });
}

DocumentInfo SqlStore::GetDocument(DocumentKind kind, const std::string& id, int version) const {
  return Read([&](Database& database) { return store::GetDocument(database, kind, id, version); });
}

std::vector<DocumentInfo> SqlStore::ListDocuments(DocumentKind kind) const {
  return Read([&](Database& database) { return store::ListDocuments(database, kind); });
}

std::vector<DocumentInfo> SqlStore::DocumentLog(DocumentKind kind, const std::string& id) const {
  return Read([&](Database& database) { return store::DocumentLog(database, kind, id); });
}

void SqlStore::DeleteDocument(DocumentKind kind, const std::string& id) {
  Write([&](Database& database) {
    store::DeleteDocument(database, kind, id);
    return true;
  });
}

std::vector<std::pair<DocumentInfo, DocumentName>> SqlStore::FindByName(
    DocumentKind kind, const std::string& text) const {
  return Read([&](Database& database) { return store::FindByName(database, kind, text); });
}

EnvironmentVersion SqlStore::PutVersion(const NewVersion& version) {
  CheckNewVersion(version);
  if (version.keys) CheckKeys(*version.keys);
  health_.Check();
  NewVersion sized = version;
  for (LayerInfo& layer : sized.layers) {
    layer.blob.size = blobs_.SizeOf(layer.blob.sha256);
    blobs_.MakeDurable(layer.blob.sha256);
  }
  return Write([&](Database& database) {
    EnvironmentVersion added = AddVersion(database, sized);
    MarkWritten(database, version.request_key, version.request_fingerprint,
                added.environment + "/" + std::to_string(added.number));
    return added;
  });
}

std::optional<EnvironmentInfo> SqlStore::FindEnvironment(const std::string& id) const {
  return Read([&](Database& database) { return store::FindEnvironment(database, id); });
}

std::vector<EnvironmentInfo> SqlStore::ListEnvironments() const {
  return Read([&](Database& database) { return store::ListEnvironments(database); });
}

EnvironmentVersion SqlStore::GetVersion(const std::string& id, int number) const {
  return Read([&](Database& database) { return store::GetVersion(database, id, number); });
}

std::vector<EnvironmentVersion> SqlStore::Log(const std::string& id) const {
  return Read([&](Database& database) { return EnvironmentLog(database, id); });
}

int SqlStore::VersionAsOf(const std::string& id, Time time) const {
  return Read([&](Database& database) { return store::VersionAsOf(database, id, time); });
}

std::vector<EnvironmentInfo> SqlStore::SearchEnvironments(const EnvironmentSearch& search) const {
  CheckSearch(search);
  return Read([&](Database& database) { return store::SearchEnvironments(database, search); });
}

std::vector<std::string> SqlStore::SearchValues(const std::string& field) const {
  return Read([&](Database& database) { return store::SearchValues(database, field); });
}

std::vector<std::string> SqlStore::EnvironmentsWithoutKeys() const {
  return Read([](Database& database) { return store::EnvironmentsWithoutKeys(database); });
}

void SqlStore::PutKeys(const std::string& id, int number, const std::vector<SearchKey>& keys) {
  CheckKeys(keys);
  Write([&](Database& database) {
    store::PutKeys(database, id, number, keys);
    return true;
  });
}

Tag SqlStore::PutTag(const Tag& tag, bool move) {
  CheckTag(tag);
  return Write([&](Database& database) { return store::PutTag(database, tag, move); });
}

void SqlStore::DeleteTag(const std::string& environment, const std::string& name) {
  Write([&](Database& database) {
    store::DeleteTag(database, environment, name);
    return true;
  });
}

std::optional<Tag> SqlStore::FindTag(const std::string& environment,
                                     const std::string& name) const {
  return Read([&](Database& database) { return store::FindTag(database, environment, name); });
}

std::vector<Tag> SqlStore::Tags(const std::string& environment) const {
  return Read([&](Database& database) { return store::Tags(database, environment); });
}

Pin SqlStore::PutPin(const Pin& pin) {
  CheckPin(pin);
  return Write([&](Database& database) { return store::PutPin(database, pin); });
}

void SqlStore::DeletePin(const std::string& robot, const std::string& environment) {
  Write([&](Database& database) {
    store::DeletePin(database, robot, environment);
    return true;
  });
}

std::optional<Pin> SqlStore::FindPin(const std::string& robot,
                                     const std::string& environment) const {
  return Read([&](Database& database) { return store::FindPin(database, robot, environment); });
}

std::vector<Pin> SqlStore::Pins(const std::string& robot) const {
  return Read([&](Database& database) { return store::Pins(database, robot); });
}

std::vector<BlobUse> SqlStore::BlobUses(const std::string& sha256) const {
  return Read([&](Database& database) { return store::BlobUses(database, sha256); });
}

KeyRecord SqlStore::Take(const std::string& key) {
  return Write([&](Database& database) { return TakeKey(database, key, Now(), {}); });
}

void SqlStore::Finish(const std::string& key, const KeyRecord& answer) {
  Write([&](Database& database) {
    FinishKey(database, key, answer);
    if (finished_keys_++ % 64 == 0) PruneKeys(database, {});
    return true;
  });
}

void SqlStore::Release(const std::string& key) {
  Write([&](Database& database) {
    ReleaseKey(database, key);
    return true;
  });
}

std::int64_t SqlStore::Revision() const {
  return Read([](Database& database) {
    return database.AskInt("SELECT value FROM store_state WHERE name = 'revision'");
  });
}

BackupReport SqlStore::Backup(const fs::path& folder, const Progress& progress) {
  BackupTarget target(folder);
  // The rows of one moment; the blobs that they refer to are never changed, and take longer.
  Reading([&](Database& database) { target.CopyRows(database); });
  target.CopyBlobs(blobs_.folder(), progress);
  return target.Finish();
}

std::string SqlStore::Digest() const {
  return Read([](Database& database) { return DigestOf(database); });
}

BackupReport SqlStore::FillFrom(const fs::path& backup, const Progress& progress) {
  const BackupSource source(backup);
  source.CopyBlobs(blobs_, progress);
  return Write([&](Database& database) { return source.CopyRows(database); });
}

void SqlStore::AddToken(const TokenRecord& token) {
  Write([&](Database& database) {
    store::AddToken(database, token);
    return true;
  });
}

std::optional<TokenRecord> SqlStore::FindToken(const std::string& id) const {
  return Read([&](Database& database) { return store::FindToken(database, id); });
}

std::vector<TokenRecord> SqlStore::ListTokens() const {
  return Read([](Database& database) { return store::ListTokens(database); });
}

bool SqlStore::HasTokens() const {
  return Read([](Database& database) { return store::HasTokens(database); });
}

TokenRecord SqlStore::RevokeToken(const std::string& id, Time when) {
  return Write([&](Database& database) { return store::RevokeToken(database, id, when); });
}

void SqlStore::AddAudit(const AuditRecord& record) {
  Write([&](Database& database) {
    store::AddAudit(database, record);
    return true;
  });
}

std::vector<AuditRecord> SqlStore::ListAudit(const AuditQuery& query) const {
  return Read([&](Database& database) { return store::ListAudit(database, query); });
}

std::uint64_t SqlStore::BytesStoredSince(const std::string& token, Time since) const {
  return Read([&](Database& database) { return store::BytesStoredSince(database, token, since); });
}

std::string SqlStore::health() const { return health_.reason(); }

std::vector<std::string> SqlStore::Verify() const {
  std::vector<std::string> problems = Read([&](Database& database) {
    std::vector<std::string> found = VerifyFile(database);
    for (std::string& problem : VerifyRows(database, blobs_)) found.push_back(std::move(problem));
    return found;
  });
  const std::vector<std::string> damaged = blobs_.Verify();
  problems.insert(problems.end(), damaged.begin(), damaged.end());
  return problems;
}

}  // namespace lares::store
