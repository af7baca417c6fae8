#include "server/cli/completion.h"

#include <CLI/CLI.hpp>

#include "base/text.h"
#include "server/cli/command.h"
#include "server/cli/print.h"

namespace lares::cli {
namespace {

std::string Quoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::vector<std::string> NamesOfCommands(const Command& command) {
  std::vector<std::string> names;
  for (const Command& below : command.commands) names.push_back(below.path.back());
  return names;
}

// Options, or only those that take a value.
std::vector<std::string> NamesOfOptions(const Command& command, bool only_with_value) {
  std::vector<std::string> names;
  for (const Argument& option : command.options) {
    if (only_with_value && option.takes == Argument::Takes::kNothing) continue;
    names.insert(names.end(), option.names.begin(), option.names.end());
  }
  return names;
}

// "words a b", "files", "folders" or "nothing": what the shells' functions know how to offer.
std::string Offer(const Argument& argument) {
  switch (argument.takes) {
    case Argument::Takes::kOneOf:
      return "words " + Join(argument.values, " ");
    case Argument::Takes::kFile:
      return "files";
    case Argument::Takes::kFolder:
      return "folders";
    default:
      return "nothing";
  }
}

std::string OfferByPlace(const Command& command) {
  for (const Argument& argument : command.arguments) {
    if (Offer(argument) != "nothing") return Offer(argument);
  }
  return "nothing";
}

// The cases of each command: what stands below it, what it takes.
std::string CommandCases(const Command& root) {
  std::string text;
  for (const Command* command : AllCommands(root)) {
    text += "    " + Quoted(command->name()) + ")\n";
    text += "      commands=" + Quoted(Join(NamesOfCommands(*command), " ")) + "\n";
    text += "      options=" + Quoted(Join(NamesOfOptions(*command, false), " ")) + "\n";
    text += "      with_value=" + Quoted(Join(NamesOfOptions(*command, true), " ")) + "\n";
    text += "      by_place=" + Quoted(OfferByPlace(*command)) + " ;;\n";
  }
  return text;
}

// The cases of each option whose values are known: "lares plan --as".
std::string ValueCases(const Command& root) {
  std::string text;
  for (const Command* command : AllCommands(root)) {
    for (const Argument& option : command->options) {
      const std::string offer = Offer(option);
      if (offer == "nothing") continue;
      std::string patterns;
      for (const std::string& name : option.names) {
        patterns += (patterns.empty() ? "" : " | ") + Quoted(command->name() + " " + name);
      }
      text += "    " + patterns + ") offer=" + Quoted(offer) + " ;;\n";
    }
  }
  return text;
}

std::string DescribeCases(const Command& root) {
  std::string text;
  for (const Command* command : AllCommands(root)) {
    if (command->commands.empty()) continue;
    text += "    " + Quoted(command->name()) + ") described=(";
    for (const Command& below : command->commands) {
      text += "\n      " + Quoted(below.path.back() + ":" + below.description);
    }
    text += ") ;;\n";
  }
  return text;
}

std::string Filled(std::string script, const Command& root) {
  const auto fill = [&script](const std::string& place, const std::string& text) {
    const std::size_t at = script.find(place);
    if (at != std::string::npos) script.replace(at, place.size(), text);
  };
  fill("@COMMANDS@\n", CommandCases(root));
  fill("@VALUES@\n", ValueCases(root));
  fill("@DESCRIBED@\n", DescribeCases(root));
  return script;
}

// Bash splits words at '=', so "--as=json" and "semantic=flat.ttl" come as three.
constexpr const char* kBash =
    R"sh(# Completion of lares for bash: source it, or put it where bash-completion looks.
_lares_command() {
  case "$1" in
@COMMANDS@
  esac
}

_lares_value() {
  offer=nothing
  case "$1" in
@VALUES@
  esac
}

_lares_offer() {
  case "$1" in
    words*) mapfile -t COMPREPLY < <(compgen -W "${1#words }" -- "$2") ;;
    files) compopt -o filenames 2>/dev/null; mapfile -t COMPREPLY < <(compgen -f -- "$2") ;;
    folders) compopt -o filenames 2>/dev/null; mapfile -t COMPREPLY < <(compgen -d -- "$2") ;;
  esac
}

_lares() {
  local current="${COMP_WORDS[COMP_CWORD]}" before="" path=lares word i
  local commands options with_value by_place offer
  COMPREPLY=()
  _lares_command "$path"
  for ((i = 1; i < COMP_CWORD; i++)); do
    word="${COMP_WORDS[i]}"
    if [ "$word" = = ] || [ "${COMP_WORDS[i - 1]}" = = ]; then continue; fi
    case " $with_value " in *" ${COMP_WORDS[i - 1]} "*) continue ;; esac
    case " $commands " in *" $word "*) path="$path $word"; _lares_command "$path" ;; esac
  done
  before="${COMP_WORDS[COMP_CWORD - 1]}"
  if [ "$current" = = ]; then
    current=""
  elif [ "$before" = = ]; then
    before="${COMP_WORDS[COMP_CWORD - 2]}"
  else
    case "$before" in
      -*) ;;
      *) before="" ;;
    esac
  fi
  case "$before" in
    -*)
      case " $with_value " in
        *" $before "*) _lares_value "$path $before"; _lares_offer "$offer" "$current"; return ;;
      esac ;;
    ?*) _lares_offer files "$current"; return ;;
  esac
  case "$current" in
    -*) mapfile -t COMPREPLY < <(compgen -W "$options" -- "$current") ;;
    *)
      if [ -n "$commands" ]; then mapfile -t COMPREPLY < <(compgen -W "$commands" -- "$current"); fi
      [ "${#COMPREPLY[@]}" -gt 0 ] || _lares_offer "$by_place" "$current" ;;
  esac
}
complete -F _lares lares
)sh";

constexpr const char* kZsh = R"sh(#compdef lares
# Completion of lares for zsh: put it as _lares into a folder of $fpath, or source it after compinit.
_lares_command() {
  case "$1" in
@COMMANDS@
  esac
}

_lares_value() {
  offer=nothing
  case "$1" in
@VALUES@
  esac
}

_lares_described() {
  case "$1" in
@DESCRIBED@
  esac
}

_lares_offer() {
  case "$1" in
    words*) local -a values; values=(${=1#words }); compadd -a values ;;
    files) _files ;;
    folders) _files -/ ;;
  esac
}

_lares() {
  local path_=lares word i before
  local commands options with_value by_place offer
  local -a described all
  _lares_command "$path_"
  for ((i = 2; i < CURRENT; i++)); do
    word="${words[i]}"
    if (( i > 2 )) && [[ " $with_value " == *" ${words[i - 1]} "* ]]; then continue; fi
    if [[ " $commands " == *" $word "* ]]; then path_="$path_ $word"; _lares_command "$path_"; fi
  done
  before="${words[CURRENT - 1]}"
  if [[ "$before" == -* && " $with_value " == *" $before "* ]]; then
    _lares_value "$path_ $before"
    if compset -P '[a-z]##='; then _files; else _lares_offer "$offer"; fi
    return
  fi
  if [[ "${words[CURRENT]}" == --*=* ]]; then
    before="${words[CURRENT]%%=*}"
    compset -P '*='
    _lares_value "$path_ $before"
    _lares_offer "$offer"
  elif [[ "${words[CURRENT]}" == -* ]]; then
    all=(${=options})
    compadd -a all
  elif [[ -n "$commands" ]]; then
    _lares_described "$path_"
    _describe command described
  else
    _lares_offer "$by_place"
  fi
}
if [[ "$funcstack[1]" == _lares ]]; then _lares "$@"; else compdef _lares lares; fi
)sh";

constexpr const char* kFish =
    R"sh(# Completion of lares for fish: put it as lares.fish into ~/.config/fish/completions.
function __lares_at
    set -l path lares
    for word in (commandline -opc)[2..-1]
        contains -- "$path $word" $__lares_commands; and set path "$path $word"
    end
    test "$path" = "$argv"
end
complete -c lares -f
)sh";

// `complete`'s words for what an argument takes.
std::string FishOffer(const Argument& argument) {
  switch (argument.takes) {
    case Argument::Takes::kNothing:
      return "";
    case Argument::Takes::kOneOf:
      return " -x -a " + Quoted(Join(argument.values, " "));
    case Argument::Takes::kFile:
      return " -r -F";
    case Argument::Takes::kFolder:
      return " -x -a '(__fish_complete_directories)'";
    case Argument::Takes::kText:
      return " -x";
  }
  return "";
}

std::string FishQuoted(std::string text) {
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + "'";
}

std::string FishLines(const Command& command) {
  const std::string at = "complete -c lares -n " + FishQuoted("__lares_at " + command.name());
  std::string text;
  for (const Command& below : command.commands) {
    text += at + " -a " + below.path.back() + " -d " + FishQuoted(below.description) + "\n";
  }
  for (const Argument& option : command.options) {
    text += at;
    for (const std::string& name : option.names) {
      text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    }
    text += FishOffer(option);
    if (!option.description.empty()) text += " -d " + FishQuoted(option.description);
    text += "\n";
  }
  if (command.commands.empty() && OfferByPlace(command) == "files") text += at + " -F\n";
  if (OfferByPlace(command).starts_with("words ")) {
    text += at + " -a " + FishQuoted(OfferByPlace(command).substr(6)) + "\n";
  }
  return text;
}

}  // namespace

std::string BashCompletion(const Command& root) { return Filled(kBash, root); }

std::string ZshCompletion(const Command& root) { return Filled(kZsh, root); }

std::string FishCompletion(const Command& root) {
  std::string text = kFish;
  text += "set -g __lares_commands";
  for (const Command* command : AllCommands(root)) text += " " + FishQuoted(command->name());
  text += "\n";
  for (const Command* command : AllCommands(root)) text += FishLines(*command);
  return text;
}

void AddCompletion(CLI::App& app) {
  auto* command = AddCommand(app, "completion", "A script that makes a shell complete lares",
                             "  source <(lares completion bash)\n"
                             "  lares completion zsh > ~/.zfunc/_lares\n"
                             "  lares completion fish > ~/.config/fish/completions/lares.fish");
  auto shell = std::make_shared<std::string>();
  command->add_option("SHELL", *shell, "bash, zsh or fish")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  command->callback([shell, &app] {
    const Command root = ReadCommands(app);
    if (*shell == "zsh") return Print(ZshCompletion(root));
    Print(*shell == "fish" ? FishCompletion(root) : BashCompletion(root));
  });
}

}  // namespace lares::cli
