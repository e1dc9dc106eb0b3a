"""The recordings of tests/tools/golden: each format that the readers know, with faults and damage."""

import shutil
import struct
import wave
from pathlib import Path

import h5py
import numpy as np
import scipy.io

RATE = 8000
FRAMES = 2 * RATE

# Of tests/data/text: one of each way in which a table states its rate.
LAYOUTS = ["audacity.txt", "daq_date_and_time.csv", "excel_semicolon.csv", "excel_utf16.txt",
           "keysight_infiniivision_3000.csv", "labview_decimal_comma.lvm", "lcard_lgraph.txt",
           "picoscope_v_mv.csv", "rigol_ds1000z.csv", "tek_mso4.csv", "zetlab.txt"]


def decay(two_theta=0.4, seed=1, noise=1e-3, a_b=0.05, frames=FRAMES, f0=1000.0):
    """C and D of a wave of two modes, 10 mHz apart, about 1 kHz."""
    t = np.arange(frames) / RATE
    axis = 2 * 0.2
    cosine, sine = np.cos(two_theta - axis), np.sin(two_theta - axis)
    fast, slow = 2 * np.pi * (f0 + 0.005) * t, 2 * np.pi * (f0 - 0.005) * t
    p = np.exp(-t / 30) * (cosine * np.cos(fast) - a_b * sine * np.sin(fast))
    q = np.exp(-t / 30) * (sine * np.cos(slow) + a_b * cosine * np.sin(slow))
    random = np.random.RandomState(seed)  # its numbers are the same in every version of NumPy
    c = p * np.cos(axis) - q * np.sin(axis) + noise * random.standard_normal(frames)
    d = p * np.sin(axis) + q * np.cos(axis) + noise * random.standard_normal(frames)
    return c, d


def write_wav(path, c, d, width=2):
    """PCM of `width` bytes."""
    scale = 0.75 * 2 ** (8 * width - 1)
    counts = np.round(scale * np.stack([c, d], 1)).astype("<i4")
    raw = counts.reshape(-1, 1).view("u1")[:, :width].tobytes()
    with wave.open(str(path), "wb") as file:
        file.setnchannels(2)
        file.setsampwidth(width)
        file.setframerate(RATE)
        file.writeframes(raw)


def crc(data, bits, polynomial):
    value = 0
    for byte in data:
        value ^= byte << (bits - 8)
        for _ in range(8):
            value = (value << 1 ^ (polynomial if value >> (bits - 1) else 0)) & ((1 << bits) - 1)
    return value


def write_flac(path, c, d):
    """16 bits, stored as they are: blocks of 4096 frames with verbatim subframes."""
    block, frames = 4096, 2 * 4096
    counts = np.round(24000 * np.stack([c, d])).astype(">i2")[:, :frames]
    info = struct.pack(">HH", block, block) + bytes(6)
    info += (RATE << 44 | 1 << 41 | 15 << 36 | frames).to_bytes(8, "big") + bytes(16)
    data = b"fLaC" + bytes([0x80, 0, 0, len(info)]) + info
    for number in range(frames // block):
        # 4096 frames, rate and size of samples as in the stream's information, two channels.
        frame = bytes([0xFF, 0xF8, 0xC0, 0x10, number])
        frame += bytes([crc(frame, 8, 0x07)])
        for channel in counts[:, number * block:(number + 1) * block]:
            frame += b"\x02" + channel.tobytes()
        data += frame + crc(frame, 16, 0x8005).to_bytes(2, "big")
    path.write_bytes(data)


def write_aiff(path, c, d):
    samples = np.round(24000 * np.stack([c, d], 1)).astype(">i2").tobytes()
    exponent = RATE.bit_length() - 1
    rate = struct.pack(">HQ", 16383 + exponent, RATE << (63 - exponent))
    common = struct.pack(">hIh", 2, len(c), 16) + rate
    chunks = b"COMM" + struct.pack(">I", len(common)) + common
    chunks += b"SSND" + struct.pack(">III", len(samples) + 8, 0, 0) + samples
    path.write_bytes(b"FORM" + struct.pack(">I", 4 + len(chunks)) + b"AIFF" + chunks)


def write_au(path, c, d):
    samples = np.stack([c, d], 1).astype(">f4").tobytes()
    path.write_bytes(struct.pack(">4sIIIII", b".snd", 24, len(samples), 6, RATE, 2) + samples)


def uff_head(name, count, kind):
    lines = [name, "NONE", "01-MAR-20 12:34:56", "NONE", "NONE",
             f"{1:5}{0:10}{0:5}{0:10} {'NONE':10}{12:10}{-3:4} {'NONE':10}{0:10}{0:4}",
             f"{kind:10}{count:10}{1:10}{0:13.5E}{1 / RATE:13.5E}{0:13.5E}"]
    for code, label, unit in ((17, "Time", "s"), (0, "Voltage", "V"), (0, "NONE", "NONE"),
                              (0, "NONE", "NONE")):
        lines.append(f"{code:10}{0:5}{0:5}{0:5} {label:20} {unit:20}")
    return "\n".join(lines) + "\n"


def write_uff58(path, c, d):
    text = ""
    for name, values in (("C", c), ("D", d)):
        text += "    -1\n    58\n" + uff_head(name, len(values), 4)
        for row in range(0, len(values), 4):
            text += "".join(f"{value:20.12E}" for value in values[row:row + 4]) + "\n"
        text += "    -1\n"
    path.write_text(text)


def write_uff58b(path, c, d):
    data = b""
    for name, values in (("C", c), ("D", d)):
        raw = values.astype("<f8").tobytes()
        first = f"    58b{1:6}{2:6}{11:12}{len(raw):12}{0:6}{0:6}{0:12}{0:12}\n"
        data += b"    -1\n" + (first + uff_head(name, len(values), 4)).encode() + raw + b"    -1\n"
    path.write_bytes(data)


def write_tdms(path, c, d):
    def text(value):
        return struct.pack("<I", len(value)) + value.encode()

    metadata = struct.pack("<I", 2)
    for name in ("C", "D"):
        metadata += text(f"/'Run'/'{name}'") + struct.pack("<IIIQ", 20, 10, 1, len(c))
        metadata += struct.pack("<I", 2)
        metadata += text("wf_increment") + struct.pack("<Id", 10, 1 / RATE)
        metadata += text("unit_string") + struct.pack("<I", 0x20) + text("V")
    raw = c.astype("<f8").tobytes() + d.astype("<f8").tobytes()
    path.write_bytes(b"TDSm" + struct.pack("<IIQQ", 2 | 4 | 8, 4713, len(metadata) + len(raw),
                                           len(metadata)) + metadata + raw)


def write_table(path, columns, names=None, delimiter=",", comma=False, encoding="utf-8", digits=9):
    lines = [] if names is None else [delimiter.join(names)]
    lines += [delimiter.join(f"{value:.{digits}g}" for value in row) for row in zip(*columns)]
    text = "\n".join(lines) + "\n"
    path.write_bytes((text.replace(".", ",") if comma else text).encode(encoding))


def write_mat73(path, c, d):
    with h5py.File(path, "w", userblock_size=512) as file:
        for name, values in (("C", c), ("D", d), ("fs", np.array([float(RATE)]))):
            data = file.create_dataset(name, data=values.reshape(1, -1))
            data.attrs["MATLAB_class"] = np.bytes_("double")
    with open(path, "r+b") as file:
        file.write(b"MATLAB 7.3 MAT-file, made for a test".ljust(124) + b"\0\2IM")


def write_mat5(path, variables, **options):
    scipy.io.savemat(path, variables, **options)
    if options.get("format") != "4":
        with open(path, "r+b") as file:  # in place of the time of writing
            file.write(b"MATLAB 5.0 MAT-file, made for a test".ljust(116))


def write_hdf5(folder, c, d):
    with h5py.File(folder / "chunked.h5", "w") as file:
        for name, values in (("C", c), ("D", d)):
            data = file.create_dataset("run/" + name, data=values, chunks=(1000,),
                                       compression="gzip", fletcher32=True)
            data.attrs["unit"] = "V"
        file["run"].attrs["fs"] = float(RATE)
    with h5py.File(folder / "records.h5", "w") as file:
        table = np.zeros(len(c), [("t", "f8"), ("C", "f8"), ("D", "f8")])
        table["t"], table["C"], table["D"] = np.arange(len(c)) / RATE, c, d
        file["run"] = table


def write_sound(folder):
    """One recording in each format."""
    c, d = decay()
    t = np.arange(FRAMES) / RATE
    both = np.stack([c, d], 1)
    for width in (2, 3):
        write_wav(folder / f"pcm{8 * width}.wav", c, d, width)
    scipy.io.wavfile.write(folder / "float32.wav", RATE, both.astype("f4"))
    scipy.io.wavfile.write(folder / "float64.wav", RATE, both)
    write_flac(folder / "verbatim.flac", c, d)
    write_aiff(folder / "pcm16.aiff", c, d)
    write_au(folder / "float32.au", c, d)
    np.save(folder / "columns.npy", both)
    np.save(folder / "rows_f4.npy", both.T.astype(">f4"))
    np.savez(folder / "plain.npz", C=c, D=d, fs=float(RATE))
    np.savez_compressed(folder / "time_packed.npz", t=t, run=both)
    variables = {"C": c, "D": d, "fs": float(RATE)}
    write_mat5(folder / "level4.mat", variables, format="4")
    write_mat5(folder / "level5.mat", variables)
    write_mat5(folder / "level5_packed.mat", variables, do_compression=True)
    write_mat73(folder / "level73.mat", c, d)
    write_hdf5(folder, c, d)
    write_uff58(folder / "text.uff", c, d)
    write_uff58b(folder / "binary.uff", c, d)
    write_tdms(folder / "waveform.tdms", c, d)
    np.round(20000 * both).astype("<i2").tofile(folder / "i16.raw")
    both.astype(">f8").tofile(folder / "f64be.bin")
    write_table(folder / "time.csv", (t, c, d), ("t_s", "C_V", "D_V"))
    write_table(folder / "comma.csv", (t, c, d), ("t;C;D",), ";", comma=True)
    write_table(folder / "milliseconds.txt", (1e3 * t, 1e3 * c, 1e3 * d),
                ("Time [ms]", "C [mV]", "D [mV]"), "\t")
    write_table(folder / "utf16.txt", (t, c, d), ("t", "C", "D"), "\t", encoding="utf-16")
    write_table(folder / "no_time.dat", (c, d), delimiter=" ")
    write_table(folder / "coarse_time.csv", (t, c, d), ("t_s", "C", "D"), digits=4)


def write_faults(folder):
    """Recordings whose check has findings, or without a decay."""
    c, d = decay()
    scipy.io.wavfile.write(folder / "clipped.wav", RATE, np.clip(np.stack([c, d], 1), -0.8, 0.8))
    lost = np.delete(np.stack([c, d], 1), np.s_[5000:5013], 0)
    scipy.io.wavfile.write(folder / "lost.wav", RATE, lost)
    t = np.arange(FRAMES) / RATE
    hum = 0.02 * np.sin(2 * np.pi * 50 * t) + 0.1
    scipy.io.wavfile.write(folder / "hum.wav", RATE, np.stack([c + hum, d + hum], 1))
    noise = np.random.RandomState(7).standard_normal((FRAMES, 2))
    scipy.io.wavfile.write(folder / "noise.wav", RATE, 1e-3 * noise)
    scipy.io.wavfile.write(folder / "zeros.wav", RATE, np.zeros((FRAMES, 2)))


def write_damaged(folder):
    """Files that are to be refused, or read as far as they go."""
    for name, length in (("float64.wav", 30), ("verbatim.flac", 60), ("columns.npy", 100),
                         ("plain.npz", 5000), ("level5.mat", 300), ("level73.mat", 3000),
                         ("chunked.h5", 3000), ("binary.uff", 3000), ("waveform.tdms", 100),
                         ("time.csv", 9)):
        (folder / f"cut_{name}").write_bytes((folder / name).read_bytes()[:length])
    (folder / "unclosed.wav").write_bytes(
        (folder / "pcm16.wav").read_bytes().replace(b"data" + struct.pack("<I", 4 * FRAMES),
                                                    b"data" + bytes(4)))
    (folder / "empty.csv").write_bytes(b"")
    (folder / "words.txt").write_text("no numbers\nat all\n" * 20)
    scipy.io.wavfile.write(folder / "one_channel.wav", RATE, decay()[0])
    both = np.stack(decay(), 1)
    both[100:110, 0] = np.nan
    np.save(folder / "nan.npy", both)
    (folder / "folder.wav").mkdir()


def write_sets(folder):
    """Four recordings of one resonator, and those of another."""
    for k in range(4):
        for name, seed, f0 in (("set", 10, 1000.0), ("other", 20, 1000.4)):
            c, d = decay(k * np.pi / 4, seed + k, f0=f0)
            scipy.io.wavfile.write(folder / f"{name}{k}.wav", RATE, np.stack([c, d], 1))
    rows = "".join(f"first,HRG-1,set{k}.wav,2026-03-0{k + 1},{20 + k}\n" for k in range(4))
    rows += "".join(f"second,HRG-2,other{k}.wav,2026-04-0{k + 1},{21 + k}\n" for k in range(4))
    rows += "lost,HRG-1,missing.wav,2026-05-01,20\nalone,HRG-1,set0.wav,2026-05-02,20\n"
    head = "set,gyro,file,date,temperature_c\n"
    (folder / "list.csv").write_text(head + rows)
    (folder / "bad_list.csv").write_text("set,gyro,window\nfirst,HRG-1,60\n")
    (folder / "bad_passport.json").write_text('{"format": "something else"}\n')
    (folder / "bad.vybeg").write_text('{"vybeg": ')


def write_all(folder, layouts):
    folder.mkdir(parents=True)
    write_sound(folder)
    write_faults(folder)
    write_damaged(folder)
    write_sets(folder)
    for name in LAYOUTS:
        shutil.copyfile(Path(layouts) / name, folder / name)
