// Documents that are refused for what they say, and those that are kept aside.
#pragma once

#include "server/api/context.h"
#include "server/http/message.h"

namespace lares::api {

// ?editor= and ?quarantine= into `put`, or for a version of an environment.
void ReadRights(const http::Request& request, server::PutRequest& put);
server::Knowledge::VersionRights ReadVersionRights(const http::Request& request);

// Knowledge::Put; a Refusal becomes the problem "foreign-term" or "contradiction" with what it
// rests on.
server::PutAnswer Put(Context& context, const server::PutRequest& put);

// Knowledge::PutVersion, likewise.
server::Knowledge::VersionAnswer PutVersion(Context& context, const store::NewVersion& version,
                                            const server::Knowledge::VersionRights& rights);

}  // namespace lares::api
