#!/usr/bin/env bash
# Shells complete what the command line takes, and the manual says it: both checked against what
# --help prints.
. "$(dirname "$0")/session.sh"
trap 'rm -rf "$work"; echo "$((checks - failures)) of $checks checks hold"; [ "$failures" = 0 ]; exit' EXIT
cd "$session_root" || exit 1

# ---- bash --------------------------------------------------------------------------------------
expect 0 lares completion bash
lares completion bash >"$work/lares.bash"
expect 0 bash -n "$work/lares.bash"
# complete WORD… : what bash would offer for the last of them, which may be empty. '=' stands alone.
complete_bash() {
  bash -c '. "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _lares
    printf "%s\n" "${COMPREPLY[@]}"' bash "$work/lares.bash" "$@"
}
expect 0 complete_bash lares pl && has plan && lacks prior
expect 0 complete_bash lares plan --as "" && has bt-xml pddl-domain && lacks README.md
expect 0 complete_bash lares plan --as = j && has json && lacks bt-xml
expect 0 complete_bash lares plan --ro && has --robot
expect 0 complete_bash lares plan diff --ro && has --robot
expect 0 complete_bash lares --server http://127.0.0.1:1 recipe "" && has put list robots
expect 0 complete_bash lares plan --robot diff --pack && has --package
expect 0 complete_bash lares recipe put recipes/library/obj && has recipes/library/object-search.ttl
expect 0 complete_bash lares environment put flat --layer semantic = demo/fl && has demo/flat.ttl
expect 0 complete_bash lares serve --data de && has demo && lacks demo/flat.ttl
expect 0 complete_bash lares completion "" && has bash zsh fish
mkdir "$work/two words" && touch "$work/two words/a b.ttl"
expect 0 complete_bash lares robot put "$work/two words/a" && has "$work/two words/a b.ttl"
expect 0 complete_bash lares no-such-command "" && has plan

# Every command and option of every --help is offered and stands in the manual, and nothing else is.
lares man --all "$work/man1" || exit 1
walk() {
  local help names below
  help="$(lares "$@" --help)"
  output="$(complete_bash lares "$@" -)"
  names="$(grep -oE '^  (-[a-zA-Z],)?--[a-z-]+' <<<"$help" | grep -oE -- '--[a-z-]+')"
  checks=$((checks + 1))
  [ -n "$names" ] || { failures=$((failures + 1)); echo "FAILED: lares $* --help lists no option"; }
  # shellcheck disable=SC2086
  has $names
  output="$(sed 's/\\-/-/g' "$work/man1/$(tr ' ' - <<<"lares $*" | sed 's/-$//').1")"
  # shellcheck disable=SC2086
  has $names "EXIT STATUS"
  below="$(awk '/^Subcommands:/ {on = 1; next} /^[^ ]/ {on = 0} on && /^  [a-z]/ {print $1}' <<<"$help")"
  [ -z "$below" ] && return
  output="$(complete_bash lares "$@" "")"
  # shellcheck disable=SC2086
  has $below
  [ "$(sort <<<"$output")" = "$(sort <<<"$below")" ] ||
    { failures=$((failures + 1)); echo "FAILED: lares $*: offered are $output"; }
  for name in $below; do walk "$@" "$name"; done
}
walk
[ "$(ls "$work/man1" | wc -l)" -gt 50 ] || { failures=$((failures + 1)); echo "FAILED: pages are missing"; }

# ---- zsh and fish ------------------------------------------------------------------------------
if command -v zsh >/dev/null; then
  lares completion zsh >"$work/_lares"
  expect 0 zsh -n "$work/_lares"
  # A shell of its own on a pseudo-terminal, as a person has it.
  cat >"$work/drive.zsh" <<'ZSH'
zmodload zsh/zpty
zpty driven "HOME=$1 TERM=dumb zsh -f -i"
say() { zpty -w driven "$1"; }
say "PS1=; PS2=; unsetopt zle_bracketed_paste 2>/dev/null; fpath=($1 \$fpath); autoload -U compinit; compinit -u -d $1/dump; setopt auto_list no_auto_menu; zstyle ':completion:*' list-prompt ''; echo rea''dy"
zpty -r driven text '*ready*'
zpty -w -n driven "$2"$'\t\t'
sleep 1
say ''
text= all=
while zpty -r -t driven text; do all+="$text"; sleep 0.05; done
print -r -- "$all"
zpty -d driven
ZSH
  expect 0 zsh -f "$work/drive.zsh" "$work" "lares plan --as " && has bt-xml pddl-problem
  expect 0 zsh -f "$work/drive.zsh" "$work" "lares environment " && has release "List environments"
fi
if command -v fish >/dev/null; then
  lares completion fish >"$work/lares.fish"
  expect 0 fish -n "$work/lares.fish"
  complete_fish() { fish -c 'source $argv[1]; complete -C $argv[2]' "$work/lares.fish" "$1"; }
  expect 0 complete_fish "lares pl" && has plan && lacks prior
  expect 0 complete_fish "lares plan --as " && has bt-xml && lacks README.md
  expect 0 complete_fish "lares plan diff --r" && has --robot
  expect 0 complete_fish "lares recipe put recipes/library/obj" && has object-search.ttl
fi

# ---- The manual --------------------------------------------------------------------------------
expect 0 lares man && has '.TH lares 1' LARES_SERVER
expect 0 lares man plan diff && has '.TH lares\-plan\-diff 1'
expect 4 lares man plann && has "did you mean" plan
if command -v groff >/dev/null; then
  for page in "$work"/man1/*.1; do
    checks=$((checks + 1))
    warnings="$(groff -man -Tutf8 -K utf8 -ww -z "$page" 2>&1)"
    [ -z "$warnings" ] || { failures=$((failures + 1)); echo "FAILED: $page: $warnings"; }
  done
fi
if command -v mandoc >/dev/null; then
  expect 0 mandoc -Tlint -W warning "$work"/man1/*.1
fi
for tool in zsh fish groff mandoc; do
  command -v "$tool" >/dev/null || echo "$tool is not installed: its checks are skipped"
done
