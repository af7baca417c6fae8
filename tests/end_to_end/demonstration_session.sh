#!/usr/bin/env bash
# ./start's demonstration holds, and holds again on a server that has seen it.
. "$(dirname "$0")/session.sh"
cd "$session_root" || exit 1
start_server
expect 0 bash "$session_root/demo/demonstration.sh"
has "object-search" "scout" "Cup" "BTCPP_format=\"4\"" "smallest repair is to add" "helper"
expect 0 bash "$session_root/demo/demonstration.sh"
expect 0 lares environment list
has "flat"
if [ -d "${LARES_DATA:-}/objects/bed1" ]; then
  expect 0 lares object-model list
  has "0.68 × 0.28 × 2 m" "0.68 × 0.68 × 0.34 m" "0.05 × 0.126 × 0.049 m" "SURF"
  expect 0 lares object-model list --class Container --maker roboearth
  has "bottle"
  lacks "bed"
  expect 0 lares object-model typical HospitalRoom --download "$work/models"
  has "3 models" "a model of bed, counted as hospital bed" "a model of cabinet" "a model of bottle"
  expect 0 cmp "$work/models/bed/face_000.ply" "$LARES_DATA/objects/bed1/face_000.ply"
  expect 0 cmp "$work/models/bottle/bottle.ttl" demo/object-models/bottle.ttl
  expect 0 lares object-model typical HospitalRoom --max-models 1
  has "1 model" "as 1 are loaded already"
  expect 0 lares object-model typical HospitalRoom --robot scout
  has "0 models" "Scout has no SURF object recognition"
  expect 0 lares robot put robots/models/pioneer-p3dx.ttl
  expect 0 lares object-model typical HospitalRoom --robot pioneer-p3dx
  has "3 models" "of which it is not said whether it is SURF object recognition"
  expect 0 lares object-model typical HospitalRoom --robot pioneer-p3dx --strict
  has "0 models"
fi
stop_server
