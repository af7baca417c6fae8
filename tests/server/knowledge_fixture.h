// A knowledge service on a store of its own, and small documents.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "base/file.h"
#include "server/knowledge/knowledge.h"

namespace lares::testing {

// One per process: SWI-Prolog starts once.
inline prolog::EnginePool& Engines() {
  static prolog::EnginePool engines;
  return engines;
}

class KnowledgeFixture : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string pattern =
        (std::filesystem::temp_directory_path() / "lares-knowledge-XXXXXX").string();
    ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
    Open();
  }
  void TearDown() override {
    knowledge_.reset();
    store_.reset();
    std::filesystem::remove_all(folder_);
  }
  void Open() {
    knowledge_.reset();
    store_.reset();
    store_ = store::OpenSqliteStore({folder_});
    knowledge_ = std::make_unique<server::Knowledge>(*store_, Engines());
  }

  server::PutAnswer Put(store::DocumentKind kind, const std::string& id, std::string bytes,
                        const std::string& file_name = "document.ttl") {
    server::PutRequest request;
    request.kind = kind;
    request.id = id;
    request.file_name = file_name;
    request.bytes = std::move(bytes);
    return knowledge_->Put(request);
  }
  server::PutAnswer PutAsEditor(store::DocumentKind kind, const std::string& id,
                                std::string bytes) {
    server::PutRequest request;
    request.kind = kind;
    request.id = id;
    request.file_name = "document.ttl";
    request.bytes = std::move(bytes);
    request.editor = true;
    return knowledge_->Put(request);
  }
  server::PutAnswer PutFile(store::DocumentKind kind, const std::filesystem::path& file,
                            bool recover = false) {
    server::PutRequest request;
    request.kind = kind;
    request.file_name = file.filename().string();
    request.bytes = ReadFile(file);
    request.recover = recover;
    return knowledge_->Put(request);
  }
  store::Blob PutBlob(const std::string& bytes) {
    const auto writer = store_->NewBlob();
    writer->Append(bytes);
    return writer->Commit();
  }
  server::Knowledge::VersionAnswer PutMap(const std::string& environment, const std::string& bytes,
                                          const std::string& file_name = "map.ttl") {
    store::NewVersion version;
    version.environment = environment;
    version.layers.push_back({"semantic", file_name, "", PutBlob(bytes), {}});
    return knowledge_->PutVersion(version);
  }

  std::filesystem::path folder_;
  std::unique_ptr<store::Store> store_;
  std::unique_ptr<server::Knowledge> knowledge_;
};

inline constexpr char kPrefixes[] =
    "@prefix lares: <https://w3id.org/lares#> .\n"
    "@prefix rdf: <http://www.w3.org/1999/02/22-rdf-syntax-ns#> .\n"
    "@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .\n"
    "@prefix owl: <http://www.w3.org/2002/07/owl#> .\n"
    "@prefix xsd: <http://www.w3.org/2001/XMLSchema#> .\n"
    "@prefix : <http://example.org/test#> .\n";

// A partial order of `steps`, each moving the base, under class :`task`.
inline std::string WalkRecipe(const std::string& task, int steps) {
  std::string text = kPrefixes;
  text += ":" + task + " a owl:Class ; rdfs:subClassOf lares:PurposefulAction";
  for (int i = 1; i <= steps; ++i) {
    text += ", [ a owl:Restriction ; owl:onProperty lares:subAction ; owl:someValuesFrom :Step" +
            std::to_string(i) + " ]";
  }
  for (int i = 1; i < steps; ++i) {
    text +=
        ", [ a owl:Restriction ; owl:onProperty lares:orderingConstraints ; owl:hasValue :order" +
        std::to_string(i) + " ]";
  }
  text += " .\n";
  for (int i = 1; i <= steps; ++i) {
    text +=
        ":Step" + std::to_string(i) +
        " a owl:Class ; rdfs:subClassOf lares:Translation-LocationChange , [ a owl:Restriction ; "
        "owl:onProperty lares:toLocation ; owl:hasValue :spot" +
        std::to_string(i) + " ] .\n:spot" + std::to_string(i) + " a lares:Point2D .\n";
  }
  for (int i = 1; i < steps; ++i) {
    text += ":order" + std::to_string(i) +
            " a lares:PartialOrdering-Strict ; lares:occursBeforeInOrdering :Step" +
            std::to_string(i) + " ; lares:occursAfterInOrdering :Step" + std::to_string(i + 1) +
            " .\n";
  }
  return text;
}

// A robot :`name` with a base and nothing else.
inline std::string BaseOnlyRobot(const std::string& name) {
  return std::string(kPrefixes) + ":" + name + " a lares:Robot ; lares:subComponent :" + name +
         "_base .\n:" + name + "_base a lares:MobileBase .\n";
}

}  // namespace lares::testing
