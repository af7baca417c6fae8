#!/usr/bin/env bash
# One recipe, two robots, two environments: four plans, and what differs between each two of them.
. "$(dirname "$0")/session.sh"
start_server
cd "$session_root" || exit 1
expect 0 lares recipe put recipes/library/object-search.ttl
for robot in scout helper; do expect 0 lares robot put "robots/models/$robot.ttl"; done
expect 0 lares environment put suite --type Apartment --layer semantic=demo/suite.ttl
other="demo/flat.ttl" kind="Apartment"
[ -n "${LARES_DATA:-}" ] && other="$LARES_DATA/roboearth/maps/ias_hospital_room.owl" kind="HospitalRoom"
expect 0 lares environment put other --type "$kind" --layer "semantic=$other"

for robot in scout helper; do
  for place in suite other; do
    file="$work/$robot-$place"
    expect 0 lares plan ObjectSearch --object Cup --robot "$robot" --environment "$place" --as json --out "$file.json"
    expect 0 lares plan ObjectSearch --object Cup --robot "$robot" --environment "$place" --as bt-xml --out "$file.xml"
    expect 0 lares plan ObjectSearch --object Cup --robot "$robot" --environment "$place" --as pddl-domain
    has "(define (domain objectsearch)" ":action look-for-object__true"
    expect 0 lares plan ObjectSearch --object Cup --robot "$robot" --environment "$place" --as pddl-problem
    has "(:domain objectsearch)" "(:goal (succeeded))"
    expect 0 lares plan diff "$file.json" "$file.json"
    has "The plans are equal."
  done
done
expect 0 xmllint --noout --schema docs/schemas/behavior-tree.xsd "$work"/*.xml

# Two robots in one place: their bodies differ, the place does not.
for place in suite other; do
  expect 1 lares plan diff "$work/scout-$place.json" "$work/helper-$place.json"
  has "a Scout <scout1>" "b Helper <helper1>" "parameter camera_pose" "0 0 1.09 0 0 0 1" \
    "[robot: camera_link on base_footprint]"
  lacks "  environment " "  skill " "  transition "
done
# One robot in two places: the body is the same.
for robot in scout helper; do
  expect 1 lares plan diff "$work/$robot-suite.json" "$work/$robot-other.json"
  has "environment" "a suite (version 1)" "b other (version 1)"
  lacks "  robot " "camera_pose"
done
# Both differ, asked of the server as files and as a task: the same answer.
expect 1 lares plan diff "$work/scout-suite.json" "$work/helper-other.json"
files="$output"
has "  robot " "a suite (version 1)" "b other (version 1)" "camera_pose"
expect 1 lares plan diff ObjectSearch --set object=Cup --robot scout --robot helper --environment suite --environment other
checks=$((checks + 1))
[ "$output" = "$files" ] || { failures=$((failures + 1)); echo "FAILED: files and task differ: $output"; }
expect 0 lares plan diff ObjectSearch --set object=Cup --robot scout --environment suite
expect 1 lares plan diff ObjectSearch --set object=Cup --robot scout --robot helper --json
has '"format": "lares-plan-diff"' '"equal": false'

# What is no plan, no file, no task, no robot.
expect 4 lares plan diff "$work/nowhere.json" "$work/scout-suite.json"
echo '{"format": "lares-plan", "format_version": 1}' >"$work/half.json"
expect 3 lares plan diff "$work/half.json" "$work/scout-suite.json"
has "plan a: / lacks"
expect 3 lares plan diff demo/suite.ttl "$work/scout-suite.json"
expect 2 lares plan diff object-search
expect 2 lares plan diff
expect 2 lares plan
expect 4 lares plan diff no-such-task --robot scout
expect 4 lares plan no-such-task --robot scout
