#!/usr/bin/env bash
# Builds, tests and shows Vybeg on Debian 12, from a fresh clone. See usage().
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

# What the program needs from Debian, and why.
packages=(
    build-essential cmake ninja-build ccache pkg-config # compile
    qt6-base-dev libqt6opengl6-dev qt6-svg-dev qt6-charts-dev libqcustomplot-dev # window, plots
    qt6-tools-dev qt6-tools-dev-tools qt6-l10n-tools qt6-translations-l10n # Russian
    libeigen3-dev libtbb-dev libfftw3-dev   # numerics
    libsndfile1-dev libhdf5-dev libssl-dev libfast-float-dev nlohmann-json3-dev # files
    zlib1g-dev                              # files that are packed
    libsqlite3-dev                          # database of results
    libqpdf-dev                             # outline of the report
    libcli11-dev                            # command line
    fonts-dejavu-core                       # text without a display
)
# What the tests and benchmarks need besides.
test_packages=(
    git                                     # which sources there are
    python3-numpy python3-scipy python3-h5py # write files for the tests of readers
    libmatio-dev                            # reads those of the program in a test
    poppler-utils                           # reads the report in a test
    libbenchmark-dev libceres-dev           # speed, and a peer to measure it by, tests/benchmarks
)
developer_packages=(clang-format clang-tidy)
# What looks over the files that are installed, in the test installation; without it, it says so.
installation_packages=(appstream desktop-file-utils mandoc shared-mime-info)
fuzz_packages=(clang-14 libclang-rt-14-dev)

demo_folder=build/demo
programs=build/release/bin

usage() {
    cat <<'TEXT'
Usage: ./build.sh COMMAND

  run           build, then open the program on a demonstration recording; without a display,
                write its track (CSV) and its figure (PDF) to build/demo instead
  test [FOLDER...]
                build, then run the tests without a display, all but the long ones (label `long`); with
                folders of tests/ (core/recording, core/recording/text, ui/plots) build and run those
                alone; last line "N passed, M failed"
  test-quick [FOLDER...]
                the same, without the statistical ones
  test-all      the same, the statistical and the long ones, too
  test-sanitized [FOLDER...]
                the same under AddressSanitizer and UndefinedBehaviorSanitizer, in build/asan,
                without the long and the statistical tests
  test-sanitized-files
                those of readers, writers and document alone, in build/asan-files, with the mathematics
                of build/release: a third of the time, for .ci/run
  test-threads  the tests that run several threads under ThreadSanitizer, in build/tsan
  tidy          clang-tidy over core/, a quarter of an hour (not part of .ci/run)
  fuzz FORMAT [SECONDS]
                feed the reader of a format (audio wav text npy npz uff tdms raw mat mat73 hdf5) with
                what libFuzzer makes of sound and damaged files, in build/fuzz; 60 s if not told
  build         build everything into build/release
  install [PREFIX]
                build, then install under PREFIX (/usr/local if not told); what was installed
                stands in build/release/install_manifest_program.txt
  package       build the Debian package, build/release/package/vybeg_*.deb
  install-deps  only install what is missing from Debian (--dev: also what .ci/run needs)

All of them install what is missing first. Built programs: build/release/bin.
TEXT
}

say() { printf '== %s\n' "$*"; }

fail() {
    printf 'build.sh: %s\n' "$*" >&2
    exit 1
}

# Runs a command as root: directly, or through sudo.
as_root() {
    if [ "$(id -u)" -eq 0 ]; then
        "$@"
    else
        sudo "$@"
    fi
}

is_installed() {
    [ "$(dpkg-query --show --showformat '${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

# Sets missing to those of the named packages that are not installed.
find_missing() {
    local package
    missing=()
    for package in "$@"; do
        is_installed "$package" || missing+=("$package")
    done
}

# Installs those of the named packages that are missing.
install_packages() {
    if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
        say "No apt here: going on with what is installed. On Debian 12 these would be needed: $*"
        return
    fi
    local missing
    find_missing "$@"
    if [ ${#missing[@]} -eq 0 ]; then
        return
    fi
    if [ "$(id -u)" -ne 0 ] && ! command -v sudo >/dev/null; then
        fail "these packages are missing, and installing them needs root or sudo. Run as root:
    apt-get update && apt-get install --no-install-recommends ${missing[*]}"
    fi
    # apt refuses everything while an installation that was cut off (a power cut, a stopped
    # container) waits to be finished; finishing it loses nothing.
    if [ -n "$(dpkg --audit 2>/dev/null)" ]; then
        say "An earlier installation was cut off; finishing it: dpkg --configure -a"
        as_root env DEBIAN_FRONTEND=noninteractive dpkg --configure -a ||
            as_root env DEBIAN_FRONTEND=noninteractive apt-get install --fix-broken --yes --quiet \
                --no-install-recommends ||
            fail "dpkg could not finish an earlier installation. The reason stands above."
        find_missing "$@"
        if [ ${#missing[@]} -eq 0 ]; then
            return
        fi
    fi
    say "Installing from Debian: ${missing[*]}"
    as_root apt-get update --quiet || fail "apt-get could not reach Debian's packages (see above)."
    as_root env DEBIAN_FRONTEND=noninteractive apt-get install --yes --quiet \
        --no-install-recommends "${missing[@]}" ||
        fail "apt-get could not install: ${missing[*]}. The reason stands above."
}

# configure PRESET [ARGUMENTS...]: the arguments go to cmake (-DBUILD_TESTING=OFF ...).
configure() {
    local preset=$1
    shift
    say "Configuring build/$preset"
    cmake --preset "$preset" "$@" >build/configure.log || {
        cat build/configure.log
        fail "cmake could not configure build/$preset. The reason stands above."
    }
}

# build PRESET [ARGUMENTS...]: builds what is configured; the arguments go to the build (--target ...).
build() {
    local preset=$1
    shift
    say "Building into build/$preset"
    cmake --build --preset "$preset" --parallel "$(nproc)" "$@"
}

# build_program [TARGET...]: what is installed, without what the tests need. A folder that is configured
# for tests stays so.
build_program() {
    say "From nothing on two cores: 2 minutes to install what is missing, 5 to build the program."
    install_packages "${packages[@]}"
    mkdir -p build
    if [ ! -e build/release/build.ninja ] || [ ! -e build/release/CMakeCache.txt ]; then
        configure release -DBUILD_TESTING=OFF
    fi
    build release --target "$@"
}

# configure_tests PRESET: with what the tests need.
configure_tests() {
    install_packages "${packages[@]}" "${test_packages[@]}"
    mkdir -p build
    configure "$1" -DBUILD_TESTING=ON
}

run_program() {
    build_program vybeg vybeg-cli
    mkdir -p "$demo_folder"
    local recording=$demo_folder/demo.wav
    say "Making the demonstration recording"
    "$programs/vybeg-cli" simulate --demo -o "$recording"
    if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
        say "Opening $PWD/$recording"
        exec "$programs/vybeg" "$recording"
    fi
    say "No display: analysing into files"
    "$programs/vybeg-cli" analyze "$recording" -o "$demo_folder/track.csv"
    QT_QPA_PLATFORM=offscreen "$programs/vybeg" "$recording" \
        --figure "$demo_folder/figure.pdf" --windows 6,60
    printf 'Recording: %s\nTrack:     %s\nFigure:    %s\n' \
        "$PWD/$recording" "$PWD/$demo_folder/track.csv" "$PWD/$demo_folder/figure.pdf"
}

# Prints the last line that scripts rely on and ends with the status it means.
conclude() {
    printf '%d passed, %d failed\n' "$1" "$2"
    exit $(($2 > 0))
}

# run_tests PRESET LABELS [FOLDER...]: builds and runs the tests in the folders, all without them, but
# those whose label fits the expression LABELS.
run_tests() {
    local preset=$1 without=$2 log=build/$1/ctest.log folder summary failed total
    local targets=() filter=()
    shift 2
    configure_tests "$preset"
    if [ $# -gt 0 ]; then
        for folder in "$@"; do
            if ! [[ $folder =~ ^[A-Za-z0-9_/]+$ ]] ||
                ! grep -q "^${folder%/}/" "build/$preset/test_programs.txt"; then
                fail "no tests in: $folder. Folders of tests/ are: $(cut -d' ' -f1 "build/$preset/test_programs.txt" |
                    xargs -n 1 dirname | sort -u | grep -v '^/' | xargs)"
            fi
            mapfile -t -O ${#targets[@]} targets < <(
                awk -v folder="${folder%/}/" 'index($1, folder) == 1 { print $2 }' \
                    "build/$preset/test_programs.txt" | sort -u)
        done
        filter=(--tests-regex "^($(IFS='|' && printf '%s' "${*%/}"))/")
        targets=(--target "${targets[@]}")
    fi
    if ! build "$preset" "${targets[@]}"; then
        say "The build failed: no test was run."
        conclude 0 1
    fi
    say "Testing"
    # A failing test shows in the summary; no summary at all is a failure, too. One test more than there are
    # processors: some wait for a program, a lock or a timer.
    ctest --preset "$preset" --parallel $(($(nproc) + 1)) ${without:+--label-exclude "$without"} \
        "${filter[@]}" 2>&1 | tee "$log" || true
    summary=$(sed -nE 's/^.*tests passed, ([0-9]+) tests failed out of ([0-9]+).*$/\1 \2/p' "$log")
    if [ -z "$summary" ]; then
        say "ctest gave no summary."
        conclude 0 1
    fi
    read -r failed total <<<"$summary"
    conclude $((total - failed)) "$failed"
}

# One source of core/ at a time, two at once; the headers are reached through them.
run_tidy() {
    install_packages "${developer_packages[@]}"
    configure_tests dev
    git ls-files -z 'core/*.cpp' |
        xargs -0 -n 1 -P 2 clang-tidy --quiet -p build/dev
}

# Of MAT 7.3 and HDF5 it is libhdf5 that falls, which vybeg-reader is there for.
run_fuzzer() {
    local format=$1 seconds=$2 corpus=build/fuzz/corpus-$1 options=
    case $format in
        # What vybeg-reader has for memory; and the libraries leave some of it behind.
        audio | mat73 | hdf5) options=detect_leaks=0:allocator_may_return_null=1:max_allocation_size_mb=64 ;;
    esac
    install_packages "${fuzz_packages[@]}"
    configure_tests fuzz
    build fuzz --target fuzz-reader fuzz-corpus
    build/fuzz/bin/fuzz-corpus "$format" "$corpus"
    VYBEG_FORMAT=$format ASAN_OPTIONS=$options build/fuzz/bin/fuzz-reader "$corpus" -max_total_time="$seconds" -timeout=5 \
        -artifact_prefix="build/fuzz/$format-"
}

# The existing folder that a path is in or will be in.
existing_folder() {
    local path=$1
    until [ -d "$path" ]; do
        path=$(dirname "$path")
    done
    printf '%s\n' "$path"
}

run_install() {
    local prefix=$1 run=() tool
    build_program vybeg vybeg-cli vybeg-reader man-vybeg man-vybeg-cli
    if [ ! -w "$(existing_folder "$prefix")" ]; then
        run=(as_root)
    fi
    "${run[@]}" cmake --install build/release --prefix "$prefix" --component program
    # What the desktop looks names and types of files up in; a package's installation does it, too.
    for tool in "update-mime-database share/mime" "update-desktop-database share/applications"; do
        if command -v "${tool% *}" >/dev/null; then
            "${run[@]}" "${tool% *}" "$prefix/${tool#* }"
        fi
    done
    say "Installed: $prefix/bin/vybeg and vybeg-cli"
}

make_package() {
    install_packages dpkg-dev file
    build_program vybeg vybeg-cli vybeg-reader man-vybeg man-vybeg-cli
    rm -rf build/release/package
    cpack --config build/release/CPackConfig.cmake
    ls build/release/package/*.deb
}

case "${1:-}" in
    run) run_program ;;
    test) run_tests release long "${@:2}" ;;
    test-quick) run_tests release 'statistical|long' "${@:2}" ;;
    test-all) run_tests release "" ;;
    test-sanitized) run_tests asan 'statistical|long' "${@:2}" ;;
    test-sanitized-files)
        configure_tests release
        build release --target unsanitized || conclude 0 1
        run_tests asan-files 'statistical|long' core/base core/recording core/output core/database fuzz ui/document
        ;;
    test-threads) run_tests tsan "" ;;
    build)
        configure_tests release
        build release
        ;;
    install) run_install "$(realpath -m "${2:-/usr/local}")" ;;
    package) make_package ;;
    tidy) run_tidy ;;
    fuzz) run_fuzzer "${2:?which format? See ./build.sh help}" "${3:-60}" ;;
    install-deps)
        install_packages "${packages[@]}"
        if [ "${2:-}" = --dev ]; then
            install_packages "${test_packages[@]}" "${developer_packages[@]}" "${installation_packages[@]}"
        fi
        say "Everything needed is installed."
        ;;
    -h | --help | help) usage ;;
    *)
        usage >&2
        exit 2
        ;;
esac
