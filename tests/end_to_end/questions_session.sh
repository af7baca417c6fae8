#!/usr/bin/env bash
# Questions in SPARQL over the real binary, and events when a commit changes an answer.
. "$(dirname "$0")/session.sh"
start_server
cat >"$work/cups.ttl" <<'TTL'
@prefix : <https://w3id.org/lares#> .
@prefix owl: <http://www.w3.org/2002/07/owl#> .
@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
<urn:session:cups> a owl:Ontology .
<urn:session#TeaGlass> a owl:Class ; rdfs:subClassOf :Cup .
TTL
query='SELECT ?kind { ?kind rdfs:subClassOf lares:Cup FILTER(?kind != lares:Cup && STRSTARTS(STR(?kind), "urn:session")) }'

expect 0 lares sparql -q "$query"
has "?kind" "0 rows"

# Somebody watches; a commit that changes the answer is told, one that does not is not.
lares watch -q "$query" --events 3 >"$work/watch.out" 2>&1 &
watcher=$!
lines() { for _ in $(seq 50); do [ "$(wc -l <"$work/watch.out")" -ge "$1" ] && return; sleep 0.1; done; }
lines 1
expect 0 lares recipe put "$session_root/recipes/library/object-search.ttl"
expect 0 lares ontology put "$work/cups.ttl" --id cups
lines 3
expect 0 cat "$work/watch.out"
has ": 0 rows" ": 1 row" "+ ?kind = <urn:session#TeaGlass>"
lacks "- ?kind"
expect 0 lares ontology remove cups
wait "$watcher"
expect 0 cat "$work/watch.out"
has "- ?kind = <urn:session#TeaGlass>"

expect 0 lares ontology put "$work/cups.ttl" --id cups
expect 0 lares sparql -q "$query"
has "<urn:session#TeaGlass>" "1 row"
expect 0 lares sparql -q 'ASK { GRAPH <https://w3id.org/lares/documents/ontology/cups> { ?s a owl:Class } }'
has "yes"
expect 0 lares sparql -q "$query" --format csv
has "urn:session#TeaGlass"
expect 0 lares sparql -q "$query" --explain run
expect 3 lares sparql -q 'SELECT nothing'
expect 8 lares sparql -q 'SELECT (COUNT(*) AS ?n) { ?a ?b ?c . ?d ?e ?f . ?g ?h ?i . ?j ?k ?l }' --timeout 0.5
expect 0 curl -fsS "$LARES_SERVER/metrics"
has "lares_snapshots_pinned 0" 'lares_http_requests_total{operation="watchQuery",status="200"} 1'

# The server's end ends a watch at once.
lares watch -q "$query" >"$work/watch.out" 2>&1 &
watcher=$!
lines 1
SECONDS=0
stop_server
expect 8 wait "$watcher"
checks=$((checks + 1))
[ "$SECONDS" -lt 10 ] || { failures=$((failures + 1)); echo "FAILED: the server took $SECONDS s to stop"; }
