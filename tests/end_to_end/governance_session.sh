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
stop_server
