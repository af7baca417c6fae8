#!/usr/bin/env bash
# Who may say what, and what contradicts: refused, sent as an editor, kept aside and released.
. "$(dirname "$0")/session.sh"
start_server
prefixes='@prefix : <http://example.org/test#> . @prefix lares: <https://w3id.org/lares#> .
@prefix owl: <http://www.w3.org/2002/07/owl#> . @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .'
echo "$prefixes lares:Cup rdfs:subClassOf :Weapon ." >"$work/weapons.ttl"
echo "$prefixes :Cat owl:disjointWith :Dog ." >"$work/zoo.ttl"
echo "$prefixes :tom a :Cat , :Dog ." >"$work/tom.ttl"

expect 3 lares ontology put "$work/weapons.ttl"
has "Cup subClassOf Weapon" "module:objects" "weapons.ttl:2" "--editor"
expect 0 lares ontology put --editor "$work/weapons.ttl"
expect 0 lares ontology put "$work/zoo.ttl"
expect 3 lares ontology put "$work/tom.ttl"
has "which exclude each other" "ontology:zoo" "--quarantine"
expect 0 lares ontology put --quarantine "$work/tom.ttl"
has "kept aside"
expect 0 lares quarantine list
has "ontology tom" "which exclude each other"
expect 0 lares ontology list
has "quarantined"
expect 3 lares ontology release tom
expect 0 lares ontology remove zoo
expect 0 lares ontology release tom
expect 0 lares quarantine list
has "nothing is kept aside"
expect 4 lares ontology release tom

# The semantic layer of an environment, likewise; the environment stays as it was meanwhile.
expect 0 lares ontology remove tom
expect 0 lares ontology put "$work/zoo.ttl"
echo "$prefixes :m a lares:SemanticEnvironmentMap ." >"$work/flat.ttl"
echo "$prefixes :m a lares:SemanticEnvironmentMap . :kim a :Cat , :Dog ." >"$work/kim.ttl"
echo "$prefixes :m a lares:SemanticEnvironmentMap . lares:Cup rdfs:subClassOf :Toy ." \
  >"$work/toys.ttl"
echo "0 0 0 0 0 0 0 1" >"$work/path.txt"
expect 0 lares environment put flat --layer semantic="$work/flat.ttl"
expect 3 lares environment put flat --layer semantic="$work/kim.ttl"
has "which exclude each other" "--quarantine"
expect 3 lares environment put flat --quarantine --layer semantic="$work/kim.ttl" \
  --layer trajectory="$work/path.txt"
has "only a semantic layer can be kept aside"
expect 0 lares environment put flat --quarantine --layer semantic="$work/kim.ttl"
has "kept aside as environment.flat" "environment flat is as it was"
expect 0 lares quarantine list
has "environment flat" "which exclude each other"
expect 3 lares environment release flat
expect 0 lares ontology remove zoo
expect 0 lares environment release flat
has "environment flat, version 2"
expect 4 lares environment release flat
expect 3 lares environment put flat --layer semantic="$work/toys.ttl"
has "Cup subClassOf Toy" "--editor"
expect 0 lares environment put flat --editor --layer semantic="$work/toys.ttl"
stop_server
