#!/usr/bin/env bash
# The program as a user meets it: exit codes, messages, and what it leaves behind.
set -u

demlua=$DEMLUA
scenes=$DEMLUA_SOURCE_DIR/scenarios
small=$scenes/bonded_pair.lua
failures=0

fail() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}

# expect CODE ARGUMENT...: runs the program; its words are in out.txt and err.txt afterwards.
expect() {
  local code=$1
  shift
  "$demlua" "$@" >out.txt 2>err.txt
  local got=$?
  ((got == code)) || { fail "demlua $*: exit code $got, not $code"; cat out.txt err.txt; }
}

says() { grep -qF -- "$2" "$1" || { fail "$1 lacks: $2"; head -n 5 "$1"; }; }
nothing_in() { [[ ! -s $1 ]] || { fail "$1 is not empty"; cat "$1"; }; }
none() { [[ ! -e $1 ]] || fail "$1 is there"; }
there() { [[ -e $1 ]] || fail "$1 is not there"; }

# Waits until a file is there, 30 s at most.
wait_for() {
  local tries=0
  until [[ -e $1 ]] || ((++tries > 300)); do sleep 0.1; done
}

# ---- asking ----------------------------------------------------------------------------------
expect 0 --help
says out.txt "--overwrite"
expect 0 --version
says out.txt "demlua "
expect 0 --help-scene
says out.txt "body"
expect 0 "$small" --check
says out.txt "bonded_pair.lua: no problems"
none bonded_pair.out
expect 0 "$small" --explain
says out.txt "step: "
says out.txt "time step "
none bonded_pair.out

expect 0 "$small" -o profiled.out --profile
says out.txt "profile, ns per element and step: "
rm -r profiled.out

cat >taken.lua <<'END'
local dem = require "dem"
local stone = dem.material { youngs_modulus = 1e8, poissons_ratio = 0.2, density = 2600 }
local sim = dem.simulation {}
sim:body { name = "a", material = stone, packing = dem.disks { { 0, 0, 0.01 } } }
sim:history { every = 1e-3, contacts = function() return 1 end }
sim:run { duration = 1e-2 }
END
expect 2 taken.lua
says err.txt "taken.lua:5: history.contacts: is the name of a column that the history has anyway"
none taken.out
cat >full.lua <<'END'
local dem = require "dem"
local stone = dem.material { youngs_modulus = 1e8, poissons_ratio = 0.2, density = 2600 }
local sim = dem.simulation {}
sim:grains { name = "bed", material = stone, region = dem.rectangle { size = { 1, 1 } }, radius = 0.05, porosity = 0.2, method = "insertion" }
sim:run { duration = 1e-2 }
END
expect 2 full.lua
says err.txt 'full.lua:4: body.packing = "bed": inserted grains: no place found for grain'
none full.out

# ---- wrong words: every problem on its line, nothing written -------------------------------------
expect 2
says err.txt "FILE.lua: missing"
expect 2 no_such.lua
says err.txt "no_such.lua"
none no_such.out
expect 2 "$small" --treads=2 --threads 0 --set nonsense
says err.txt "--treads=2: unknown option; did you mean --threads?"
says err.txt "--threads = 0: a whole number from 1 to 256"
says err.txt "--set = nonsense: NAME=VALUE"
expect 2 "$small" --threads many
says err.txt "--threads = many"
expect 2 "$small" --set no_such_parameter=1
says err.txt "no_such_parameter"
expect 2 "$small" "$small"
says err.txt "one scene at a time"
printf 'local dem = require "dem"\nthis is not Lua\n' >wrong.lua
expect 2 wrong.lua
says err.txt "wrong.lua:2:"
nothing_in out.txt
none wrong.out
none bonded_pair.out

# ---- a run, and its folder -----------------------------------------------------------------------
expect 0 "$small"
says out.txt "open it in ParaView: bonded_pair.out/elements.pvd"
nothing_in err.txt
for file in elements.pvd elements.vtu.series elements_000000.vtu history.csv summary.json scene.lua run.log; do
  there "bonded_pair.out/$file"
done
cmp -s "$small" bonded_pair.out/scene.lua || fail "scene.lua is not the scene"
says bonded_pair.out/summary.json '"state": "finished"'
says bonded_pair.out/run.log "open it in ParaView"
[[ -z $(find . -name '*.unfinished') ]] || fail "unfinished files are left"

rm -rf before && cp -r bonded_pair.out before
expect 2 "$small"
says err.txt "output folder = bonded_pair.out: holds another run; choose one with -o, or --overwrite"
diff -r before bonded_pair.out >/dev/null || fail "a refused run changed the folder"

echo keep >bonded_pair.out/notes.txt
touch bonded_pair.out/elements_999999.vtu
expect 0 "$small" --overwrite --quiet
nothing_in err.txt
there bonded_pair.out/notes.txt
none bonded_pair.out/elements_999999.vtu

echo x >file
expect 2 "$small" -o file
says err.txt "file is not a folder"
expect 2 "$small" -o file/below
says err.txt "file is not a folder"
if [[ $(id -u) != 0 ]]; then
  mkdir -p closed && chmod 500 closed
  expect 2 "$small" -o closed/run
  says err.txt "is not writable: Permission denied"
fi

# ---- a callback that fails: the run stops, what it wrote is whole ----------------------------------
sed -E 's/^sim:run/sim:every { 1e-9, function(now) if now.time > 0 then error("enough") end end }\nsim:run/' "$small" >failing.lua
expect 3 failing.lua
says err.txt "failing.lua:"
says err.txt "enough"
says failing.out/summary.json '"state": "failed"'
there failing.out/elements_000000.vtu

# ---- Ctrl-C: the last frame is written, the summary says so ----------------------------------------
for signal in INT TERM; do
  sed -E 's/^(local [a-z]+ = )?sim:run.*/\1sim:run { duration = 1e3 }/' "$small" >endless.lua
  "$demlua" endless.lua --overwrite >out.txt 2>err.txt &
  process=$!
  wait_for endless.out/elements.pvd
  sleep 0.3
  kill -"$signal" "$process"
  wait "$process"
  code=$?
  ((code == 130)) || { fail "SIG$signal: exit code $code"; cat out.txt err.txt; }
  says endless.out/summary.json '"state": "interrupted"'
  says endless.out/elements.pvd "</VTKFile>"
  rm -r endless.out
done

((failures == 0)) && echo "all as expected"
exit $((failures > 0))
