#include "core/recording/variables/mat_file.h"
#include "tests/closeness.h"
#include "tests/core/recording/demo_files.h"
#include "tests/test_registry.h"

namespace test_mat_reader {

using namespace vybeg;
using namespace vybeg::test;

namespace {

const char* const script = R"(
import scipy.io as sio
import h5py
column = lambda x: x.reshape(-1, 1)
counts = lambda x: np.round(1000 * x).astype('i2')
vectors = {'S_C': column(c), 'S_D': column(d), 'fs': fs}
sio.savemat('v4.mat', vectors, format='4')
sio.savemat('v5.mat', vectors)
sio.savemat('v7.mat', vectors, do_compression=True)
sio.savemat('rows.mat', {'C': c.reshape(1, -1), 'D': d.reshape(1, -1), 'dt': 1 / fs})
sio.savemat('columns.mat', {'x': np.stack([c, d], 1), 'Fs': fs}, do_compression=True)
sio.savemat('two_rows.mat', {'x': np.stack([c, d], 0), 'Fs': fs}, do_compression=True)
sio.savemat('v4_rows.mat', {'x': np.stack([c, d], 0), 'rate': fs}, format='4')
sio.savemat('struct.mat', {'run': {'C': c, 'D': d, 'fs': fs, 'note': 'decay'}})
sio.savemat('struct7.mat', {'run': {'C': c, 'D': d, 'fs': fs}}, do_compression=True)
sio.savemat('time.mat', {'t': column(np.arange(len(c)) / fs), 'C': column(c), 'D': column(d)})
sio.savemat('single.mat', {'C': c.astype('f4'), 'D': d.astype('f4'), 'sr': fs})
sio.savemat('int16.mat', {'C': counts(c), 'D': counts(d), 'sample_rate': fs}, do_compression=True)
sio.savemat('int16_v4.mat', {'C': column(counts(c)), 'D': column(counts(d)), 'fs': fs}, format='4')
others = {'temperature': np.full((3, 1), 21.5), 'who': 'Ivan', 'cells': np.array([c, 'x'], object),
          'flags': np.ones(len(c), bool), 'good': vectors}
sio.savemat('others.mat', {**others, 'C': c, 'D': d, 'fs': fs, 'noise': c[::-1]})
sio.savemat('complex.mat', {'z': c + 1j * d, 'fs': fs})
sio.savemat('cube.mat', {'x': np.zeros((100, 2, 3))})
sio.savemat('alone.mat', {'C': c, 'fs': fs})
sio.savemat('no_rate.mat', {'C': c, 'D': d})
times = np.arange(len(c)) / fs
sio.savemat('timed.mat', {'data': np.stack([times, c, d], 1), 'fs': fs})
sio.savemat('timed_alone.mat', {'data': np.stack([times, c, d], 1)})
for name, rate_d, late in (('together', fs, 0), ('two_rates', 2 * fs, 0), ('late', fs, 0.01)):
    sio.savemat(name + '_fs.mat', {'C': {'data': c, 'fs': fs}, 'D': {'data': d, 'fs': rate_d}})
    sio.savemat(name + '_t.mat', {'C': {'data': c, 't': times},
                                  'D': {'data': d, 't': times * fs / rate_d + late}})
types = ['i1', 'u1', 'i2', 'u2', 'i4', 'u4', 'i8', 'u8', 'f4', 'f8']
ramp = np.arange(100)
for packed in (False, True):
    sio.savemat('types%d.mat' % packed, do_compression=packed,
                mdict={k + n: (ramp + s).astype(n) for n in types for k, s in (('C', 0), ('D', 7))})
sio.savemat('long.mat', {'C': (np.arange(5000000) % 32749).astype('i2'),
                         'D': (np.arange(5000000) % 32719).astype('i2'), 'fs': fs}, do_compression=True)
import struct, zlib
def element(kind, data):
    return struct.pack('>II', kind, len(data)) + data + bytes(-len(data) % 8)
def matrix(name, x, rows):
    return element(14, element(6, struct.pack('>II', 6, 0)) + element(5, struct.pack('>ii', rows, 1)) +
                       element(1, name) + element(9, x.astype('>f8').tobytes()))
def deflated(x):
    return struct.pack('>II', 15, len(zlib.compress(x))) + zlib.compress(x)
for name, rows_c in (('big_endian', len(c)), ('misfit', len(c) + 1)):
    parts = [matrix(b'C', c, rows_c), matrix(b'D', d, len(d)), matrix(b'fs', np.array([fs]), 1)]
    head = b'MATLAB 5.0 MAT-file'.ljust(124) + b'\1\0MI'
    open(name + '.mat', 'wb').write(head + b''.join(parts))
    open(name + '7.mat', 'wb').write(head + b''.join(map(deflated, parts)))
def matlab73(name, write):
    with h5py.File(name, 'w', userblock_size=512) as f:
        write(f)
    with open(name, 'r+b') as f:
        f.write(b'MATLAB 7.3 MAT-file, Platform: GLNXA64'.ljust(116) + bytes(8) + b'\x00\x02IM')
def put(group, name, value, kind):
    group.create_dataset(name, data=value).attrs['MATLAB_class'] = np.bytes_(kind)
def v73(f):
    put(f, 'S_C', c.reshape(1, -1), 'double')
    put(f, 'S_D', d.reshape(1, -1), 'double')
    put(f, 'fs', np.array([[fs]]), 'double')
    put(f, 'text', np.frombuffer(('x' * len(c)).encode('utf-16le'), 'u2'), 'char')
    refs = f.create_group('#refs#')
    put(refs, 'a', c, 'double')
    put(refs, 'b', c, 'double')
matlab73('v73.mat', v73)
def struct73(f):
    run = f.create_group('run')
    run.attrs['MATLAB_class'] = np.bytes_('struct')
    run.create_dataset('C', data=c.reshape(1, -1), chunks=(1, 5000), compression='gzip')
    run.create_dataset('D', data=d.reshape(1, -1), chunks=(1, 5000), compression='gzip')
    put(run, 'fs', np.array([[fs]]), 'double')
matlab73('struct73.mat', struct73)
)";

}  // namespace

class TestMatReader : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        demo_ = demo_second();
        write_with_python(folder_, demo_, script);
    }

    void the_demonstration_decay_is_the_same_from_every_level_and_layout_data() {
        QTest::addColumn<QString>("format");
        QTest::addColumn<QStringList>("channels");
        QTest::addColumn<Rounding>("rounding");
        const auto add = [](const char* file, const QString& format, const QStringList& channels,
                            Rounding rounding = Rounding::none) {
            QTest::newRow(file) << format << channels << rounding;
        };
        const QStringList numbered{"1", "2"};
        add("v4.mat", "MAT 4, 64 bit float, 2 channels", {"S_C", "S_D"});
        add("v5.mat", "MAT 5, 64 bit float, 2 channels", {"S_C", "S_D"});
        add("v7.mat", "MAT 5, 64 bit float, 2 channels", {"S_C", "S_D"});
        add("rows.mat", "MAT 5, 64 bit float, 2 channels", {"C", "D"});
        add("columns.mat", "MAT 5, 64 bit float, 2 channels", numbered);
        add("two_rows.mat", "MAT 5, 64 bit float, 2 channels", numbered);
        add("v4_rows.mat", "MAT 4, 64 bit float, 2 channels", numbered);
        add("struct.mat", "MAT 5, 64 bit float, 2 channels", {"run.C", "run.D"});
        add("struct7.mat", "MAT 5, 64 bit float, 2 channels", {"run.C", "run.D"});
        add("time.mat", "MAT 5, 64 bit float, 2 channels", {"C", "D"});
        add("single.mat", "MAT 5, 32 bit float, 2 channels", {"C", "D"}, Rounding::to_float);
        add("int16.mat", "MAT 5, 16 bit integer, 2 channels", {"C", "D"}, Rounding::to_counts);
        // Level 4 knows only doubles, however few bytes they are stored in.
        add("int16_v4.mat", "MAT 4, 64 bit float, 2 channels", {"C", "D"}, Rounding::to_counts);
        add("others.mat", "MAT 5, 64 bit float, 5 channels",
            {"good.S_C", "good.S_D", "C", "D", "noise"});
        add("big_endian.mat", "MAT 5, 64 bit float, 2 channels", {"C", "D"});
        add("big_endian7.mat", "MAT 5, 64 bit float, 2 channels", {"C", "D"});
        add("v73.mat", "MAT 7.3, 64 bit float, 2 channels", {"S_C", "S_D"});
        add("struct73.mat", "MAT 7.3, 64 bit float, 2 channels", {"run.C", "run.D"});
    }

    void the_demonstration_decay_is_the_same_from_every_level_and_layout() {
        QFETCH(QString, format);
        QFETCH(QStringList, channels);
        QFETCH(Rounding, rounding);
        const Recording recording = opened(folder_.file(QTest::currentDataTag()));
        QCOMPARE(QString::fromStdString(english(recording.format)), format);
        QStringList names;
        for (const Channel& channel : recording.channels) {
            names << QString::fromStdString(channel.name);
        }
        QCOMPARE(names, channels);
        const bool by_time = QString(QTest::currentDataTag()) == "time.mat";
        QCOMPARE(recording.rate_from, by_time ? RateOrigin::time_column : RateOrigin::file);
        // 1/dt and the slope of the times are rounded; a rate that is written is not.
        VYBEG_CLOSE_RATIO(recording.rate_hz, 33333, 1e-12);
        const Samples read = read_all(recording);
        QCOMPARE(worst_difference(read, rounded(demo_, rounding)), 0.0);
        QVERIFY(recording.diagnostics.empty());
    }

    void every_number_type_is_read_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("type");
        for (const QString file : {"types0.mat", "types1.mat"}) {
            for (const QString type :
                 {"i1", "u1", "i2", "u2", "i4", "u4", "i8", "u8", "f4", "f8"}) {
                QTest::newRow(qPrintable(file + " " + type)) << file << type;
            }
        }
    }

    void every_number_type_is_read() {
        QFETCH(QString, file);
        QFETCH(QString, type);
        const OpenOptions options{
            .rate_hz = 1000, .variables = {"C" + type.toStdString(), "D" + type.toStdString()}};
        const Samples read = read_all(opened(folder_.file(file.toStdString()), options));
        QCOMPARE(read.c.size(), 100u);
        for (std::size_t i = 0; i < read.c.size(); ++i) {
            QCOMPARE(read.c[i], static_cast<double>(i));
            QCOMPARE(read.d[i], static_cast<double>(i + 7));
        }
    }

    void named_variables_are_the_ones_that_are_read() {
        OpenOptions options{.variables = {"noise", "good.S_D", "good.fs"}};
        const Samples read = read_all(opened(folder_.file("others.mat"), options));
        QCOMPARE(worst_difference(read.c, {demo_.c.rbegin(), demo_.c.rend()}), 0.0);
        QCOMPARE(worst_difference(read.d, demo_.d), 0.0);

        options.variables = {"run.C", "run.E"};
        const auto missing = open(folder_.file("struct.mat"), options);
        QVERIFY(!missing);
        QCOMPARE(missing.error().code, ErrorCode::variable_missing);
        QCOMPARE(missing.error().args, (std::vector<MessageArg>{"run.E", "run.C, run.D, run.fs"}));
    }

    void an_array_may_begin_with_its_times() {
        for (const char* file : {"timed.mat", "timed_alone.mat"}) {
            const Recording recording = opened(folder_.file(file));
            VYBEG_CLOSE_RATIO(recording.rate_hz, 33333, 1e-9);
            QCOMPARE(worst_difference(read_all(recording).c, demo_.c), 0.0);
            QCOMPARE(worst_difference(read_all(recording).d, demo_.d), 0.0);
            // Who chose by number has what was chosen.
            const OpenOptions chosen{.channel_c = 3, .channel_d = 2};
            const auto said = open(folder_.file(file), chosen);
            QVERIFY(said || said.error().code == ErrorCode::rate_unknown);
            QCOMPARE(said ? worst_difference(read_all(*said).c, demo_.d) : 0.0, 0.0);
        }
    }

    void structs_of_different_times_are_refused() {
        for (const char* file : {"together_fs.mat", "together_t.mat", "late_fs.mat"}) {
            VYBEG_CLOSE_RATIO(opened(folder_.file(file)).rate_hz,
                              opened(folder_.file("v5.mat")).rate_hz, 1e-9);
        }
        for (const char* file : {"two_rates_fs.mat", "two_rates_t.mat", "late_t.mat"}) {
            const auto refused = open(folder_.file(file));
            QVERIFY2(!refused, file);
            QCOMPARE(refused.error().code, ErrorCode::format_unsupported);
        }
    }

    void any_part_of_a_file_is_the_same_part_of_its_samples_data() {
        QTest::addColumn<QString>("file");
        for (const char* file : {"v4.mat", "v5.mat", "v7.mat", "two_rows.mat", "struct73.mat"}) {
            QTest::newRow(file) << file;
        }
    }

    void any_part_of_a_file_is_the_same_part_of_its_samples() {
        QFETCH(QString, file);
        const Recording recording = opened(folder_.file(file.toStdString()));
        QVERIFY(same_however_cut(*recording.source, 20000));
    }

    void blocks_of_a_long_compressed_variable_join_without_a_seam() {
        const Recording recording = opened(folder_.file("long.mat"));
        QCOMPARE(recording.frames(), 5000000);
        // Forward, back and across the places where an inflater's state is remembered.
        for (const std::int64_t first : {2097000, 4194200, 100, 2097151, 4999000}) {
            const Samples part = read(*recording.source, first, 1000);
            QCOMPARE(part.c.size(), 1000u);
            for (std::size_t i = 0; i < part.c.size(); ++i) {
                const std::int64_t frame = first + static_cast<std::int64_t>(i);
                QCOMPARE(part.c[i], static_cast<double>(frame % 32749));
                QCOMPARE(part.d[i], static_cast<double>(frame % 32719));
            }
        }
    }

    void a_file_that_is_replaced_is_read_as_it_was() {
        const auto path = folder_.write("replaced.mat", bytes_of(folder_.file("v7.mat")));
        const Recording recording = opened(path);
        std::filesystem::remove(path);
        folder_.write("replaced.mat", "other");
        QCOMPARE(read(*recording.source, 0, 10).c[9], demo_.c[9]);
    }

    void a_file_without_a_recording_is_refused_by_name() {
        const auto code_of = [&](const char* file) {
            const auto recording = open(folder_.file(file));
            return recording ? std::string("it opens") : code_name(recording.error().code);
        };
        QCOMPARE(code_of("complex.mat"), "format-unsupported");
        QCOMPARE(open(folder_.file("complex.mat")).error().args,
                 (std::vector<MessageArg>{"MAT 5", "complex numbers (z)"}));
        QCOMPARE(code_of("cube.mat"), "format-unsupported");
        QCOMPARE(open(folder_.file("cube.mat")).error().args,
                 (std::vector<MessageArg>{"MAT 5", "an array of 3 dimensions (x)"}));
        // One row more than there are numbers: the next variable's bytes are none.
        QCOMPARE(code_of("misfit.mat"), "format-damaged");
        QCOMPARE(code_of("misfit7.mat"), "format-damaged");
        QCOMPARE(code_of("alone.mat"), "too-few-channels");
        QCOMPARE(code_of("no_rate.mat"), "rate-unknown");
    }

    void a_file_of_level_4_is_known_by_a_header_that_is_possible() {
        const std::string bytes = bytes_of(folder_.file("v4.mat"));
        const auto size = static_cast<std::int64_t>(bytes.size());
        QVERIFY(is_mat4(bytes, size));
        const auto changed = [&](std::size_t at, char byte) {
            std::string copy = bytes;
            copy[at] = byte;
            return is_mat4(copy, size);
        };
        QVERIFY(!changed(0, 99));      // no such type
        QVERIFY(!changed(7, '\x80'));  // negative rows
        QVERIFY(!changed(12, 2));      // neither real nor complex
        QVERIFY(!changed(16, 0));      // a name without a letter
        QVERIFY(!changed(20, '1'));    // a name that begins with a digit
        QVERIFY(!is_mat4(bytes.substr(0, 19), size));
        QVERIFY(!is_mat4(std::string(100, '\0'), 100));
    }

private:
    Folder folder_;
    Samples demo_;
};

VYBEG_TEST(TestMatReader)

}  // namespace test_mat_reader

#include "test_mat_reader.moc"
