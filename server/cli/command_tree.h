// The command line as data: what completion and the man pages are written from.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace lares::cli {

struct Argument {
  enum class Takes { kNothing, kText, kOneOf, kFile, kFolder };

  std::vector<std::string> names;   // "-q", "--query"; empty for one that goes by its place
  std::string metavar;              // what help calls its value
  std::string description;          // may be empty
  std::string default_text;         // may be empty
  std::string environment;          // variable that it is taken from otherwise; may be empty
  std::vector<std::string> values;  // of kOneOf
  Takes takes = Takes::kText;
  bool required = false;
  bool repeatable = false;
};

struct Command {
  std::vector<std::string> path;  // {"lares", "plan", "diff"}
  std::string description;
  std::string footer;               // "Examples:" and what more stands below the help
  std::vector<Argument> options;    // those of the commands above it included
  std::vector<Argument> arguments;  // in their order
  std::vector<Command> commands;    // below it, by name

  std::string name() const;  // the path with spaces
};

// The tree below `app`, which stands at its root. Everything is read from CLI11 but what an
// option's text names a file or folder by: its metavar (FILE…) or its description ("file …",
// "folder …").
Command ReadCommands(const CLI::App& app);

// `command` and all below it, each before those below it.
std::vector<const Command*> AllCommands(const Command& command);

}  // namespace lares::cli
