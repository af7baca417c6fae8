#!/usr/bin/env bash
# docs/matching.md, step by step: a recipe of one's own with a number, a refusal, its repair.
. "$(dirname "$0")/session.sh"
start_server
cd "$session_root"

# The commands of the document, as they stand there.
doc=docs/matching.md
while read -r command; do
  expect 0 bash -c "$command"
done < <(sed -n 's/^\$ //p' "$doc")
has "ROBOT" "helper" "scout" "yes" "add arm component, arm motion controller, manipulation entity"
expect 0 bash -c 'lares recipe robots fetch-drink --json'
has '"feasible": false' '"cost": 133.0' '"repair_is_smallest": true'
expect 4 lares recipe robots nothing-of-the-kind

# The requirement of the document, in a recipe of one step.
{
  cat <<'TTL'
@prefix : <https://example.org/look#> .
@prefix lares: <https://w3id.org/lares#> .
@prefix owl: <http://www.w3.org/2002/07/owl#> .
@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
:Look a owl:Class ; rdfs:subClassOf lares:PurposefulAction ,
  [ a owl:Restriction ; owl:onProperty lares:subAction ; owl:someValuesFrom :LookAcross ] .
:LookAcross a owl:Class ; rdfs:subClassOf lares:Perceiving .
TTL
  sed -n '/^```turtle/,/^```/p' "$doc" | grep -v '^```'
} >"$work/look.ttl"
expect 0 lares recipe put "$work/look.ttl"
expect 7 lares plan look --robot scout
has "requires" "camera" "6 m" "too little" "The smallest repair is to add: Camera with a max range of at least 6 m"
expect 7 lares plan look --robot scout --json
has '"insufficient"' '"short_by": 1.5' '"short_by_percent": 25.0' '"unit": "m"'

# A better camera, and it can.
sed 's/maxRange_m "4.5"/maxRange_m "7.5"/' robots/models/scout.ttl >"$work/far-sighted.ttl"
sed -i 's|lares/robots/scout|lares/robots/far-sighted|; s|robots/scout#|robots/far-sighted#|g' "$work/far-sighted.ttl"
expect 0 lares robot put "$work/far-sighted.ttl"
expect 0 lares recipe robots look --json
has '"id": "far-sighted"'
expect 7 lares plan look --robot scout
has "far-sighted"

# Numbers that cannot be are refused with their place.
for bounds in 'lares:atLeast "NaN"' 'lares:atLeast -1' 'lares:atLeast 9 ; lares:atMost 3'; do
  sed "s/lares:atLeast 6.0/$bounds/" "$work/look.ttl" >"$work/bad.ttl"
  expect 3 lares recipe put "$work/bad.ttl"
  has "bad.ttl:7:" "a requirement of 'LookAcross'"
done
