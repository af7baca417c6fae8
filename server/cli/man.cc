#include "server/cli/man.h"

#include <CLI/CLI.hpp>

#include "base/error.h"
#include "base/file.h"
#include "base/text.h"
#include "server/cli/command.h"
#include "server/cli/exit_codes.h"
#include "server/cli/print.h"

namespace lares::cli {
namespace {

// Text as roff takes it: nothing of it is a request, a hyphen stays one.
std::string Escaped(std::string_view text) {
  std::string roff;
  bool line_begins = true;
  for (const char c : text) {
    if (line_begins && (c == '.' || c == '\'')) roff += "\\&";
    line_begins = c == '\n';
    if (c == '\\') {
      roff += "\\e";
    } else if (c == '-') {
      roff += "\\-";
    } else if (c == '~') {
      roff += "\\(ti";
    } else if (c == '^') {
      roff += "\\(ha";
    } else {
      roff += c;
    }
  }
  return roff;
}

std::string Bold(const std::string& text) { return "\\fB" + Escaped(text) + "\\fR"; }
std::string Italic(const std::string& text) { return "\\fI" + Escaped(text) + "\\fR"; }

std::string PageName(const Command& command) { return Join(command.path, "-"); }

std::string Synopsis(const Command& command) {
  std::string text = ".SH SYNOPSIS\n" + Bold(command.name());
  if (!command.options.empty()) text += " [" + Italic("OPTION") + "]...";
  for (const Argument& argument : command.arguments) {
    const std::string name = Italic(argument.metavar) + (argument.repeatable ? "..." : "");
    text += argument.required ? " " + name : " [" + name + "]";
  }
  if (!command.commands.empty()) text += " " + Italic("COMMAND") + " ...";
  return text + "\n";
}

// What there is to know of an option or argument beside its name.
std::string About(const Argument& argument) {
  std::vector<std::string> parts;
  if (!argument.description.empty()) parts.push_back(argument.description);
  if (!argument.values.empty()) parts.push_back("one of: " + Join(argument.values, ", "));
  if (!argument.default_text.empty()) parts.push_back("default: " + argument.default_text);
  if (!argument.environment.empty()) parts.push_back("environment: " + argument.environment);
  return Escaped(parts.empty() ? "see the examples" : Join(parts, "; ")) + "\n";
}

std::string OptionEntry(const Argument& option) {
  std::string heads;
  for (const std::string& name : option.names) heads += (heads.empty() ? "" : ", ") + Bold(name);
  if (option.takes != Argument::Takes::kNothing) heads += " " + Italic(option.metavar);
  return ".TP\n" + heads + "\n" + About(option);
}

std::string OptionList(const Command& command) {
  if (command.options.empty()) return "";
  std::string text = ".SH OPTIONS\n";
  for (const Argument& option : command.options) text += OptionEntry(option);
  return text;
}

std::string Arguments(const Command& command) {
  if (command.arguments.empty()) return "";
  std::string text = ".SH ARGUMENTS\n";
  for (const Argument& argument : command.arguments) {
    text += ".TP\n" + Italic(argument.metavar) + "\n" + About(argument);
  }
  return text;
}

std::string Commands(const Command& command) {
  if (command.commands.empty()) return "";
  std::string text = ".SH COMMANDS\n";
  for (const Command& below : command.commands) {
    text += ".TP\n" + Bold(below.path.back()) + "\n" + Escaped(below.description) + ".\nSee\n.BR " +
            Escaped(PageName(below)) + " (1).\n";
  }
  return text;
}

// The footer's lines as they are.
std::string Examples(const Command& command) {
  constexpr std::string_view kHead = "Examples:\n";
  std::string_view text = command.footer;
  if (!text.starts_with(kHead)) return "";
  text.remove_prefix(kHead.size());
  return ".SH EXAMPLES\n.nf\n" + Escaped(text) + "\n.fi\n";
}

std::string ExitStatus() {
  std::string text = ".SH EXIT STATUS\n";
  for (const ExitMeaning& meaning : ExitMeanings()) {
    text += ".TP\n" + Bold(std::to_string(static_cast<int>(meaning.code))) + "\n" +
            Escaped(meaning.meaning) + ".\n";
  }
  return text;
}

constexpr const char* kEnvironment =
    ".SH ENVIRONMENT\n"
    ".TP\n\\fBLARES_SERVER\\fR\nAddress of the server, where\n.B \\-\\-server\nis not given.\n"
    ".TP\n\\fBLARES_SHARE\\fR\nFolder that holds ontology/, recipes/ and robots/, looked at before "
    "those\nthat were installed.\n"
    ".SH FILES\n"
    ".TP\n\\fI/usr/share/lares\\fR\nOntologies, priors, recipes, skill templates and robots.\n"
    ".TP\n\\fI/var/lib/lares\\fR\nWhat the service of the Debian package keeps.\n"
    ".TP\n\\fI\\(ti/.local/share/lares/store\\fR\nWhat a server that a user starts keeps.\n";

std::string SeeAlso(const Command& command) {
  if (command.path.size() == 1) return "";
  const std::vector<std::string> above(command.path.begin(), command.path.end() - 1);
  return ".SH SEE ALSO\n.BR " + Escaped(Join(above, "-")) + " (1)\n";
}

const Command& FindCommand(const Command& root, const std::vector<std::string>& path) {
  const Command* command = &root;
  for (const std::string& name : path) {
    const Command* found = nullptr;
    std::vector<std::string> known;
    for (const Command& below : command->commands) {
      if (below.path.back() == name) found = &below;
      known.push_back(below.path.back());
    }
    if (found == nullptr) {
      throw Error(Code::kNotFound, "'" + command->name() + "' has no command '" + name + "'")
          .WithCandidates(SimilarNames(name, known));
    }
    command = found;
  }
  return *command;
}

void WritePages(const Command& root, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  for (const Command* command : AllCommands(root)) {
    WriteFileAtomically(folder / ManFileName(*command), ManPage(*command, LARES_VERSION));
  }
}

}  // namespace

std::string ManFileName(const Command& command) { return PageName(command) + ".1"; }

std::string ManPage(const Command& command, const std::string& version) {
  const bool is_root = command.path.size() == 1;
  std::string text = ".TH " + Escaped(PageName(command)) + " 1 " LARES_BUILD_DATE " \"Lares " +
                     Escaped(version) + "\" \"User commands\"\n.nh\n.ad l\n";
  text += ".SH NAME\n" + Escaped(PageName(command)) + " \\- " + Escaped(command.description) + "\n";
  text += Synopsis(command) + Commands(command) + Arguments(command) + OptionList(command);
  if (is_root) text += kEnvironment;
  return text + ExitStatus() + Examples(command) + SeeAlso(command);
}

void AddMan(CLI::App& app) {
  auto* command = AddCommand(app, "man", "The manual page of lares or of one of its commands",
                             "  lares man | man -l -\n  lares man plan diff | man -l -\n"
                             "  lares man --all build/man1");
  struct Asked {
    std::vector<std::string> path;
    std::string all;
  };
  auto asked = std::make_shared<Asked>();
  command->add_option("COMMAND", asked->path, "as in plan diff (default: lares itself)");
  command->add_option("--all", asked->all, "folder to write every page into");
  command->callback([asked, &app] {
    const Command root = ReadCommands(app);
    if (!asked->all.empty()) return WritePages(root, asked->all);
    Print(ManPage(FindCommand(root, asked->path), LARES_VERSION));
  });
}

}  // namespace lares::cli
