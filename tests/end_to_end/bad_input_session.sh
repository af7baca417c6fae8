#!/usr/bin/env bash
# What goes wrong is told with its place, nothing of it stays, and the server lives.
. "$(dirname "$0")/session.sh"
start_server
bad="$work/bad"
mkdir "$bad"
recipe="$session_root/recipes/library/object-search.ttl"

printf '<?xml version="1.0"?>\n<rdf:RDF xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#">\n<a>' >"$bad/truncated.owl"
expect 3 lares recipe put "$bad/truncated.owl"
has "truncated.owl:3"
{
  printf '<?xml version="1.0"?><!DOCTYPE r [<!ENTITY a0 "aaaaaaaaaa">'
  for i in $(seq 1 12); do printf '<!ENTITY a%d "%s">' "$i" "$(printf "&a$((i - 1));%.0s" $(seq 10))"; done
  printf ']>\n<rdf:RDF xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#"><rdf:Description><rdf:value>&a12;</rdf:value></rdf:Description></rdf:RDF>'
} >"$bad/bomb.owl"
expect 3 lares robot put "$bad/bomb.owl"
has "bomb.owl" "entit"
{
  printf '<rdf:RDF xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#">'
  printf '<rdf:Description>%.0s' $(seq 10000)
} >"$bad/deep.owl"
expect 3 lares ontology put "$bad/deep.owl"
has "deep.owl"
printf '@prefix : <http://x#> .\n:a :b ' >"$bad/cut.ttl"
expect 3 lares recipe put "$bad/cut.ttl"
has "cut.ttl:2"
printf '\x89PNG\r\n\x1a\nnot a map' >"$bad/picture.bt"
expect 3 lares environment put broken --type Kitchen --layer "octomap=$bad/picture.bt"
has "PNG"
expect 4 lares environment log broken
printf '@prefix l: <https://w3id.org/lares#> . <http://x#r> a l:Recipe .\n' >"$bad/empty-recipe.ttl"
expect 3 lares recipe put "$bad/empty-recipe.ttl"
has "no task"
expect 4 lares plan NoSuchTask --robot nobody
expect 4 lares where Unobtainium
expect 3 lares recipe put --id ../../etc "$recipe"
expect 2 lares plan
expect 2 lares frobnicate
expect 6 lares status --server http://127.0.0.1:1
has "lares serve"
expect 0 lares recipe list --json
lacks "truncated" "empty-recipe" "cut"
expect 0 lares status
