#!/usr/bin/env bash
# The pictures of README and help, from the program vybeg-pictures:
# resources/pictures/make.sh build/release/bin/vybeg-pictures
# Needs ImageMagick (convert).
set -euo pipefail
program=$(realpath "${1:?usage: make.sh VYBEG-PICTURES}")
cd "$(dirname "${BASH_SOURCE[0]}")"
shots=$(mktemp -d)
trap 'rm -rf "$shots"' EXIT
"$program" --size 1280x720 --pixel-ratio 1 "$shots"

# picture FROM TO [CROP]
picture() {
    convert "$shots/$1" ${3:+-crop "$3" +repage -resize "760x>"} -strip +dither -colors 192 "PNG8:$2"
}

picture "tracks-all-en-light-1280x720@1.png" tracks.png
picture "tracks-all-ru-light-1280x720@1.png" tracks.ru.png
# The window without its row of menus, no wider than the help shows it.
for language in en ru; do
    folder=../help/$language/pictures
    mkdir -p "$folder"
    for page in tracks signals residuals resonator windows; do
        shot=$page
        [ "$page" = signals ] && shot=periods
        part=1280x662+0+31
        # The picture of the tracks shows settings and ledger; the others show their page alone.
        aside=$([ "$language" = ru ] && echo 238 || echo 216)
        [ "$page" != tracks ] && part=$((1280 - aside))x560+$aside+31
        [ "$page" = resonator ] && part=1280x689+0+31  # it owns the row of the status, too
        picture "$shot-all-$language-light-1280x720@1.png" "$folder/$page.png" "$part"
    done
done
