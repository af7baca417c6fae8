#!/usr/bin/env bash
# Why something holds, why not, how far apart classes are: over the real binary.
. "$(dirname "$0")/session.sh"
start_server
cat >"$work/mugs.ttl" <<'TTL'
@prefix : <https://w3id.org/lares#> .
@prefix owl: <http://www.w3.org/2002/07/owl#> .
@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
<urn:mugs> a owl:Ontology .
<urn:mugs#TeaMug> a owl:Class ; rdfs:subClassOf :Cup .
<urn:mugs#myMug> a <urn:mugs#TeaMug> .
TTL
expect 0 lares ontology put "$work/mugs.ttl" --id mugs

expect 0 lares why myMug a Cup
has "cax-sco" "table 7" "mugs"
expect 0 lares why myMug a Cup --svg "$work/proof.svg"
expect 0 xmllint --noout "$work/proof.svg"
expect 0 lares --json why myMug a Cup
has '"rule"' '"cax-sco"'
expect 0 curl -fsS -H 'Accept: image/svg+xml' "$LARES_SERVER/v1/why?subject=myMug&predicate=a&object=Cup"
has "<svg"
expect 4 lares why myMug a Furniture
has "does not hold" "why-not"
expect 4 lares why nothingOfTheKind a Cup
has "nothing is called 'nothingOfTheKind'"
expect 3 lares why '<not closed' a Cup

expect 0 lares why-not myMug a Furniture
has "furniture" "does not hold"
expect 5 lares why-not myMug a Cup

# A grandparent is at distance 2, whatever else is stated.
expect 0 lares distance urn:mugs#TeaMug Cup
has "Rada: 1 edges"
expect 0 lares distance Cup Cup --measure wu-palmer
has "100"
expect 4 lares distance Cup myMug
