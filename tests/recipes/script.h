// The part of BehaviorTree.CPP's script language that plans use.
#pragma once

#include <map>
#include <string>

namespace lares::testing {

// The value of "name := expression" (which is also put on the blackboard) or of an expression:
// strings in single quotes, names, == || ?: and brackets. Throws std::runtime_error for anything
// else, and for names that the blackboard does not have.
std::string RunScript(const std::string& code, std::map<std::string, std::string>& blackboard);

}  // namespace lares::testing
