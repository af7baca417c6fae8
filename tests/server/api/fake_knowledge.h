// Knowledge without ontology, rules or Prolog, linked in the place of the real one: what the HTTP
// interface makes of its answers can be tested alone and in milliseconds.
#pragma once

#include <functional>

#include "server/knowledge/knowledge.h"

namespace lares::testing {

// What the fake answers; each test sets what it needs. Defaults: documents are stored as sent,
// plans have one state, cups are in the kitchen.
struct FakeAnswers {
  std::function<server::PutAnswer(const server::PutRequest&, store::Store&)> put;
  std::function<server::PlanAnswer(const server::PlanRequest&)> plan;
  std::function<server::WhereAnswer(const server::WhereRequest&)> where;
  std::function<rdf::View(const server::ViewRequest&)> view;  // set before anybody asks
};
FakeAnswers& Answers();

// One layer with the triples of one document: graph "recipe:demo".
rdf::View ViewOfTurtle(const std::string& turtle);

}  // namespace lares::testing
