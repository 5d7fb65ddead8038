#!/usr/bin/env bash
# demlua study as a user meets it: what it runs, what it writes, what it refuses.
set -u

demlua=$DEMLUA
failures=0

fail() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}

# expect CODE ARGUMENT...: runs demlua study; its words are in out.txt and err.txt afterwards.
expect() {
  local code=$1
  shift
  "$demlua" study "$@" >out.txt 2>err.txt
  local got=$?
  ((got == code)) || { fail "demlua study $*: exit code $got, not $code"; cat out.txt err.txt; }
}

says() { grep -qF -- "$2" "$1" || { fail "$1 lacks: $2"; head -n 20 "$1"; }; }
lacks() { ! grep -qF -- "$2" "$1" || { fail "$1 has: $2"; head -n 20 "$1"; }; }
exactly() { [[ $(cat "$1") == "$2" ]] || { fail "$1 is not: $2"; head -n 20 "$1"; }; }
none() { [[ ! -e $1 ]] || fail "$1 is there"; }
there() { [[ -e $1 ]] || fail "$1 is not there"; }

# scene NAME STUDY [RESULT [RUN]]: one free disk whose results follow a law of their own, 2 + 50 radius^2 + 0.001 seed.
scene() {
  cat >"$1.lua" <<END
local dem = require "dem"
local p = dem.param { radius = { 4e-3, "m" }, seed = 0, scheme = "plain" }
local rock = dem.material { name = "rock", youngs_modulus = 1e9, poissons_ratio = 0.2, density = 2000 }
local sim = dem.simulation { title = "Law" }
sim:body { name = "stone", material = rock, packing = dem.disks { { 0, 0, p.radius } }, velocity = { 1, 0 } }
$2
sim:run { ${4:-duration = 1e-3} }
dem.result { ${3:-height = 2 + 50 * p.radius ^ 2 + 0.001 * p.seed} }
END
}

# json EXPRESSION: asks study.json of the last folder named in $folder; `s` is the study, `l` the levels of its first series.
json() {
  python3 -c "
import json, sys
s = json.load(open('$folder/study.json'))
l = s['series'][0]['levels']
sys.exit(0 if ($1) else 1)" || fail "$folder/study.json: not $1"
}

# ---- a study, and what it leaves -----------------------------------------------------------------
law='dem.study { vary = { radius = { 2e-3, 8e-3, 4e-3 } }, measure = "height", unit = "m", reference = function(q) return 2 end }'
scene law "$law"
folder=law.study
expect 0 law.lua
says out.txt "radius = 0.008: "
says out.txt "p (eq 20)"
says out.txt "open it in a browser: law.study/study.html"
for file in study.csv study.json study.html error_size.svg error_time.svg radius=0.004/summary.json; do there "law.study/$file"; done
# f = 2 + 50 h^2: eq 20 gives p = 2, eq 38 gives 2, the errors are 25 h^2.
json "[x['size'] for x in l] == [8e-3, 4e-3, 2e-3]"
json "all(abs(x['error'] - 25 * x['size'] ** 2) < 1e-12 for x in l)"
json "abs(l[2]['order'] - 2) < 1e-6 and abs(l[2]['extrapolated'] - 2) < 1e-12 and abs(l[1]['order_of_error'] - 2) < 1e-9"
json "all(x['wall_time'] > 0 and x['peak_memory'] > 1e6 and x['elements'] == 1 and x['steps'] > 0 for x in l)"
[[ $(wc -l <law.study/study.csv) == 4 ]] || fail "study.csv has not a heading and three levels"
says law.study/study.csv '"",0.008,1,1,'
for text in "<svg" "slope 2.00" "wall time (s)" "radius (m)" "<table>"; do says law.study/study.html "$text"; done
for text in "<script" "href=" "src="; do lacks law.study/study.html "$text"; done
python3 -c "import xml.dom.minidom as x; [x.parse('law.study/error_' + n + '.svg') for n in ('size', 'time')]" || fail "a picture is no XML"

# ---- finished runs are not run again -------------------------------------------------------------
touch -d 2000-01-01 law.study/radius=*/summary.json
expect 0 law.lua
says out.txt "3 of 3 runs finished earlier"
lacks out.txt "radius = 0.008: "
[[ -z $(find law.study -name summary.json -newermt 2001-01-01) ]] || fail "a finished run was run again"
scene law "${law/8e-3, 4e-3/8e-3, 4e-3, 16e-3}"
expect 0 law.lua
lacks out.txt "finished earlier"  # the text of the scene has changed
expect 0 law.lua --set seed=1
lacks out.txt "finished earlier"
expect 0 law.lua --set seed=1 --fresh
lacks out.txt "finished earlier"

printf 'dem.include "law.lua" {}\n' | sed '1i local dem = require "dem"' >including.lua
expect 0 including.lua
expect 0 including.lua
says out.txt "finished earlier"
echo "-- changed" >>law.lua
expect 0 including.lua
lacks out.txt "finished earlier"

# ---- the two coarsest, side by side, quiet -------------------------------------------------------
expect 0 law.lua --quick -o quick
folder=quick
json "[x['size'] for x in l] == [16e-3, 8e-3] and s['quick']"
none quick/radius=0.002
expect 0 law.lua --jobs 3 -o side
folder=side
json "all(x['wall_time'] is None for x in l) and abs(l[3]['order'] - 2) < 1e-6"
says out.txt "no times where levels have run side by side"
expect 0 law.lua --quiet -o quick
exactly out.txt ""

# ---- seeds, series, the finest level as reference ------------------------------------------------
scene many 'dem.study { vary = { radius = { 8e-3, 4e-3 }, scheme = { "plain", "odd" } }, measure = "height", reference = "finest", seeds = 3 }'
folder=many.study
expect 0 many.lua
json "[x['name'] for x in s['series']] == ['scheme = plain', 'scheme = odd']"
json "len(l[0]['runs']) == 3 and abs(l[0]['scatter'] - 1e-3) < 1e-12"
json "l[1]['error'] is None and abs(l[0]['value'] - l[0]['reference'] - 50 * (8e-3 ** 2 - 4e-3 ** 2)) < 1e-12"
scene published 'dem.study { vary = { radius = { 8e-3, 4e-3 } }, measure = "height" }' 'height = 3, reference = 2'
folder=published.study
expect 0 published.lua
json "all(x['error'] == 0.5 for x in l)"

# ---- a plain run takes no notice -----------------------------------------------------------------
"$demlua" law.lua --quiet >out.txt 2>err.txt || fail "a plain run of a scene with a study"
there law.out/summary.json

# ---- wrong studies: told before anything is run --------------------------------------------------
refused() { # NAME STUDY MESSAGE [RESULT]
  scene "$1" "$2" "${4:-height = 2}"
  expect 2 "$1.lua"
  exactly err.txt "$3"
  none "$1.study"
}
refused no_reference 'dem.study { vary = { radius = { 8e-3, 4e-3 } }, measure = "height" }' \
  'no_reference.lua:6: study.reference: is missing; give a number, a function of the parameters or "finest", or publish `reference` with dem.result'
refused no_parameter 'dem.study { vary = { radios = { 8e-3, 4e-3 } }, measure = "height", reference = 2 }' \
  'no_parameter.lua:6: study.vary.radios: no such parameter in this scene; did you mean "radius"?'
refused wrong_kind 'dem.study { vary = { radius = { 8e-3, "small" } }, measure = "height", reference = 2 }' \
  'wrong_kind.lua:6: study.vary.radius = "small": must be a number, as the parameter is'
refused which_size 'dem.study { vary = { radius = { 8e-3 }, seed = { 1 } }, measure = "height", reference = 2 }' \
  'which_size.lua:6: study.vary.seed = { 1 }: seeds are given as study.seeds'
refused negative 'dem.study { vary = { radius = { 8e-3, -4e-3 } }, measure = "height", reference = 2 }' \
  'negative.lua:5: disks[1][3] = -0.004: must be positive; with radius = -0.004'
expect 2 "$DEMLUA_SOURCE_DIR/scenarios/bonded_pair.lua"
says err.txt "bonded_pair.lua: dem.study: is missing"
expect 2 law.lua --set radius=1 --jobs 0 --fresk
says err.txt "--jobs = 0: a whole number from 1 to 64"
says err.txt "--fresk: unknown option; did you mean --fresh?"
expect 2 law.lua --set radius=1
exactly err.txt "--set radius = 1: is varied by the study"
echo x >file
expect 2 law.lua -o file
says err.txt "output folder = file"

# ---- what only a run can tell --------------------------------------------------------------------
scene misspelt 'dem.study { vary = { radius = { 8e-3 } }, measure = "hight", reference = 2 }'
expect 3 misspelt.lua
exactly err.txt 'misspelt.lua:6: study.measure = "hight": is no result of this scene; did you mean "height"?'
scene failing 'dem.study { vary = { radius = { 8e-3, 4e-3 } }, measure = "height", reference = 2 }
sim:every { 1e-4, function(now) if p.radius < 5e-3 then error("too small") end end }'
expect 3 failing.lua
says err.txt "failing.lua: radius = 0.004: failing.lua:7: too small"
expect 3 failing.lua
says out.txt "1 of 2 runs finished earlier"

# ---- Ctrl-C: finished runs stay ------------------------------------------------------------------
scene long 'dem.study { vary = { radius = { 8e-3, 4e-3 } }, measure = "height", reference = 2 }' '' \
  'duration = p.radius > 5e-3 and 1e-3 or 1e6'
"$demlua" study long.lua >out.txt 2>err.txt &
process=$!
tries=0
until [[ -e long.study/radius=0.004/history.csv ]] || ((++tries > 300)); do sleep 0.1; done
kill -INT "$process"
wait "$process"
code=$?
((code == 130)) || fail "SIGINT: exit code $code"
exactly err.txt "interrupted: 1 of 2 runs are finished; the same command goes on from there"
says long.study/radius=0.004/summary.json '"state": "interrupted"'
none long.study/radius=0.004/study_run.json
there long.study/radius=0.008/study_run.json

((failures == 0)) && echo "all as expected"
exit $((failures > 0))
