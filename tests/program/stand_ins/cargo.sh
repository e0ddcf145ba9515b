#!/bin/sh
[ "$1" = run ] || { echo "cargo $1 is not for this test" >&2; exit 97; }
while [ "$1" != -- ]; do shift; done
shift
exec organza "$@"
