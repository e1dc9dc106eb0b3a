#!/usr/bin/env bash
# Installs a package of Vybeg into a bare Debian 12, runs what it brings as an ordinary user without a
# display, removes it and looks for what is left. Needs root, debootstrap, a network and 2 GB.
#
# Usage: packaging/check_package.sh PACKAGE.deb FOLDER
#   FOLDER  the bare Debian, made with debootstrap where it is missing; kept for the next time
set -euo pipefail

fail() {
    printf 'FAILED: %s\n' "$*" >&2
    exit 1
}

# Everything below runs inside; mounts end with it.
inside() {
    export DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8 PATH=/usr/sbin:/usr/bin:/sbin:/bin
    export HOME=/root
    mount -t proc proc /proc
    apt-get update --quiet=2
    # Their caches and triggers are looked at, too; they are on every desktop.
    apt-get install --yes --quiet=2 --no-install-recommends man-db shared-mime-info \
        desktop-file-utils bash-completion >/dev/null
    apt-get install --yes --quiet=2 --no-install-recommends /tmp/vybeg.deb >/dev/null
    dpkg --listfiles vybeg >/tmp/files
    apt-get purge --yes --quiet=2 vybeg >/dev/null
    all_files >/tmp/before # with the libraries that it needs, which stay

    dpkg --install /tmp/vybeg.deb >/dev/null
    rm -rf /tmp/work
    install -d -o nobody /tmp/work
    setpriv --reuid=nobody --regid=nogroup --clear-groups bash -euc "$(declare -f use fail); use"
    grep -q ':\*\.vybeg$' /usr/share/mime/globs2 || fail "the MIME type of sessions is unknown"
    grep -q 'vybeg-session.*vybeg' /usr/share/applications/mimeinfo.cache ||
        fail "sessions are not opened by the program"
    man --where vybeg vybeg-cli
    man vybeg | grep -q 'standing waves' || fail "man vybeg"
    LC_ALL=C.UTF-8 man -L ru vybeg-cli | grep -q 'базы данных' || fail "man -L ru vybeg-cli"
    [ -e /usr/share/doc/vybeg/help/ru/files.html ] || fail "the help pages"

    apt-get purge --yes --quiet=2 vybeg >/dev/null
    all_files >/tmp/after
    diff /tmp/before /tmp/after || fail "left behind or taken along by removing the package"
    local path
    while read -r path; do
        [ -d "$path" ] || [ ! -e "$path" ] || fail "still there: $path"
    done </tmp/files
    ! grep -q vybeg /usr/share/mime/globs2 || fail "the MIME types are still known"
    echo "PASSED: installed, used, removed without a trace"
}

# What an ordinary user does. TRACK, JSON and PDF are looked at for their beginning only.
use() {
    cd /tmp/work
    export HOME=/tmp/work
    unset DISPLAY WAYLAND_DISPLAY
    vybeg-cli --version
    vybeg-cli simulate --demo -o demo.wav
    vybeg-cli analyze demo.wav --quiet -o track.csv
    grep -q '^t_s,a_A,a_B' track.csv || fail "analyze wrote no track"
    vybeg-cli identify demo.wav --quiet -o result.json
    vybeg demo.wav --figure figure.pdf --windows 6,60
    [ "$(head -c 5 figure.pdf)" = %PDF- ] || fail "the figure is no PDF"
    # A damaged HDF5 file: that it is called damaged needs vybeg-reader, found and started.
    printf '\x89HDF\r\n\x1a\n%0500d' 0 >damaged.h5
    vybeg-cli info damaged.h5 2>message && fail "a damaged file was read"
    cat message
    ! grep -q 'cannot be started' message || fail "vybeg-reader was not found"
    bash -c '. /usr/share/bash-completion/completions/vybeg-cli
        COMP_WORDS=(vybeg-cli analyze --alg) COMP_CWORD=2
        _vybeg vybeg-cli; [ "${COMPREPLY[*]}" = --algorithm ]' || fail "completion"
}

# All files but logs, caches and the package manager's own notes.
all_files() {
    find / -xdev \( -path /proc -o -path /tmp -o -path /var/cache -o -path /var/log \
        -o -path /var/lib/apt -o -path /var/lib/dpkg \) -prune -o -print | sort
}

if [ "${1:-}" = --inside ]; then
    inside
    exit
fi
package=${1:?the package} folder=${2:?the folder of the bare Debian}
[ -e "$folder/usr/bin/dpkg" ] || debootstrap --variant=minbase bookworm "$folder"
install -D -m 644 "$package" "$folder/tmp/vybeg.deb"
install -m 755 "${BASH_SOURCE[0]}" "$folder/tmp/check_package.sh"
unshare --mount --pid --fork chroot "$folder" /tmp/check_package.sh --inside
