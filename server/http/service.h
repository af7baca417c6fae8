// The one wrapper around every handler.
#pragma once

#include <memory>
#include <string>

#include "server/http/message.h"
#include "server/http/metrics.h"
#include "server/http/router.h"

namespace lares::http {

// Answers a request whole: request id, Host and Origin, route, method, media type and length of
// the body, the handler, faults as problem documents, If-None-Match, Range and HEAD.
class Service {
 public:
  explicit Service(Router router, std::shared_ptr<Metrics> metrics = std::make_shared<Metrics>())
      : router_(std::move(router)), metrics_(std::move(metrics)) {}

  // What can be said before the body is read: the route, or the refusal.
  struct Admission {
    const Route* route = nullptr;
    std::optional<Response> refusal;
  };
  // Fills in `request.params` and `request.id`. Never throws.
  Admission Admit(Request& request) const;

  // Runs the route's handler. Never throws.
  Response Run(const Route& route, const Request& request) const;

  // The two together, for tests and anything else without a socket.
  Response Answer(Request request) const;

  // A fault that was found before there was a request to route.
  static Response Refuse(const std::exception& error, const std::string& request_id);
  // A fault that was found after Run, with the headers that every answer has.
  static Response Refuse(const std::exception& error, const Request& request);

  const Router& router() const { return router_; }
  Metrics& metrics() const { return *metrics_; }

 private:
  Router router_;
  std::shared_ptr<Metrics> metrics_;
};

// A client's id when it is 1–128 of [A-Za-z0-9._:-], else a new one of ours.
std::string RequestId(std::string_view sent);

}  // namespace lares::http
