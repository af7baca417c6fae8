#!/usr/bin/env bash
# The main job on Lares' own documents, through the command line. ./start runs it; with a server
# running and `lares` on PATH it can be run by hand, again and again.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")/.."

say() { printf '\n\033[1m%s\033[0m\n' "$*"; }
run() { printf '$ lares %s\n' "$*"; lares "$@"; }

say "Two recipes and two robots: what to do, and who might do it"
run recipe put recipes/library/object-search.ttl
run recipe put recipes/library/fetch-drink.ttl
run robot put robots/models/scout.ttl
run robot put robots/models/helper.ttl

say "A small flat: its semantic map and an occupancy grid"
if lares environment list --json | grep -q '"id": *"flat"'; then
  echo "(already here: lares environment log flat)"
else
  run environment put flat --type Home --layer semantic=demo/flat.ttl --layer grid=demo/flat.yaml
fi

say "A plan made for one robot"
run plan ObjectSearch --object Cup --robot scout --environment flat

say "What a robot without an arm is told"
status=0
run plan fetch-drink --robot scout --environment flat || status=$?
[ "$status" = 7 ] || { echo "expected a refusal (exit code 7), got $status" >&2; exit 1; }

say "The same task for a robot with an arm, as a behaviour tree"
run plan fetch-drink --robot helper --environment flat --as bt-xml | sed -n 1,20p
echo "  …"

say "Where is the cup? Where would one be?"
run where Cup --environment flat

objects="${LARES_DATA:-}/objects"
if [ -d "$objects/bed1" ] && [ -d "$objects/cabinet1" ] && [ -d "$objects/bottle1" ]; then
  say "Models of a bed, a cabinet and a bottle, made by RoboEarth"
  for model in bed cabinet bottle; do
    run object-model put "demo/object-models/$model.ttl" "$objects/${model}1"/*
  done
  run object-model list --class Furniture

  say "Which of them are worth loading for a hospital room, and why? Which can this robot use?"
  run object-model typical HospitalRoom
  run object-model typical HospitalRoom --robot scout
fi
