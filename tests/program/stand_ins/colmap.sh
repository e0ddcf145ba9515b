#!/bin/sh
case "$1 $2" in
    help*) echo "COLMAP $(sed -n 's/^colmap //p' known) -- Structure-from-Motion" && exit ;;
    *-h*) sed -n "s/^$1 \(.*\)/  \1 arg (=1)/p" known && exit ;;
esac
echo "$@" >> calls.txt
step=$1
while [ $# -gt 1 ]; do
    shift
    case $1 in
        --*) grep -qxe "$step $1" known || { echo "unrecognised option '$1'" >&2 && exit 1; } ;;
    esac
    case $1 in
        --image_path) images=$2 ;;
        --input_path) input=$2 ;;
        --output_path) output=$2 ;;
    esac
    shift
done
case $step in
    feature_extractor) [ ! -e broken ] || exit 1 ;;
    mapper) cp -r found-$(grep -c ^mapper calls.txt)/* "$output" ;;
    image_undistorter) cp -r "$images" "$output/images" && cp -r "$input" "$output/sparse" ;;
esac
