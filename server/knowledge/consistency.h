// Documents that contradict what is known.
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "ontology/triples/view.h"
#include "server/knowledge/authority.h"
#include "server/knowledge/refusal.h"

namespace lares::server {

// Why a document cannot be taken: the contradictions and what each rests on.
struct Contradiction {
  std::string message;  // a sentence for each, what each rests on, and one proof
  std::string json;     // {"clashes": [{"rule", "sentence", "premises": [{"text", "graphs"}]}],
                        // "proof": as owl::ToJson}
};

// What the top layer of `view` contradicts; nothing when it contradicts nothing.
std::optional<Contradiction> FindContradiction(const rdf::View& view);

// What to throw when a document from `source` is not taken for it.
Refusal ToRefusal(const Contradiction& contradiction, const std::string& source);

// The catalogue as far as it can convict a document of contradicting it: without what stored
// ontologies add to terms of our namespace, which they share by an alias. Such an axiom serves
// answers; but between a robot that says one thing and an ontology that says another about a term
// which is neither's, the catalogue takes no side. Thread-safe.
class FirmCatalogue {
 public:
  // One stored ontology of the catalogue.
  struct Stored {
    const rdf::Graph* graph = nullptr;
    bool by_editor = false;  // what an editor sent counts in full
  };
  // `own` closed with what is firm of `stored`. Made once for each generation.
  rdf::View For(std::uint64_t generation, const rdf::View& own, const authority::Owners& own_owners,
                const std::vector<Stored>& stored);

 private:
  std::mutex mutex_;
  std::uint64_t generation_ = 0;
  std::optional<rdf::View> view_;
};

}  // namespace lares::server
