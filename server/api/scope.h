// What the caller's token reaches, as the handlers ask. A service without a gatekeeper lets
// everybody reach everything.
#pragma once

#include <string>
#include <string_view>

#include "server/http/message.h"
#include "server/store/store.h"

namespace lares::api {

bool Reaches(const http::Request& request, std::string_view environment);

// For an environment that a body names: throws kNotFound, as for one that is not there, when the
// token does not reach it. "" is none. (The gatekeeper looks at paths and ?environment= by itself.)
void CheckReach(const http::Request& request, const std::string& environment);

// Whether a document may be seen: what is kept aside of an environment only by those who reach it.
bool MaySee(const http::Request& request, store::DocumentKind kind, std::string_view id);

// Throws "role-too-low" unless the caller is an editor: for the flag that gives rights over the
// terms of others.
void CheckIsEditor(const http::Request& request);

}  // namespace lares::api
