#!/usr/bin/env bash
# ./start's demonstration holds, and holds again on a server that has seen it.
. "$(dirname "$0")/session.sh"
start_server
expect 0 bash "$session_root/demo/demonstration.sh"
has "object-search" "scout" "Cup" "BTCPP_format=\"4\"" "smallest repair is to add" "helper"
expect 0 bash "$session_root/demo/demonstration.sh"
expect 0 lares environment list
has "flat"
stop_server
