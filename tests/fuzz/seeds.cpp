#include "tests/fuzz/seeds.h"

#include "tests/core/recording/arrays/tdms_file.h"
#include "tests/core/recording/audio/audio_files.h"
#include "tests/core/recording/demo_files.h"
#include "tests/core/recording/text/uff_file.h"
#include "tests/data/trade_files.h"

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <iterator>
#include <map>

namespace vybeg::fuzz {
namespace {

using namespace vybeg::test;
using Files = std::vector<std::string>;

constexpr std::size_t frames = 40;

Files sound_audio(std::initializer_list<int> formats) {
    const Folder folder;
    Files files;
    for (const int format : formats) {
        write_audio(folder.file("run"), wave(frames), format, 33333, 2, "2020");
        files.push_back(bytes_of(folder.file("run")));
    }
    return files;
}

// Of plain samples.
Files wav_files() {
    Files files = sound_audio({SF_FORMAT_WAV | SF_FORMAT_PCM_16, SF_FORMAT_WAV | SF_FORMAT_DOUBLE,
                               SF_FORMAT_WAV | SF_FORMAT_PCM_U8,
                               SF_FORMAT_WAV | SF_ENDIAN_BIG | SF_FORMAT_PCM_24,
                               SF_FORMAT_WAVEX | SF_FORMAT_FLOAT, SF_FORMAT_RF64 | SF_FORMAT_PCM_32,
                               SF_FORMAT_W64 | SF_FORMAT_PCM_16});
    files.push_back(files.front());  // as its recorder leaves it that dies
    files.back().replace(files.back().find("data") + 4, 4, 4, '\0');
    return files;
}

Files audio_files() {
    Files files = wav_files();
    std::ranges::move(
        sound_audio({SF_FORMAT_WAV | SF_FORMAT_MS_ADPCM, SF_FORMAT_AIFF | SF_FORMAT_PCM_16,
                     SF_FORMAT_CAF | SF_FORMAT_PCM_24, SF_FORMAT_AU | SF_FORMAT_PCM_16,
                     SF_FORMAT_FLAC | SF_FORMAT_PCM_16}),
        std::back_inserter(files));
    return files;
}

// Rows of a time, C and D.
std::string table(
    const std::string& head, const std::string& delimiter, double step_s,
    const std::function<double(int)>& row_of = [](int i) { return i; }) {
    std::string text = head;
    for (int i = 0; i < static_cast<int>(frames); ++i) {
        const double t = step_s * row_of(i);
        text += (step_s > 0 ? std::to_string(t) + delimiter : "") +
                std::to_string(std::cos(0.9 * i)) + delimiter + std::to_string(std::sin(0.9 * i)) +
                "\n";
    }
    return text;
}

Files text_files() {
    std::string commas = table("t;C;D\n", ";", 1e-3);
    std::replace(commas.begin(), commas.end(), '.', ',');
    const std::string plain = table("t_s,C_V,D_V\n", ",", 3e-3);
    return {plain,
            commas,
            table("# rate 33333 Hz\n", "\t", 0),
            table("", " ", 1e-2),
            table("Run 5\nt [ms],C [mV],D [mV]\n", ",", 1e-2,
                  [](int i) { return i < 20 ? i : i + 300; }),
            table("time,C,D\n", ",", 1e-2, [](int i) { return i + 0.2 * std::sin(i); }),
            utf16(plain, false),
            utf16(table("", "\t", 1e-2), true),
            windows_1251(lgraph_text({.time_unit = "секунды", .time_step = 3e-5, .names = {}},
                                     {wave(frames).c, wave(frames).d})),
            "\"C\",\"D\"\r\n\"1\",\"2\"\r\n,3\r\nnan,4\r\n5,6\r\n7,8\r\n9,10\r\n11,12"};
}

Files uff_files() {
    const Samples samples = wave(frames);
    UffText wide;
    wide.doubles = true;
    wide.line_end = "\r\n";
    UffText tight;
    tight.blanks = false;
    Files files;
    for (const UffText& layout : {UffText{}, wide, tight}) {
        files.push_back(uff58(samples.c, layout) + uff58(samples.d, layout));
    }
    files.push_back("    -1\n   151\nmodel\n    -1\n" + files[0]);
    for (const bool doubles : {false, true}) {
        UffBytes bytes;
        bytes.big_endian = doubles;
        bytes.doubles = doubles;
        files.push_back(uff58b(samples.c, {}, bytes) + uff58b(samples.d, {}, bytes));
    }
    return files;
}

Files tdms_files() {
    Files files;
    for (const bool big_endian : {false, true}) {
        const Tdms t{big_endian};
        const std::uint32_t order = big_endian ? toc_interleaved : 0;
        const std::string raw(2 * 2 * 20, '\2');
        files.push_back(
            t.segment(first_segment | order, both_channels(t, tds_i16, 20), raw) +
            t.segment(toc_raw | order, "", raw) +
            t.segment(toc_raw | toc_metadata | order,
                      t.metadata({t.object(path_d, t.as_before(), {t.words("unit_string", "V")})}),
                      raw));
        files.push_back(small_file(whole_numbers(frames), t));
    }
    const Tdms t;
    files.push_back(t.segment(
        first_segment,
        t.metadata(
            {t.object("/'Run'", t.no_values(), {t.time("wf_start_time", 3600, 7)}),
             t.object(
                 path_c, t.values(tds_f32, 10),
                 {t.real("wf_increment", 1e-4), t.words("NI_Scaling_Status", "unscaled"),
                  t.whole("NI_Number_Of_Scales", 1), t.words("NI_Scale[0]_Scale_Type", "Linear"),
                  t.real("NI_Scale[0]_Linear_Slope", 2),
                  t.real("NI_Scale[0]_Linear_Y_Intercept", 1)}),
             t.object("/'Run'/'Note'", t.strings(2, 12)), t.object(path_d, t.values(tds_f32, 10))}),
        std::string(40 + 12 + 40, '\1') + std::string(40 + 12 + 40, '\2')));
    // DAQmx with a polynomial, channels of unequal length, a short last chunk.
    std::vector<std::string> scale{
        t.whole("NI_Number_Of_Scales", 2), t.words("NI_Scale[1]_Scale_Type", "Polynomial"),
        t.count("NI_Scale[1]_Polynomial_Input_Source", 0), t.real("wf_increment", 1e-4)};
    for (int i = 0; i < 4; ++i) {
        scale.push_back(
            t.real("NI_Scale[1]_Polynomial_Coefficients[" + std::to_string(i) + "]", 0.5 * i));
    }
    files.push_back(
        t.segment(first_segment | toc_daqmx,
                  t.metadata({t.object(path_c, t.daqmx(20, {t.scaler(3, 0)}, {4}), scale),
                              t.object(path_d, t.daqmx(20, {t.scaler(3, 2)}, {4}), scale)}),
                  std::string(2 * 80, '\1')) +
        t.segment(toc_raw | toc_daqmx, "", std::string(60, '\2')));
    files.push_back(t.segment(
        first_segment,
        t.metadata({t.object(path_c, t.values(tds_i16, 12), {t.real("wf_increment", 1e-4)}),
                    t.object(path_d, t.values(tds_f32, 10))}),
        std::string(64 + 32, '\1')));
    return files;
}

Files zetlab_files() {
    return {zetlab_anp(25000, 1.5e-6, "Пьезо C"), zetlab_xml(25000, 1.5e-6, "Пьезо &quot;C&quot;")};
}

Files raw_files() {
    Files files;
    for (int kind = 0; kind < 8; ++kind) {
        // The choice of try_raw(), which is skipped, then samples.
        std::string bytes(4, static_cast<char>(kind));
        bytes += store(std::int32_t{2 + kind % 3}, false) + store(std::int64_t{24}, false) +
                 store(0.5 * (kind + 1), false);
        for (const double sample : wave(2 * frames).c) {
            bytes += store(sample, false);
        }
        files.push_back(std::move(bytes));
    }
    return files;
}

// The files in the current folder that a script writes for Samples of a wave.
Files python_files(const QString& script, const QStringList& names) {
    const Folder folder;
    write_with_python(folder, wave(frames), script);
    Files files;
    for (const QString& name : names) {
        files.push_back(bytes_of(folder.file(name.toStdString())));
    }
    return files;
}

Files npy_files() {
    return python_files(R"(
both = np.stack([c, d], 1)
np.save('1', both)
np.save('2', np.asfortranarray(both).astype('>f4'))
np.save('3', (1000 * both.T).astype('i2'))
with open('4.npy', 'wb') as f:
    np.lib.format.write_array(f, both.astype('>i4'), version=(2, 0))
np.save('5', both.astype('f2'))
)",
                        {"1.npy", "2.npy", "3.npy", "4.npy", "5.npy"});
}

Files npz_files() {
    return python_files(R"(
t = np.arange(len(c)) / fs
np.savez('1', C=c, D=d, fs=fs)
np.savez_compressed('2', C=c, D=d, fs=fs)
np.savez_compressed('3', t=t, run=np.stack([c, d], 1))
np.savez('4', t=t + 0.2 / fs * np.sin(np.arange(len(c))), C=c, D=d)
)",
                        {"1.npz", "2.npz", "3.npz", "4.npz"});
}

Files mat_files() {
    return python_files(R"(
import scipy.io as sio
run = {'C': c, 'D': d, 'fs': fs, 's': {'x': np.arange(9.0)}, 'e': np.array(['a', 3.0], object)}
flat = {'C': c, 'D': d, 'fs': fs, 'x': np.arange(9, dtype='i2')}
sio.savemat('v4', flat, format='4')
sio.savemat('v5', run)
sio.savemat('v7', run, do_compression=True)
sio.savemat('legend', {'moku': {'data': np.stack([c, d], 1), 'fs': fs,
                                'legend': np.array(['A (V)', 'B (V)'], object)}})
)",
                        {"v4", "v5", "v7", "legend"});
}

Files mat73_files() {
    return python_files(R"(
import h5py
with h5py.File('v73', 'w', userblock_size=512) as f:
    for name, x in (('C', c), ('D', d), ('fs', np.array([[fs]]))):
        f.create_dataset(name, data=x.reshape(1, -1)).attrs['MATLAB_class'] = np.bytes_('double')
    f.create_group('run')['x'] = np.arange(9, dtype='u1')
with open('v73', 'r+b') as f:
    f.write(b'MATLAB 7.3 MAT-file, made for a test'.ljust(124) + b'\0\2IM')
)",
                        {"v73"});
}

Files hdf5_files() {
    return python_files(R"(
import h5py
with h5py.File('chunked', 'w') as f:
    for name, x in (('C', c), ('D', d)):
        f.create_dataset('run/' + name, data=x, chunks=(10,), compression='gzip',
                         fletcher32=True).attrs['unit'] = 'V'
    f['run'].attrs['fs'] = fs
with h5py.File('latest', 'w', libver='latest') as f:
    f['C'], f['D'], f['fs'] = c, d, fs
with h5py.File('records', 'w') as f:
    table = np.zeros(len(c), [('t', 'f8'), ('C', 'f8'), ('D', 'f8'), ('v', 'f4', (2,))])
    table['C'], table['D'] = c, d
    f.create_dataset('run', data=table, chunks=(10,), compression='gzip').attrs['fs'] = fs
    f['cube'], f['none'] = np.zeros((2, 2, 2)), h5py.Empty('f8')
import shutil
f = h5py.File('w', 'w', libver='latest')
f['C'], f['D'], f['fs'] = c, d, fs
f.flush()
shutil.copyfile('w', 'open')
f.close()
with h5py.File('deep', 'w') as f:
    group = f
    for i in range(20):
        group = group.create_group('g')
    group['C'], group['D'] = c, d
    group['back'] = f['g/g']
    group['soft'] = h5py.SoftLink('/g')
    group['far'] = h5py.ExternalLink('elsewhere', '/C')
)",
                        {"chunked", "latest", "deep", "records", "open"});
}

Files any_files() {
    Files files;
    for (const auto& of_format :
         {wav_files, text_files, npy_files, npz_files, uff_files, tdms_files, mat_files}) {
        std::ranges::move(of_format(), std::back_inserter(files));
    }
    return files;
}

// More groups in each other than any recording has: soundly written, and to be refused.
Files bottomless_files() {
    return python_files(R"(
import h5py
with h5py.File('deep', 'w') as f:
    group = f
    for i in range(3000):
        group = group.create_group('g')
    group['C'], group['D'] = c, d
)",
                        {"deep"});
}

}  // namespace

std::vector<std::string> sound_files(const std::string& format) {
    const std::map<std::string, Files (*)()> writers{
        {"wav", wav_files},     {"audio", audio_files},
        {"text", text_files},   {"npy", npy_files},
        {"npz", npz_files},     {"uff", uff_files},
        {"tdms", tdms_files},   {"zetlab", zetlab_files},
        {"raw", raw_files},     {"mat", mat_files},
        {"mat73", mat73_files}, {"hdf5", hdf5_files},
        {"any", any_files},     {"bottomless", bottomless_files}};
    return writers.at(format)();
}

}  // namespace vybeg::fuzz
