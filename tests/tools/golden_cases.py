"""The commands of tests/tools/golden. `@` stands for the folder of the recordings; each command runs in a
folder of its own, named after it."""

import re

import golden_recordings

# What the command line adds to a recording that does not say everything about itself.
OPTIONS = {
    "columns.npy": "--rate 8000",
    "rows_f4.npy": "--rate 8000",
    "nan.npy": "--rate 8000",
    "no_time.dat": "--rate 8000",
    "i16.raw": "--raw i16 --rate 8000",
    "f64be.bin": "--raw f64:be --rate 8000",
}

SOUND = ["pcm16.wav", "pcm24.wav", "float32.wav", "float64.wav", "verbatim.flac", "pcm16.aiff",
         "float32.au", "columns.npy", "rows_f4.npy", "plain.npz", "time_packed.npz", "level4.mat",
         "level5.mat", "level5_packed.mat", "level73.mat", "chunked.h5", "records.h5", "text.uff",
         "binary.uff", "waveform.tdms", "i16.raw", "f64be.bin", "time.csv", "comma.csv",
         "milliseconds.txt", "utf16.txt", "no_time.dat", "coarse_time.csv"]
FAULTS = ["clipped.wav", "lost.wav", "hum.wav", "noise.wav", "zeros.wav", "unclosed.wav", "nan.npy"]
DAMAGED = ["cut_float64.wav", "cut_verbatim.flac", "cut_columns.npy", "cut_plain.npz",
           "cut_level5.mat", "cut_level73.mat", "cut_chunked.h5", "cut_binary.uff",
           "cut_waveform.tdms", "cut_time.csv", "empty.csv", "words.txt", "one_channel.wav",
           "folder.wav", "missing.wav"]

SET = "@set0.wav @set1.wav @set2.wav @set3.wav"
OTHER = "@other0.wav @other1.wav @other2.wav @other3.wav"

ANALYZE = """
    @set0.wav -o track.csv --algorithm in-phase
    @set0.wav -o track.csv --algorithm phase-shift
    @set0.wav -o track.csv --algorithm moving-axes
    @set0.wav -o track.csv --algorithm demodulation
    @set0.wav -o track.csv --algorithm conjugate-gradient
    @set0.wav -o track.csv --algorithm maximum-likelihood
    @set0.wav -o track.csv --algorithm conjugate-gradient --start previous --initial 1,0.05,0.4,0,1000
    @set0.wav -o track.mat --window 200
    @set0.wav -o track.h5 --window 200
    @set0.wav -o track.npz --window 200
    @set0.wav -o - --window 400
    @set0.wav -o track.csv --periods 20.5
    @set0.wav -o track.csv --snap --window 203
    @set0.wav -o track.csv --hop 37
    @set0.wav -o track.csv --f0 1000
    @set0.wav -o track.csv --from 0.5 --to 1.25
    @set0.wav -o track.csv --band 900,1100
    @set0.wav -o track.csv --filter 800,1200
    @set0.wav -o track.csv --kappa 1.05 --offset 0.01,-0.02 --delay 1us --angle-zero 7
    @hum.wav -o track.csv --offset auto
    @lost.wav -o track.csv --repair-lost
    @set0.wav -o track.csv --channels 2,1 --threads 1
    @set0.wav -o track.csv --json-log
    @set0.wav -o track.csv --timing --quiet
    @set0.wav -o track.csv --start previous
    @time.csv -o track.csv --delimiter comma --decimal point --skip-lines 1 --time-column 1
    @milliseconds.txt -o track.csv --time-unit us --unit V --scale 3
    @time.csv -o track.csv --time-column none --rate 8000 --channels 2,3
    @level5.mat -o track.csv --variables D,C,fs
    @i16.raw -o track.csv --raw i16 --rate 8000 --skip 4 --scale 1e-4 --raw-channels 2
"""

IDENTIFY = f"""
    @set0.wav
    @set0.wav -o result.json
    {SET}
    {SET} -o result.json
    {SET} -o result.json --model structured
    {SET} -o result.json --model free
    {SET} -o result.json --model free --window 400
    {SET} -o result.json --tolerance skew=0.1deg,delay=10ns,kappa=0.02
    {SET} -o result.json --from 0.2 --filter 800,1200
    {SET} --quiet --timing -o -
    @set0.wav @set0.wav
    @set0.wav @other1.wav
    @noise.wav
    --list @list.csv --set first -o result.json
    --list @list.csv
    --list @list.csv --set lost
    --list @bad_list.csv
"""

SIMULATE = """
    --demo --seconds 0.2 -o run.wav --truth truth.csv
    --demo --seconds 0.2 -o run.csv
    --demo --seconds 0.2 -o run.npy --truth truth.npz
    --demo --seconds 0.2 -o run.mat --bits 16 --truth truth.mat
    --seconds 0.05 --noise 0.01 --seed 3 --hum 0.1,50,1 --lose 100:5 --skew 1 --crosstalk 0.01 -o -
    --seconds 0.05 --window 5 --full-scale 2 -o run.wav
    --seconds 0.05 -o run.ogg
    --seconds -1 -o run.wav
"""

WRONG = """
    vybeg-cli
    vybeg-cli unknown
    vybeg-cli analyze @set0.wav
    vybeg-cli analyze @set0.wav -o track.xyz
    vybeg-cli analyze @set0.wav -o track.csv --window 60 --window 60
    vybeg-cli analyze @set0.wav -o track.csv --window 60 --periods 7
    vybeg-cli analyze @set0.wav -o track.csv --window 3
    vybeg-cli analyze @set0.wav -o track.csv --f0
    vybeg-cli analyze @set0.wav -o track.csv --f0 3990000
    vybeg-cli analyze @set0.wav -o track.csv --from 3
    vybeg-cli analyze @set0.wav -o track.csv --channels 1,3
    vybeg-cli analyze @set0.wav -o track.csv --algorithm best
    vybeg-cli analyze @set0.wav -o track.csv --unknown
    vybeg-cli analyze @set0.wav -o missing/track.csv
    vybeg-cli analyze @set0.wav -o @set0.wav
    vybeg-cli analyze @time.csv -o @time.csv
    vybeg-cli analyze @set0.wav -o track.csv --rate 44100
    vybeg-cli identify
    vybeg-cli identify @set0.wav --tolerance skew=1,skew=2
    vybeg-cli identify @set0.wav --list @list.csv
    vybeg-cli compare @bad_passport.json @set0.wav
    vybeg-cli compare @missing.json @set0.wav
    vybeg-cli batch @bad_list.csv -o results.csv
    vybeg-cli batch @missing.csv -o results.csv
    vybeg --windows 6,60
    vybeg @set0.wav --figure figure.xyz
    vybeg @set0.wav --figure figure.svg --windows 3
    vybeg @missing.wav --figure figure.svg
    vybeg @noise.wav --report report.pdf
    vybeg @bad.vybeg --report report.pdf
    vybeg --report report.pdf
"""

DESKTOP = f"""
    @set0.wav --figure figure.svg
    @set0.wav --figure figure.svg --windows 60,200
    @set0.wav @set1.wav --figure figure.svg --algorithm in-phase
    @set0.wav --figure figure.pdf
    @set0.wav --figure figure.png
    @set0.wav --report report.pdf --gyro HRG-1 --operator Nobody
    {SET} --report report.pdf --tolerance skew=0.1deg
    --list @list.csv --set second --report report.pdf
    --list @list.csv --report report.pdf
"""


def lines(text):
    return [line.strip() for line in text.strip().splitlines()]


def name_of(command):
    """The folder of a command: its words."""
    return re.sub(r"[^A-Za-z0-9.]+", "_", command.replace("vybeg-", "")).strip("_")


def cases():
    """Pairs of a name and a command line; ` ; ` is between commands that follow each other."""
    commands = []
    for name in SOUND + FAULTS + DAMAGED + golden_recordings.LAYOUTS:
        file = f"@{name} {OPTIONS.get(name, '')}".strip()
        commands += [f"vybeg-cli info {file}", f"vybeg-cli info --json {file}",
                  f"vybeg-cli analyze {file} -o track.csv"]
    commands += ["vybeg-cli analyze " + line for line in lines(ANALYZE)]
    commands += ["vybeg-cli identify " + line for line in lines(IDENTIFY)]
    commands += ["vybeg-cli simulate " + line for line in lines(SIMULATE)]
    commands += lines(WRONG)
    commands += [f"vybeg-cli {command} --help".replace("  ", " ")
              for command in ("", "info", "analyze", "identify", "compare", "batch", "simulate")]
    commands += ["vybeg-cli --version", "vybeg --version", "vybeg --help"]
    commands += ["vybeg " + line for line in lines(DESKTOP)]
    commands += [f"LC_ALL=ru_RU.UTF-8 vybeg {line}" for line in lines(DESKTOP)[:1] + lines(DESKTOP)[6:7]]
    identified = f"vybeg-cli identify {SET} -o result.json --passport HRG-1.json"
    commands += [f"{identified} ; vybeg-cli compare HRG-1.json {arguments}" for arguments in
              (SET, OTHER, f"{OTHER} -o compared.json --f-limit 1",
               "@set0.wav -o compared.json --model free")]
    batch = "vybeg-cli batch @list.csv -o results.csv"
    commands += [f"{batch} --json json --database results.db",
              f"{batch} --only first ; {batch} --resume",
              f"{batch} --only second --model free",
              f"{identified} ; {batch} --passport . --jobs 2",
              f"vybeg-pictures --session . {SET} ; vybeg session.vybeg --report report.pdf"]
    names = [name_of(command) for command in commands]
    assert len(set(names)) == len(names), "two commands have the same words"
    return list(zip(names, commands))
