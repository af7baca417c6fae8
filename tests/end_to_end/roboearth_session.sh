#!/usr/bin/env bash
# The user's session on RoboEarth's original files, with our modules alone and then with RoboEarth's
# own ontology and SRDL added: the same answers.
. "$(dirname "$0")/session.sh"
need_data
data="$LARES_DATA/roboearth"
start_server

expect 3 lares recipe put "$data/recipes/exploration-recipe.owl"
has "exploration-recipe.owl:715:" "comment" "--recover"
expect 0 lares recipe put --recover "$data/recipes/exploration-recipe.owl"
has "715" "comment"
expect 0 lares recipe put "$data/recipes/object-search-recipe.owl"
expect 0 lares recipe put "$data/recipes/serve_drink.owl"
for robot in pioneer amigo PR2; do expect 0 lares robot put "$data/robots/$robot.owl"; done
expect 0 lares environment put hospital-room --type HospitalRoom \
  --layer "semantic=$data/maps/ias_hospital_room.owl" --layer "octomap=$LARES_DATA/octomap/geb079.bt"
expect 0 lares prior import "$LARES_DATA/priors/omics/locations.rdf" --format omics

golden() {
  for robot in pioneer amigo PR2; do
    expect 0 lares plan FindBottle --robot "$robot" --environment hospital-room
    has "go-to-next-best-pose" "check-if-found" "exhausted" "added"
  done
  for robot in pioneer amigo; do expect 0 lares plan RobotEnvironmentExploration --robot "$robot"; done
  expect 7 lares plan RobotEnvironmentExploration --robot PR2
  has "VisualSlamMappingComponent"
  expect 7 lares plan RobotEnvironmentExploration --robot PR2 --json
  checks=$((checks + 1))
  repair="$(sed -n '/"smallest_repair"/,/]/p' <<<"$output")"
  grep -q "VisualSlamMappingComponent" <<<"$repair" && ! grep -qi camera <<<"$repair" ||
    { failures=$((failures + 1)); echo "FAILED: the repair for PR2 is: $repair"; }
  for robot in amigo PR2; do expect 0 lares plan ServeADrink --robot "$robot"; done
  expect 7 lares plan ServeADrink --robot pioneer
  has "ArmComponent" "ArmMotionController" "ManipulationEntity" "amigo" "PR2" "smallest repair is to add"
  for form in json bt-xml dot text; do
    expect 0 lares plan FindBottle --robot pioneer --environment hospital-room --as "$form"
  done
}
golden
expect 0 lares where Cup --prior omics
has "omics" "72.8" "16.1" "3.9" "2.1" "1.0"
expect 0 lares where Cup
has "lares"
expect 0 lares where Bottle --environment hospital-room
has "seen" "bottle1"
expect 0 lares environment get hospital-room --version 1 --out "$work/room"
checks=$((checks + 1))
cmp -s "$data/maps/ias_hospital_room.owl" "$work"/room/semantic.owl ||
  { failures=$((failures + 1)); echo "FAILED: the semantic layer came back changed:"; ls "$work/room"; }
expect 0 lares environment list
has "hospital-room"
expect 0 lares environment log hospital-room
has "semantic" "octomap"

for object in Cup Bottle Milk; do lares where "$object"; done >"$work/places-before"
for file in "$data"/ontology/*.owl "$data"/srdl/*.owl; do expect 0 lares ontology put "$file"; done
golden
for object in Cup Bottle Milk; do lares where "$object"; done >"$work/places-after"
checks=$((checks + 1))
cmp "$work/places-before" "$work/places-after" ||
  { failures=$((failures + 1)); echo "FAILED: another ontology changed our table's answers"; }
expect 0 lares where Cup --prior omics
has "72.8" "16.1"
expect 0 lares ontology put "$LARES_DATA/soma/SOMA-HOME.owl"
has "statements read"
for map in "$data"/maps/*.owl; do
  name="$(basename "$map" .owl)"
  expect 0 lares environment put "$name" --layer "semantic=$map"
done
expect 0 lares where Bed --environment ias_hospital_room_with_objects
has "seen"
# Down as RDF/XML and up again: the same objects, with pose, class, times, model and wholes.
layer="$LARES_SERVER/v1/environments/ias_hospital_room_with_objects/versions/latest/layers/semantic"
expect 0 curl -fsS -H "Accept: application/rdf+xml" -o "$work/back.owl" "$layer"
expect 0 lares environment put back --layer "semantic=$work/back.owl"
for name in ias_hospital_room_with_objects back; do
  curl -fsS "$LARES_SERVER/v1/environments/$name/versions/latest/objects?limit=1000" >"$work/objects-$name"
done
expect 0 cmp "$work/objects-ias_hospital_room_with_objects" "$work/objects-back"
expect 0 cat "$work/objects-back"
has "door_handle" "part_of" "SemanticEnvironmentMap7635" "position_m"
expect 0 lares where Cabinet --environment ias_hospital_room
has "seen" "cabinet1"
stop_server
start_server # what was acknowledged is still there
expect 0 lares plan FindBottle --robot PR2 --environment hospital-room
