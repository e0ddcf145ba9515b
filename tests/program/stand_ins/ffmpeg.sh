#!/bin/sh
here=$PWD
cd "${0%/*}/.."
case "$*" in
    -version) echo "ffmpeg version $(sed -n 's/^ffmpeg //p' known) Copyright" && exit ;;
    *"-h filter"*) echo "Unknown filter" && exit ;;
esac
for last; do
    case $last in
        -|-[0-9]*) ;;
        -*) grep -qxe "$last" known || { echo "[error] Unrecognized option '${last#-}'." >&2 && exit 8; } ;;
    esac
done
echo "ffmpeg $@" >> calls.txt
size=$(cat second-size 2>/dev/null || echo 960x540)
trc=$(cat transfer 2>/dev/null || echo bt709)
case $last in
    -)  for frame in $(seq 60); do
            [ $frame -gt 40 ] && now=$size || now=960x540
            echo "[Parsed_showinfo_0 @ 0x1] [info] n: $frame pts: 1 fmt:yuv420p sar:1/1 s:$now i:P iskey:1" >&2
            echo "[Parsed_showinfo_0 @ 0x1] [info] color_range:tv color_trc:$trc" >&2
        done
        head -c $((60 * 960 * 540)) /dev/zero ;;
    *) for frame in $(seq $(echo "$@" | grep -o 'eq(n' | wc -l)); do cp photos/00.png "$here/$(printf "$last" $frame)"; done ;;
esac
