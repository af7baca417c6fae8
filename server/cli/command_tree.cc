#include "server/cli/command_tree.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iterator>

#include "base/text.h"

namespace lares::cli {
namespace {

// "TEXT:{a,b}" lists what may be given; a mapping says {a->0,b->1}.
std::vector<std::string> ValuesOf(const std::string& type_name) {
  const std::size_t open = type_name.find('{');
  const std::size_t close = type_name.find('}', open);
  if (open == std::string::npos || close == std::string::npos) return {};
  std::vector<std::string> values;
  for (std::string value : Split(type_name.substr(open + 1, close - open - 1), ',')) {
    value = value.substr(0, value.find("->"));
    values.emplace_back(Trim(value));
  }
  return values;
}

bool Mentions(std::string_view text, std::string_view word) {
  return text.find(word) != std::string_view::npos;
}

Argument::Takes FileOrFolder(const Argument& argument) {
  const std::string metavar = ToLower(argument.metavar);
  const std::string text = ToLower(argument.description);
  if (text.starts_with("folder")) return Argument::Takes::kFolder;
  if (Mentions(metavar, "file") || Mentions(text, "file") || metavar == "plans") {
    return Argument::Takes::kFile;
  }
  return Argument::Takes::kText;
}

std::string MetavarOf(const CLI::Option& option, const Argument& argument) {
  if (option.get_positional()) return option.get_name(true);
  switch (argument.takes) {
    case Argument::Takes::kFile:
      return "FILE";
    case Argument::Takes::kFolder:
      return "FOLDER";
    default:
      break;
  }
  std::string name = option.get_lnames().empty() ? "VALUE" : option.get_lnames().front();
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return c == '-' ? '_' : std::toupper(c); });
  return name;
}

Argument ReadArgument(const CLI::Option& option) {
  Argument argument;
  for (const std::string& name : option.get_snames()) argument.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) argument.names.push_back("--" + name);
  argument.description = option.get_description();
  argument.default_text = option.get_default_str();
  argument.environment = option.get_envname();
  argument.required = option.get_required();
  argument.repeatable = option.get_items_expected_max() > 1;
  if (option.get_positional()) argument.metavar = option.get_name(true);
  argument.values = ValuesOf(option.get_type_name());
  if (option.get_items_expected_max() == 0) {
    argument.takes = Argument::Takes::kNothing;
  } else {
    argument.takes = argument.values.empty() ? FileOrFolder(argument) : Argument::Takes::kOneOf;
    argument.metavar = MetavarOf(option, argument);
  }
  return argument;
}

bool Has(const std::vector<Argument>& options, const std::string& name) {
  return std::any_of(options.begin(), options.end(), [&](const Argument& option) {
    return std::find(option.names.begin(), option.names.end(), name) != option.names.end();
  });
}

// --help and --version are those of one command; everything else is taken below it too.
bool IsInherited(const Argument& option) {
  return !Has({option}, "--help") && !Has({option}, "--version");
}

// `general`: what every command below the root takes too.
Command ReadCommand(const CLI::App& app, const std::vector<std::string>& above,
                    const std::vector<Argument>& general) {
  Command command;
  command.path = above;
  command.path.push_back(app.get_name());
  command.description = app.get_description();
  command.footer = app.get_footer();
  for (const CLI::Option* option : app.get_options()) {
    Argument argument = ReadArgument(*option);
    const bool by_place = argument.names.empty();
    (by_place ? command.arguments : command.options).push_back(std::move(argument));
  }
  for (const Argument& option : general) {
    if (!Has(command.options, option.names.back())) command.options.push_back(option);
  }
  std::vector<Argument> passed_on = general;
  if (above.empty()) {
    std::copy_if(command.options.begin(), command.options.end(), std::back_inserter(passed_on),
                 IsInherited);
  }
  for (const CLI::App* below : app.get_subcommands([](const CLI::App*) { return true; })) {
    command.commands.push_back(ReadCommand(*below, command.path, passed_on));
  }
  std::sort(command.commands.begin(), command.commands.end(),
            [](const Command& a, const Command& b) { return a.path < b.path; });
  return command;
}

}  // namespace

std::string Command::name() const { return Join(path, " "); }

Command ReadCommands(const CLI::App& app) { return ReadCommand(app, {}, {}); }

std::vector<const Command*> AllCommands(const Command& command) {
  std::vector<const Command*> all{&command};
  for (const Command& below : command.commands) {
    const std::vector<const Command*> those = AllCommands(below);
    all.insert(all.end(), those.begin(), those.end());
  }
  return all;
}

}  // namespace lares::cli
