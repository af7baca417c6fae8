#!/usr/bin/env bash
# A robot takes along what its plan needs: from the demonstration's flat, and from real maps.
. "$(dirname "$0")/session.sh"
start_server
cd "$session_root" || exit 1
pack() {
  local object=()
  [ "$1" = object-search ] && object=(--object Cup)
  lares plan "$1" "${object[@]}" --robot "$2" --environment "$3" --package "$work/$4"
}

expect 0 lares robot put robots/models/scout.ttl
expect 0 lares robot put robots/models/helper.ttl
expect 0 lares recipe put recipes/library/object-search.ttl
expect 0 lares environment put flat --type Home --layer semantic=demo/flat.ttl --layer grid=demo/flat.yaml
expect 0 pack object-search scout flat bare
has "no object model is stored for cup" "there is no octomap layer" "inflated by 0.29 m" "grid/map.yaml"
expect 0 cmp "$work/bare/layers/semantic.ttl" demo/flat.ttl

cat >"$work/mug.ttl" <<'TTL'
@prefix lares: <https://w3id.org/lares#> .
@prefix owl: <http://www.w3.org/2002/07/owl#> .
<urn:session:mug> a lares:ObjectRecognitionModel ; lares:providesModelFor lares:Mug .
TTL
expect 0 lares object-model put "$work/mug.ttl" demo/flat.pgm
expect 0 pack object-search scout flat mission
has "object model mug is of mug, which is a kind of cup"
expect 0 cmp "$work/mission/models/mug/flat.pgm" demo/flat.pgm
expect 0 xmllint --noout "$work/mission/plan.xml"
expect 0 head -c 15 "$work/mission/grid/map.pgm"
has "P5" "180 150"
expect 0 cat "$work/mission/grid/map.yaml"
has "image: map.pgm" "mode: trinary" "resolution: 0.05" "origin: [-0.5, -0.5, 0]" "negate: 0"
# Our own reader takes what was written, as any robot would send it back.
expect 0 lares environment put back --layer "grid=$work/mission/grid/map.yaml"

# A larger robot has less room in the same flat.
expect 0 pack object-search helper flat larger
free() { sed -n 's/.*"free": \([0-9]*\).*/\1/p' "$work/$1/package.json"; }
checks=$((checks + 1))
[ "$(free larger)" -lt "$(free mission)" ] ||
  { failures=$((failures + 1)); echo "FAILED: $(free larger) free cells for helper, $(free mission) for scout"; }

# Refused or cut off, nothing is left.
expect 5 pack object-search scout flat mission
expect 4 pack object-search nobody flat nothing
expect 2 ls "$work/nothing"
head -c 60000000 /dev/zero >"$work/features.bin"
expect 0 lares environment put large --layer "features=$work/features.bin"
lares plan ObjectSearch --object Cup --robot scout --environment large --package "$work/cut-off" >/dev/null 2>&1 &
packing=$!
for _ in $(seq 200); do
  compgen -G "$work/.lares-package-*" >/dev/null && break
  sleep 0.01
done
kill -TERM "$packing" 2>/dev/null
wait "$packing" 2>/dev/null
expect 2 ls "$work/cut-off"
expect 1 compgen -G "$work/.lares-package-*"

if [ -n "${LARES_DATA:-}" ]; then
  data="$LARES_DATA/roboearth"
  expect 0 lares recipe put "$data/recipes/object-search-recipe.owl"
  expect 0 lares robot put "$data/robots/pioneer.owl"
  expect 0 lares environment put hospital-room --type HospitalRoom \
    --layer "semantic=$data/maps/ias_hospital_room.owl" --layer "octomap=$LARES_DATA/octomap/geb079.bt"
  expect 0 pack FindBottle pioneer hospital-room bottle
  has "0.08 m voxels" "is not stated: 1.8 m are assumed" "obstacles are not inflated" "no object model is stored for"
  expect 0 cmp "$work/bottle/layers/octomap.bt" "$LARES_DATA/octomap/geb079.bt"
  expect 0 lares environment put corridor --layer "grid=$work/bottle/grid/map.yaml"
  url="$LARES_SERVER/v1/environments/hospital-room/versions/1/robot-grid"
  expect 0 curl -fsS -o "$work/helper.pgm" "$url/helper/map.pgm"
  expect 0 curl -fsS -r 0-1 "$url/helper/map.pgm"
  has "P5"
  tag="$(curl -fsSI "$url/helper/map.pgm" | tr -d '\r' | sed -n 's/^[Ee][Tt][Aa][Gg]: //p')"
  expect 0 curl -sS -o /dev/null -w '%{http_code}' -H "If-None-Match: $tag" "$url/helper/map.pgm"
  has "304"
fi
