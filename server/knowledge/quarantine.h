// Documents kept aside because they contradict what is known: stored, listed with the reason, part
// of no view.
#pragma once

#include <string>

#include "server/knowledge/knowledge.h"

namespace lares::server {

// Id of the document among those of kQuarantined: "ontology.furniture". It does not touch the
// document of this kind and id that is in use.
std::string QuarantineId(store::DocumentKind kind, const std::string& id);

// Stores what was sent, how it was sent, and why it is kept aside. Sending it again adds a version.
store::DocumentInfo KeepAside(store::Store& store, const PutRequest& request,
                              const std::string& reason);

// The put that was kept aside, to be tried again. Throws kNotFound.
PutRequest KeptAside(const store::Store& store, const std::string& quarantine_id);

// The same for the semantic layer of an environment, as "environment.lab".
inline std::string QuarantineIdOfEnvironment(const std::string& environment) {
  return "environment." + environment;
}
store::DocumentInfo KeepAside(store::Store& store, const store::NewVersion& version,
                              const store::LayerInfo& semantic, bool editor,
                              const std::string& reason);
struct VersionAside {
  store::NewVersion version;
  bool editor = false;
};
VersionAside VersionKeptAside(const store::Store& store, const std::string& quarantine_id);
void ForgetKeptAside(store::Store& store, const std::string& quarantine_id);

// The document of this kind and id was taken: nothing of it is aside any more.
void ForgetKeptAside(store::Store& store, store::DocumentKind kind, const std::string& id);

}  // namespace lares::server
