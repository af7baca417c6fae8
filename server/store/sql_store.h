// A store over some database and a folder of blobs: everything but the database's own ways.
// Private to this folder and its tests.
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include "server/store/blobs.h"
#include "server/store/database.h"
#include "server/store/folder_lock.h"
#include "server/store/health.h"
#include "server/store/idempotency.h"
#include "server/store/store.h"
#include "server/store/uploads.h"

namespace lares::store {

class SqlStore : public Store, public IdempotencyKeys {
 public:
  std::unique_ptr<BlobWriter> NewBlob() override;
  std::filesystem::path BlobPath(const std::string& sha256) const override;
  std::string ReadBlob(const std::string& sha256) const override;

  DocumentInfo PutDocument(const NewDocument& document) override;
  std::optional<DocumentInfo> FindDocument(DocumentKind kind, const std::string& id) const override;
  DocumentInfo GetDocument(DocumentKind kind, const std::string& id, int version) const override;
  std::vector<DocumentInfo> ListDocuments(DocumentKind kind) const override;
  std::vector<DocumentInfo> DocumentLog(DocumentKind kind, const std::string& id) const override;
  void DeleteDocument(DocumentKind kind, const std::string& id) override;
  std::vector<std::pair<DocumentInfo, DocumentName>> FindByName(
      DocumentKind kind, const std::string& text) const override;

  EnvironmentVersion PutVersion(const NewVersion& version) override;
  std::optional<EnvironmentInfo> FindEnvironment(const std::string& id) const override;
  std::vector<EnvironmentInfo> ListEnvironments() const override;
  EnvironmentVersion GetVersion(const std::string& id, int number) const override;
  std::vector<EnvironmentVersion> Log(const std::string& id) const override;
  int VersionAsOf(const std::string& id, Time time) const override;

  std::vector<EnvironmentInfo> SearchEnvironments(const EnvironmentSearch& search) const override;
  std::vector<std::string> SearchValues(const std::string& field) const override;
  std::vector<std::string> EnvironmentsWithoutKeys() const override;
  void PutKeys(const std::string& id, int number, const std::vector<SearchKey>& keys) override;

  Tag PutTag(const Tag& tag, bool move) override;
  void DeleteTag(const std::string& environment, const std::string& name) override;
  std::optional<Tag> FindTag(const std::string& environment,
                             const std::string& name) const override;
  std::vector<Tag> Tags(const std::string& environment) const override;
  Pin PutPin(const Pin& pin) override;
  void DeletePin(const std::string& robot, const std::string& environment) override;
  std::optional<Pin> FindPin(const std::string& robot,
                             const std::string& environment) const override;
  std::vector<Pin> Pins(const std::string& robot) const override;

  std::vector<BlobUse> BlobUses(const std::string& sha256) const override;
  Uploads& uploads() override { return uploads_; }
  IdempotencyKeys& idempotency_keys() override { return *this; }
  KeyRecord Take(const std::string& key) override;
  void Finish(const std::string& key, const KeyRecord& answer) override;
  void Release(const std::string& key) override;

  std::int64_t Revision() const override;
  BackupReport Backup(const std::filesystem::path& folder, const Progress& progress) override;
  std::string Digest() const override;
  BackupReport FillFrom(const std::filesystem::path& backup, const Progress& progress) override;

  void AddToken(const TokenRecord& token) override;
  std::optional<TokenRecord> FindToken(const std::string& id) const override;
  std::vector<TokenRecord> ListTokens() const override;
  bool HasTokens() const override;
  TokenRecord RevokeToken(const std::string& id, Time when) override;
  void AddAudit(const AuditRecord& record) override;
  std::vector<AuditRecord> ListAudit(const AuditQuery& query) const override;
  std::uint64_t BytesStoredSince(const std::string& token, Time since) const override;

  std::string health() const override;
  std::vector<std::string> Verify() const override;

 protected:
  // `lock`: what keeps others from the folder, when it is this process's alone; null: it is shared.
  SqlStore(const std::filesystem::path& blobs, Files& files, std::unique_ptr<FolderLock> lock);

  using Work = std::function<void(Database&)>;
  // Runs `work` in one snapshot.
  virtual void Reading(const Work& work) const = 0;
  // Runs `work` in one transaction, durable when this returns; its faults judged by `health_`.
  virtual void Writing(const Work& work) = 0;
  // What only this kind of database can be asked about itself.
  virtual std::vector<std::string> VerifyFile(Database& database) const = 0;

  mutable Health health_;

 private:
  template <typename Function>
  auto Read(Function function) const;
  template <typename Function>
  auto Write(Function function);

  std::unique_ptr<FolderLock> lock_;
  BlobFolder blobs_;
  Uploads uploads_;
  std::atomic<unsigned> finished_keys_ = 0;
};

}  // namespace lares::store
