// A document that is refused for what it says, not for how it is written.
#pragma once

#include <string>
#include <utility>

#include "base/error.h"

namespace lares::server {

class Refusal : public Error {
 public:
  enum class Kind { kForeignTerm, kContradiction };

  Refusal(Kind kind, const std::string& message, Place place)
      : Error(Code::kInvalid, message, std::move(place)), kind_(kind) {}

  Kind kind() const { return kind_; }
  // A JSON object with what programs want to know beside the message: "axioms", or "clashes".
  const std::string& members_json() const { return members_json_; }
  Refusal& WithMembers(std::string json) {
    members_json_ = std::move(json);
    return *this;
  }

 private:
  Kind kind_;
  std::string members_json_;
};

}  // namespace lares::server
