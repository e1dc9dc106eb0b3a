#!/usr/bin/env bash
# The pictures of README and help, from the program: resources/pictures/make.sh VYBEG
# Needs ImageMagick (convert).
set -euo pipefail
program=$(realpath "${1:?usage: make.sh VYBEG}")
cd "$(dirname "${BASH_SOURCE[0]}")"
shots=$(mktemp -d)
trap 'rm -rf "$shots"' EXIT
QT_QPA_PLATFORM=offscreen "$program" --screenshots "$shots"

# picture FROM TO [CROP]
picture() {
    convert "$shots/$1" ${3:+-crop "$3" +repage} -strip +dither -colors 192 "PNG8:$2"
}

for page in tracks signals resonator windows; do
    shot=$page
    [ "$page" = signals ] && shot=periods
    picture "$shot-all-en-light-1280x720@1.png" "$page.png"
done
# The page alone, in a size that the help shows as it is.
for language in en ru; do
    folder=../help/$language/pictures
    mkdir -p "$folder"
    for page in tracks signals residuals resonator windows; do
        shot=$page
        [ "$page" = signals ] && shot=periods
        picture "$shot-all-$language-light-1280x720@1.png" "$folder/$page.png" 574x508+316+56
    done
done
