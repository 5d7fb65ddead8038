#!/usr/bin/env bash
# Every validation scene keeps to the tolerance it states, in its quick form.
exec python3 "$DEMLUA_SOURCE_DIR/tools/validate" --quick
