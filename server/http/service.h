// The one wrapper around every handler.
#pragma once

#include <memory>
#include <string>

#include "server/http/message.h"
#include "server/http/metrics.h"
#include "server/http/origin_check.h"
#include "server/http/router.h"

namespace lares::http {

// Who may ask what. All members are thread-safe.
class Gatekeeper {
 public:
  virtual ~Gatekeeper() = default;
  // Before the body is read: fills in `grant` and `place`, or throws the refusal.
  virtual void Admit(const Route& route, Request& request) = 0;
  // Before the handler runs, with the body there to be read.
  virtual void Begin(const Route& route, Request& request) = 0;
  // After each answer to a request of a known grant, refusals included. Must not throw.
  virtual void Answered(const Route& route, const Request& request,
                        const Response& response) noexcept = 0;
};

struct ServiceOptions {
  std::shared_ptr<Metrics> metrics = std::make_shared<Metrics>();
  std::shared_ptr<Gatekeeper> gatekeeper;  // null: everybody may ask everything
  OriginRules origins;
};

// Answers a request whole: request id, Host and Origin, route, method, who asks, media type and
// length of the body, the handler, faults as problem documents, If-None-Match, Range and HEAD.
class Service {
 public:
  explicit Service(Router router, ServiceOptions options = {})
      : router_(std::move(router)), options_(std::move(options)) {}

  // What can be said before the body is read: the route, or the refusal.
  struct Admission {
    const Route* route = nullptr;
    std::optional<Response> refusal;
  };
  // Fills in `request.params` and `request.id`. Never throws.
  Admission Admit(Request& request) const;

  // Runs the route's handler. Never throws.
  Response Run(const Route& route, Request& request) const;

  // The two together, for tests and anything else without a socket.
  Response Answer(Request request) const;

  // A fault that was found before there was a request to route.
  static Response Refuse(const std::exception& error, const std::string& request_id);
  // A fault that was found after Run, with the headers that every answer has.
  static Response Refuse(const std::exception& error, const Request& request);

  const Router& router() const { return router_; }
  Metrics& metrics() const { return *options_.metrics; }

 private:
  Router router_;
  ServiceOptions options_;
};

// A client's id when it is 1–128 of [A-Za-z0-9._:-], else a new one of ours.
std::string RequestId(std::string_view sent);

}  // namespace lares::http
