// Who may say what, among our modules, the stored ontologies and everything else.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "base/time.h"
#include "reasoner/authority/authority.h"

namespace lares::server {

// The owners of terms. Our own modules came first; then stored ontologies, in the order of their
// first versions. Recipes, robots, environments and object models own what none of these declares.
// Thread-safe.
class Authority {
 public:
  // Of our own modules alone: `own` is their layer.
  void SetOwn(const rdf::View& own);

  // A stored ontology: a later version keeps the place of its first one.
  void Put(const std::string& id, authority::Claim claim, Time first, bool by_editor);
  void Remove(const std::string& id);

  std::shared_ptr<const authority::Owners> owners() const;
  // Whether the stored ontology with this graph was sent with editor rights.
  bool IsByEditor(const std::string& graph) const;
  std::shared_ptr<const authority::Owners> own() const { return own_; }
  // With `claim` in its place: the one that the stored document of this id has, or the last.
  authority::Owners OwnersWith(const std::string& id, const authority::Claim& claim) const;

 private:
  struct Entry {
    Time first{};
    authority::Claim claim;
    bool by_editor = false;
  };
  authority::Owners Build(const std::map<std::string, Entry>& stored) const;

  std::shared_ptr<const authority::Owners> own_;
  mutable std::mutex mutex_;
  std::map<std::string, Entry> stored_;
  std::shared_ptr<const authority::Owners> owners_;
};

// A document as it came in, for what refusals say about it.
struct Sent {
  std::string_view bytes;
  std::string source;  // file name
};

// Throws a Refusal of kForeignTerm that names each of `trespasses` with its place and owners;
// nothing when there is none.
void RefuseTrespasses(const rdf::View& known, const rdf::Graph& graph,
                      const std::vector<authority::Trespass>& trespasses, const Sent& sent);

}  // namespace lares::server
