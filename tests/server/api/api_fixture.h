// A real server over the real store, with the knowledge faked.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>

#include "reasoner/prolog/engine_pool.h"
#include "server/api/api.h"
#include "server/http/client.h"
#include "server/http/log.h"
#include "server/http/server.h"
#include "tests/server/api/fake_knowledge.h"

namespace lares::testing {

class ApiTest : public ::testing::Test {
 protected:
  ApiTest() {
    http::SetLogLevel(http::LogLevel::kOff);
    Answers() = {};
    static int count = 0;
    folder_ = std::filesystem::path(::testing::TempDir()) /
              ("lares_api_" + std::to_string(::getpid()) + "_" + std::to_string(count++));
    std::filesystem::create_directories(folder_);
    store_ = store::OpenSqliteStore({folder_ / "data"});
    knowledge_ = std::make_unique<server::Knowledge>(*store_, engines_);
    context_ = std::make_unique<api::Context>(api::Context{*store_, *knowledge_});
    http::ServerOptions options;
    options.port = 0;
    options.loop.threads = 4;
    server_ = std::make_unique<http::Server>(api::MakeService(*context_), options);
    client_ = std::make_unique<http::Client>(server_->url());
  }
  ~ApiTest() override {
    client_.reset();
    server_.reset();
    std::filesystem::remove_all(folder_);
  }

  http::ClientResponse Get(const std::string& path, const std::string& header = "",
                           const std::string& value = "") {
    http::ClientRequest request{"GET", path, {}, {}, {}};
    if (!header.empty()) request.headers.Set(header, value);
    return client_->Send(request);
  }
  http::ClientResponse Send(const std::string& method, const std::string& path,
                            const std::string& type, const std::string& body,
                            const std::string& header = "", const std::string& value = "") {
    http::ClientRequest request{method, path, {}, {}, body};
    if (!type.empty()) request.headers.Set("Content-Type", type);
    if (!header.empty()) request.headers.Set(header, value);
    return client_->Send(request);
  }
  http::ClientResponse SendForm(const std::string& method, const std::string& path,
                                const std::vector<http::FormPart>& parts,
                                const std::string& header = "", const std::string& value = "") {
    http::ClientRequest request{method, path, {}, {}, http::EncodeForm(parts)};
    if (!header.empty()) request.headers.Set(header, value);
    return client_->Send(request);
  }
  static nlohmann::json Json(const http::ClientResponse& response) {
    return nlohmann::json::parse(response.body);
  }
  std::filesystem::path Write(const std::string& name, const std::string& bytes) {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return folder_ / name;
  }

  std::filesystem::path folder_;
  std::unique_ptr<store::Store> store_;
  prolog::EnginePool engines_;
  std::unique_ptr<server::Knowledge> knowledge_;
  std::unique_ptr<api::Context> context_;
  std::unique_ptr<http::Server> server_;
  std::unique_ptr<http::Client> client_;
};

inline constexpr const char* kTurtle = "<urn:a> <urn:b> <urn:c> .\n";
inline constexpr const char* kTrajectory =
    "0.0 0 0 0 0 0 0 1\n0.1 0.5 0 0 0 0 0 1\n0.2 1 0 0 0 0 0 1\n";

}  // namespace lares::testing
