#!/bin/sh
has() { case " $words " in *" $1 "*) true ;; *) false ;; esac; }
words="$*"
case "$1" in
  train)
    # a page shows several ways to begin a run of one name
    begun=$(printf '%s' "$words" | sed -n 's/.* -o \([^ ]*\).*/\1/p')
    [ -z "$begun" ] || rm -rf "$begun"
    # more steps than before, but few: also in the place of the minutes that choose their number
    steps=$(($(cat .steps 2>/dev/null || echo 2) + 1))
    echo "$steps" > .steps
    set -- $(echo "$words" | sed "s/--minutes [0-9.]*/--steps $steps/; s/--steps [0-9]*/--steps $steps/; \
        s/--time-limit [0-9]*/--time-limit 1/")
    if ! has --resume && ! has --print-config; then
      for setting in run.steps=2 run.tiles_per_step=2 run.tile_size=16 run.tiles_per_view=1 \
          data.built_in_views=2 data.built_in_side=16 start.gaussians=100 densification.max_gaussians=200; do
        set -- "$@" --set "$setting"
      done
      # the built-in scene takes longer than the run
      case "$2" in
        -*) [ ! -d photographs ] || has --config || set -- "$@" --set data.path=photographs ;;
      esac
    fi ;;
  demo) set -- "$@" --views 2 --size 32 ;;
  film) set -- "$@" --frames 2 ;;
  export-web) has --size || set -- "$@" --size 64x48 ;;
  export | import) set -- "$@" --steps 1 --side 16 ;;
esac
case "$1" in
  train | demo | eval | render | film | tiles | export-web | export | import | edit) has --backend || has --print-config || set -- "$@" --backend cpu ;;
esac
exec "$PROGRAM" "$@"
