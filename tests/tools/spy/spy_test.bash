#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
# SPDX-License-Identifier: BSD-3-Clause
# fallen-spy as a person uses it, on a screen of its own: types decoded, the plugins' plan and status drawn, the
# log player opened; and a subscriber in Java. Screenshots are left in OUT, to be looked at.
# usage: spy_test.bash BIN SOURCE OUT LCM_JAR
set -euo pipefail
bin=$1 source=$2 out=$3 lcm=$4

for tool in Xvfb xdotool import convert java lcm-logplayer; do
  command -v "$tool" >/dev/null || { echo "skipped: $tool is missing"; exit 77; }
done
if [ -z "${FALLEN_SPY_TEST_NETWORK:-}" ]; then
  unshare --net --map-root-user true 2>/dev/null || { echo "skipped: no network namespace can be made"; exit 77; }
  exec env FALLEN_SPY_TEST_NETWORK=1 unshare --net --map-root-user -- bash -c \
    'ip link set lo up multicast on && ip route add 224.0.0.0/4 dev lo && exec "$0" "$@"' "$0" "$@"
fi

work=$(mktemp -d)
pids=()
leave() {
  for pid in "${pids[@]}"; do kill "$pid" 2>/dev/null || true; done
  rm -rf "$work"
}
trap leave EXIT
fail() {
  echo "failed: $*" >&2
  cat "$work"/*.log >&2
  import -window root "$out/failed.png" 2>/dev/null && echo "see $out/failed.png" >&2
  exit 1
}
# until_true SECONDS COMMAND...
until_true() {
  local end=$((SECONDS + $1)); shift
  until "$@" >/dev/null 2>&1; do [ $SECONDS -lt $end ] || return 1; sleep 0.2; done
}

# shows COLOUR: whether it is in a screenshot, which is kept.
shows() {
  import -window root "$out/lcm-spy.png"
  [ "$(convert "$out/lcm-spy.png" -fill black +opaque "$1" -format '%[fx:mean>0]' info:)" = 1 ]
}
# open_plugin ROW WINDOW: the second entry of the menu of a channel, the plugin's, until its window is there.
open_plugin() {
  local y=$((12 + 16 * $1)) _
  for _ in $(seq 8); do
    xdotool mousemove 80 $y click 3
    sleep 1
    xdotool mousemove 130 $((y + 32)) click 1
    until_true 4 xdotool search --name "$2" && return
    xdotool key Escape
  done
  return 1
}

mkdir -p "$out"
export LCM_DEFAULT_URL='udpm://239.255.76.67:7667?ttl=0'
"$bin/fallen-detect" "$source/recordings/demo.lcm" --output "$work/stages.lcm" --json /dev/null 2>"$work/detect.log"

Xvfb -displayfd 3 -screen 0 1280x900x24 3>"$work/display" 2>/dev/null & pids+=($!)
until_true 30 test -s "$work/display" || fail "Xvfb did not start"
export DISPLAY=:$(cat "$work/display")

"$bin/fallen-spy" >"$work/spy.log" 2>&1 & pids+=($!)
java -Djava.net.preferIPv4Stack=true -cp "$lcm:$bin/../share/java/lcmtypes_fallen.jar" \
  fallen.spy.PersonListener >"$work/listener.log" 2>&1 & pids+=($!)
until_true 60 grep -q 'Found 2 plugins' "$work/spy.log" || fail "lcm-spy did not find our plugins"
until_true 60 xdotool search --name 'LCM Spy' || fail "lcm-spy has no window"

play() { lcm-logplayer --lcm-url="$LCM_DEFAULT_URL" --regexp='FALLEN_PERSONS_.*' "$work/stages.lcm" >/dev/null; }
play & player=$!
sleep 2
open_plugin 1 '^FALLEN_PERSONS_CAMERA$' || fail "the plan has no window"
wait $player
play
sleep 1
xdotool search --name '^FALLEN_PERSONS_CAMERA$' windowmove %@ 560 330  # off the list
"$bin/fallen-background-subtraction" --lcm-url "$LCM_DEFAULT_URL" 2>"$work/service.log" & pids+=($!)
sleep 3  # its first status, and a line of the list: the third, after LCM_SELF_TEST
open_plugin 3 '^STATUS_' || fail "the status has no window"
xdotool search --name '^STATUS_' windowmove %@ 100 330
until_true 30 shows 'rgb(207,13,54)' || fail "no status was drawn"  # degraded: it has no environment map
until_true 30 shows 'rgb(214,0,56)' || fail "no person was drawn"
grep -q 'FALLEN_PERSONS_CAMERA frame [0-9]*: fallen person at' "$work/listener.log" || fail "the subscriber heard no person"

"$bin/fallen-spy" --play "$work/stages.lcm" >"$work/player.log" 2>&1 & pids+=($!)
until_true 60 xdotool search --name 'LogPlayer' || fail "the log player has no window"
sleep 2
import -window root "$out/lcm-logplayer-gui.png"

for call in '--play /nowhere.lcm' '--lcm-url' 'nonsense'; do
  status=0
  # shellcheck disable=SC2086
  "$bin/fallen-spy" $call 2>"$work/error.log" || status=$?
  [ $status = 2 ] && [ "$(wc -l <"$work/error.log")" = 1 ] || fail "fallen-spy $call: status $status"
done
echo "types decoded, plan and status drawn, log player open"
