// What the store can give to any robot: maps of an environment, recognition models of objects.
#pragma once

#include <vector>

#include "ontology/triples/view.h"
#include "recipes/match/match.h"
#include "server/store/store.h"

namespace lares::server {

// Stored models for `sought`, classes of objects: a model of a class or of one below it serves.
// None when one of them has none, for then there is something that could not be recognised.
std::vector<recipes::Offer> ModelOffers(const store::Store& store, const rdf::View& catalogue,
                                        const std::vector<recipes::Resource>& sought);

// The kinds of maps that the version's layers are, or that are cut from them.
std::vector<recipes::Offer> MapOffers(const store::EnvironmentVersion& version);

}  // namespace lares::server
