#include "tests/closeness.h"
#include "tests/core/recording/demo_files.h"
#include "tests/test_registry.h"

namespace test_hdf5_reader {

using namespace vybeg;
using namespace vybeg::test;

namespace {

const char* const script = R"(
import h5py
counts = lambda x: np.round(1000 * x)
def save(name, write, **options):
    with h5py.File(name, 'w', **options) as f:
        write(f)
def plain(f):
    f['C'], f['D'], f['fs'] = c, d, fs
save('plain.h5', plain)
save('latest.h5', plain, libver='latest')
save('userblock.h5', plain, userblock_size=2048)
def groups(f):
    f.create_dataset('2024/run 7/C', data=c).attrs['unit'] = 'V'
    f.create_dataset('2024/run 7/D', data=d).attrs['Units'] = np.bytes_('V')
    f['2024/run 7'].attrs['sampling_rate'] = fs
    f['2024'].attrs['fs'] = 1.0
save('groups.h5', groups)
def chunked(f):
    f.create_dataset('x', data=np.stack([c, d], 1), chunks=(1000, 2), compression='gzip',
                     shuffle=True, fletcher32=True).attrs['wf_increment'] = 1 / fs
save('chunked.h5', chunked)
def rows(f):
    f.create_dataset('x', data=np.stack([c, d], 0), chunks=(1, 777), compression='gzip')
    f.attrs['sample_rate'] = np.array([33333], 'i4')
save('rows.h5', rows)
def typed(name, kind, value):
    def write(f):
        f.create_dataset('C', data=value(c).astype(kind))
        f.create_dataset('D', data=value(d).astype(kind))
        f.attrs['dt'] = 1 / fs
    save(name, write)
typed('big_endian.h5', '>f8', lambda x: x)
typed('float32.h5', '<f4', lambda x: x)
typed('float32_be.h5', '>f4', lambda x: x)
typed('int16.h5', '<i2', counts)
typed('int16_be.h5', '>i2', counts)
typed('int32_be.h5', '>i4', counts)
def timed(f):
    f['log/C'], f['log/D'], f['log/time'] = c, d, np.arange(len(c)) / fs
    f['log/time'].attrs['unit'] = 's'
save('time.h5', timed)
def counted(f):
    f['C'], f['D'] = c, d
    f.create_dataset('t', data=np.arange(len(c)) * 30).attrs['unit'] = 'us'
save('microseconds.h5', counted)
def gap(f):
    keep = np.r_[0:1000, 1010:len(c)]
    f['C'], f['D'], f['t'] = c[keep], d[keep], (np.arange(len(c)) / fs)[keep]
save('gap.h5', gap)
def several(f):
    f['a/C'], f['a/D'], f['a/fs'] = c, d, 10.0
    f['b/C'], f['b/D'], f['b/fs'] = d, c, fs
    f['short'] = c[:100]
    f['ok'] = np.ones(len(c), bool)
    f['names'] = 'text'
save('several.h5', several)
def alike(f):
    f['a/x'], f['b/x'], f['fs'] = np.stack([c, d], 1), np.stack([d, c], 1), fs
save('alike.h5', alike)
def rate_in_words(f):
    f['x'] = np.stack([c, d], 1)
    f['x'].attrs['fs'] = '33.333 kHz'
save('rate_in_words.h5', rate_in_words)
def ring(f):
    f['run/C'], f['run/D'], f['run/fs'] = c, d, fs
    f['run/back'] = f['/']
    f['run/again'] = f['run']
    f['run/soft'] = h5py.SoftLink('/run/C')
    f['run/nowhere'] = h5py.SoftLink('/none')
    f['run/elsewhere'] = h5py.ExternalLink('plain.h5', '/C')
save('ring.h5', ring)
def external(f):
    f.create_dataset('C', (len(c),), 'f8', external=[('c.f64', 0, h5py.h5f.UNLIMITED)])
    f.create_dataset('D', (len(c),), 'f8', external=[('d.f64', 0, h5py.h5f.UNLIMITED)])
save('external.h5', external)
def virtual(f):
    for name in 'CD':
        layout = h5py.VirtualLayout((len(c),), 'f8')
        layout[:] = h5py.VirtualSource('plain.h5', name, (len(c),))
        f.create_virtual_dataset(name, layout)
save('virtual.h5', virtual)
def deep(f):
    group = f
    for i in range(200):
        group = group.create_group('g')
    group['C'], group['D'] = c, d
save('deep.h5', deep)
def many(f):
    for i in range(10500):
        f['x%d' % i] = float(i)
save('many.h5', many)
def pieces(f):
    f.create_dataset('C', (5000,), 'f8', chunks=(20 << 20,), maxshape=(None,), compression='gzip')
    f['D'] = d
save('pieces.h5', pieces)
def one_piece(f):
    noise = np.random.default_rng(1).standard_normal((2250000, 2))
    np.save('one_piece.npy', noise)
    f.create_dataset('x', data=noise, chunks=noise.shape, compression='gzip', compression_opts=1)
    f.attrs['sample_rate'] = fs
save('one_piece.h5', one_piece)
def singles(f):
    t = np.arange(466667) / fs
    f['C'], f['D'] = np.resize(c, len(t)), np.resize(d, len(t))
    f['t'] = t.astype('f4')
save('singles.h5', singles)
def doubles(f):
    t = np.arange(466667) / fs
    f['C'], f['D'] = np.resize(c, len(t)), np.resize(d, len(t))
    f['t'] = t.astype('f4').astype('f8')
save('doubles.h5', doubles)
def ticks(f):
    f['C'], f['D'] = c, d
    f.create_dataset('t', data=np.round(np.arange(len(c)) / fs * 1e6).astype('i8')).attrs['unit'] = 'us'
save('ticks.h5', ticks)
def hollow(f):
    f.create_dataset('C', (2**40,), 'f8', chunks=(1000,))
    f.create_dataset('D', (2**40,), 'f8', chunks=(1000,))
save('hollow.h5', hollow)
save('empty.h5', lambda f: f.create_group('nothing'))
save('complex.h5', lambda f: f.create_dataset('z', data=c + 1j * d))
def cubes(f):
    f['cube'], f['hyper'] = np.zeros((100, 2, 3)), np.zeros((5, 5, 5, 5))
save('cubes.h5', cubes)
def hollows(f):
    plain(f)
    f['none'] = h5py.Empty('f8')
    f.create_dataset('zero', (0,), 'f8', maxshape=(None,), chunks=(10,))
    f.create_dataset('rows', (0, 2), 'f8', maxshape=(None, 2), chunks=(10, 2))
    f['cube'] = np.zeros((100, 2, 3))
    f['no_records'] = np.zeros(0, [('x', 'f8'), ('y', 'f8')])
save('hollows.h5', hollows)
def lzf(f):
    f.create_dataset('C', data=c, compression='lzf')
    f.create_dataset('D', data=d, compression='lzf', shuffle=True)
save('lzf.h5', lzf)
def records(*fields):
    table = np.zeros(len(c), [f[:2] if f[2].ndim == 1 else f[:2] + (f[2].shape[1:],)
                              for f in fields])
    for name, kind, x in fields:
        table[name] = x
    return table
def pytables(f):
    f['run/table'] = records(('time', '<f8', np.arange(len(c)) / fs),
                             ('C', '<f8', c), ('D', '<f8', d))
    f['run/_i_table/C/sorted'] = np.zeros((40000, 3))
save('pytables.h5', pytables)
def pandas(f):
    f['df/table'] = records(('index', 'i8', np.arange(len(c))), ('values_block_0', 'f8', np.stack([c, d], 1)))
    f['df/table'].attrs['fs'] = fs
save('pandas.h5', pandas)
def pandas_columns(f):
    f.create_dataset('df/table', chunks=(500,), compression='gzip', data=records(
        ('index', 'i8', np.arange(len(c))), ('name', 'S5', np.full(len(c), b'x')),
        ('C', '>f8', c), ('D', '<f8', d)))
    f['df'].attrs['fs'] = fs
save('pandas_columns.h5', pandas_columns)
def counted_records(f):
    f['run'] = records(('C', '<i2', counts(c)), ('D', '>i2', counts(d)))
    f['set'] = np.array([(fs, 1.5)], [('fs', 'f8'), ('gain', 'f4')])
save('counted_records.h5', counted_records)
import os, shutil
def abandoned(name, swmr):
    f = h5py.File('writing.h5', 'w', libver='latest')
    for key, x in (('C', c), ('D', d)):
        f.create_dataset(key, data=x, maxshape=(None,), chunks=(1000,))
    f.attrs['fs'] = fs
    if swmr:
        f.swmr_mode = True
    f.flush()
    shutil.copyfile('writing.h5', name)
    f.close()
abandoned('swmr.h5', True)
abandoned('never_closed.h5', False)
with open('latest.h5', 'rb') as f:
    whole = f.read()
with open('cut.h5', 'wb') as f:
    f.write(whole[:-1000])
def missing(f):
    f['C'], f['D'], f['fs'] = np.where(np.arange(len(c)) == 5, np.inf, c), d, fs
save('missing.h5', missing)
def units(other, per_volt):
    def write(f):
        f.create_dataset('C', data=c).attrs['unit'] = 'V'
        f.create_dataset('D', data=per_volt * d).attrs['UNIT'] = other
        f['fs'] = fs / 1000
        f['fs'].attrs['units'] = 'kHz'
    return write
save('millivolts.h5', units('mV', 1000))
save('accelerations.h5', units('m/s^2', 1))
def step_in_ms(f):
    f['C'], f['D'], f['dt'] = c, d, 1000 / fs
    f['dt'].attrs['units'] = 'ms'
save('step_in_ms.h5', step_in_ms)
def rate_in_khz(f):
    f['C'], f['D'] = c, d
    f.attrs['sampling_rate'], f.attrs['sampling_rate_unit'] = fs / 1000, 'kHz'
save('rate_in_khz.h5', rate_in_khz)
def two_rates(f):
    for name, x, rate in (('C', c, fs), ('D', d, 33000.0)):
        f.create_dataset(name, data=x).attrs['fs'] = rate
save('two_rates.h5', two_rates)
def netcdf(f):
    f.create_dataset('C', data=counts(c).astype('i2')).attrs['scale_factor'] = 1e-3
    f.create_dataset('D', data=counts(d).astype('i2')).attrs['scale_factor'] = 2e-3
    f['fs'] = fs
save('netcdf.h5', netcdf)
)";

}  // namespace

class TestHdf5Reader : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        demo_ = demo_second();
        write_with_python(folder_, demo_, script);
    }

    void the_demonstration_decay_is_the_same_from_every_layout_data() {
        QTest::addColumn<QString>("format");
        QTest::addColumn<Rounding>("rounding");
        const auto add = [](const char* file, const QString& type,
                            Rounding rounding = Rounding::none) {
            QTest::newRow(file) << "HDF5, " + type + ", 2 channels" << rounding;
        };
        for (const char* file : {"plain.h5", "latest.h5", "userblock.h5", "groups.h5", "chunked.h5",
                                 "rows.h5", "big_endian.h5", "time.h5", "ring.h5", "hollows.h5",
                                 "pytables.h5", "pandas.h5", "pandas_columns.h5"}) {
            add(file, "64 bit float");
        }
        add("float32.h5", "32 bit float", Rounding::to_float);
        add("float32_be.h5", "32 bit float", Rounding::to_float);
        add("int16.h5", "16 bit integer", Rounding::to_counts);
        add("int16_be.h5", "16 bit integer", Rounding::to_counts);
        add("int32_be.h5", "32 bit integer", Rounding::to_counts);
        add("counted_records.h5", "16 bit integer", Rounding::to_counts);
    }

    void the_demonstration_decay_is_the_same_from_every_layout() {
        QFETCH(QString, format);
        QFETCH(Rounding, rounding);
        const Recording recording = opened(folder_.file(QTest::currentDataTag()));
        QCOMPARE(QString::fromStdString(english(recording.format)), format);
        const QString file = QTest::currentDataTag();
        const bool by_time = file == "time.h5" || file == "pytables.h5";
        QCOMPARE(recording.rate_from, by_time ? RateOrigin::time_column : RateOrigin::file);
        VYBEG_CLOSE_RATIO(recording.rate_hz, 33333, 1e-12);  // 1/dt is rounded
        const Samples read = read_all(recording);
        QCOMPARE(worst_difference(read, rounded(demo_, rounding)), 0.0);
        QVERIFY(recording.diagnostics.empty());
    }

    void a_file_that_is_still_written_or_was_never_closed_says_so_data() {
        QTest::addColumn<QString>("file");
        QTest::newRow("another program writes it (SWMR)") << "swmr.h5";
        QTest::newRow("its writer died") << "never_closed.h5";
    }

    void a_file_that_is_still_written_or_was_never_closed_says_so() {
        QFETCH(QString, file);
        const std::string before = bytes_of(folder_.file(file.toStdString()));
        const Recording recording = opened(folder_.file(file.toStdString()));
        QCOMPARE(worst_difference(read_all(recording), demo_), 0.0);
        QCOMPARE(recording.diagnostics.size(), 1u);
        QVERIFY(recording.diagnostics[0].kind == DiagnosticKind::file_not_closed);
        QCOMPARE(recording.diagnostics[0].args, std::vector<MessageArg>{"33333"});
        QVERIFY(bytes_of(folder_.file(file.toStdString())) == before);
    }

    void fields_of_records_are_named_and_chosen() {
        const Recording recording = opened(folder_.file("pandas_columns.h5"));
        QCOMPARE(recording.channels,
                 (std::vector<Channel>{{"/df/table/C", ""}, {"/df/table/D", ""}}));
        QVERIFY(same_however_cut(*recording.source, 20000));
        OpenOptions options{.variables = {"/df/table/D", "df/table/C"}};
        QCOMPARE(worst_difference(read_all(opened(folder_.file("pandas_columns.h5"), options)).c,
                                  demo_.d),
                 0.0);
        options.variables = {"/df/table/values_block_0"};
        const Recording vectors = opened(folder_.file("pandas.h5"), options);
        QCOMPARE(worst_difference(read_all(vectors).d, demo_.d), 0.0);
        QVERIFY(same_however_cut(*vectors.source, 20000));
        QCOMPARE(opened(folder_.file("counted_records.h5")).rate_hz, 33333.0);  // of /set/fs
    }

    void units_are_those_of_the_attributes() {
        const Recording recording = opened(folder_.file("groups.h5"));
        QCOMPARE(recording.channels,
                 (std::vector<Channel>{{"/2024/run 7/C", "V"}, {"/2024/run 7/D", "V"}}));
        QCOMPARE(recording.rate_hz, 33333.0);  // of the group itself, before the one around it
        QVERIFY(recording.diagnostics.empty());
    }

    void d_comes_in_the_unit_of_c() {
        const Recording recording = opened(folder_.file("millivolts.h5"));
        VYBEG_CLOSE(recording.rate_hz, 33333, 1e-9);
        const Diagnostic* converted = find(recording, DiagnosticKind::unit_converted);
        QVERIFY(converted);
        QCOMPARE(converted->args, (std::vector<MessageArg>{"D", "mV", "V"}));
        const Samples samples = read_all(recording);
        for (std::size_t i = 0; i < demo_.d.size(); ++i) {
            VYBEG_WITHIN(samples.d[i], demo_.d[i], 1e-15);
        }
        QCOMPARE(samples.c, demo_.c);
        QVERIFY(find(opened(folder_.file("accelerations.h5")), DiagnosticKind::units_differ));
    }

    void a_rate_may_have_a_unit_data() {
        QTest::addColumn<QString>("file");
        QTest::newRow("a step in ms") << "step_in_ms.h5";
        QTest::newRow("a rate in kHz") << "rate_in_khz.h5";
        QTest::newRow("a rate as a text") << "rate_in_words.h5";
    }

    void a_rate_may_have_a_unit() {
        QFETCH(QString, file);
        const Recording recording = opened(folder_.file(file.toStdString()));
        VYBEG_CLOSE(recording.rate_hz, 33333, 1e-8);
    }

    void times_that_count_in_another_unit_are_converted() {
        const Recording recording = opened(folder_.file("microseconds.h5"));
        QCOMPARE(recording.rate_from, RateOrigin::time_column);
        VYBEG_CLOSE(recording.rate_hz, 1e6 / 30, 1e-6);
    }

    void a_gap_in_the_times_is_a_gap_in_the_recording() {
        const Recording recording = opened(folder_.file("gap.h5"));
        QCOMPARE(recording.frames(), 33333);
        const Samples read = read_all(recording);
        QCOMPARE(missing_ranges(read.c), QString("1000-1010"));
        QCOMPARE(read.c[1010], demo_.c[1010]);
        QCOMPARE(read.d[33332], demo_.d[33332]);
        QVERIFY(find(recording, DiagnosticKind::time_gap));
    }

    void named_datasets_are_the_ones_that_are_read() {
        OpenOptions options;
        options.variables = {"/b/C", "b/D"};  // the first stroke may be left out
        const Recording recording = opened(folder_.file("several.h5"), options);
        QCOMPARE(recording.rate_hz, 33333.0);  // of the same group, not the first of the file
        QCOMPARE(worst_difference(read_all(recording).c, demo_.d), 0.0);
        QCOMPARE(worst_difference(read_all(recording).d, demo_.c), 0.0);

        options.variables = {"/b/C", "short"};
        const auto unequal = open(folder_.file("several.h5"), options);
        QVERIFY(!unequal);
        QCOMPARE(unequal.error().code, ErrorCode::setting_invalid);
        QCOMPARE(unequal.error().args,
                 (std::vector<MessageArg>{"--variables", "/b/C,short",
                                          "they have 33333 and 100 samples"}));
    }

    void arrays_of_one_size_are_chosen_from() {
        const auto refused = open(folder_.file("alike.h5"));
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::variables_ambiguous);
        QCOMPARE(refused.error().args, std::vector<MessageArg>{"/a/x, /b/x"});
        const Recording chosen = opened(folder_.file("alike.h5"), {.variables = {"b/x"}});
        QCOMPARE(worst_difference(read_all(chosen).c, demo_.d), 0.0);
    }

    void other_channels_are_chosen_by_number() {
        OpenOptions options{.channel_c = 3, .channel_d = 2};
        const Recording recording = opened(folder_.file("several.h5"), options);
        QCOMPARE(recording.channels.size(), 4u);
        QCOMPARE(recording.channels[2].name, "/b/C");
        QCOMPARE(worst_difference(read_all(recording).c, demo_.d), 0.0);
        options.channel_d = 5;
        QCOMPARE(open(folder_.file("several.h5"), options).error().code,
                 ErrorCode::channel_out_of_range);
    }

    void any_part_of_a_file_is_the_same_part_of_its_samples_data() {
        QTest::addColumn<QString>("file");
        for (const char* file : {"plain.h5", "chunked.h5", "rows.h5", "float32_be.h5"}) {
            QTest::newRow(file) << file;
        }
    }

    void any_part_of_a_file_is_the_same_part_of_its_samples() {
        QFETCH(QString, file);
        const Recording recording = opened(folder_.file(file.toStdString()));
        QVERIFY(same_however_cut(*recording.source, 20000));
    }

    void times_that_were_rounded_are_even_data() {
        QTest::addColumn<double>("last_digit_s");
        QTest::newRow("singles.h5") << 1e-6;  // of 32 bits at 14 s
        QTest::newRow("doubles.h5") << 1e-6;  // of 32 bits, stored in 64
        QTest::newRow("ticks.h5") << 1e-6;    // whole microseconds
    }

    void times_that_were_rounded_are_even() {
        QFETCH(double, last_digit_s);
        const Recording recording = opened(folder_.file(QTest::currentDataTag()));
        QVERIFY(recording.diagnostics.empty());
        VYBEG_WITHIN(recording.rate_hz / 33333, 1, 2.001 * recording.rate_relative_sd + 1e-12);
        const double seconds = static_cast<double>(recording.frames()) / 33333;
        VYBEG_LESS(recording.rate_relative_sd, last_digit_s / seconds);
    }

    void a_dataset_in_one_packed_piece_is_read() {
        const Recording recording = opened(folder_.file("one_piece.h5"));
        const OpenOptions at_rate{.rate_hz = 33333};
        const Recording plain = opened(folder_.file("one_piece.npy"), at_rate);
        QVERIFY(read_all(recording) == read_all(plain));
    }

    void infinite_samples_are_missing() {
        QCOMPARE(missing_ranges(read_all(opened(folder_.file("missing.h5"))).c), QString("5-6"));
    }

    void what_cannot_be_read_is_refused_by_name_data() {
        QTest::addColumn<QString>("code");
        QTest::addColumn<QString>("reason");
        QTest::newRow("external.h5") << "format-unsupported"
                                     << "samples in other files (/C)";
        QTest::newRow("virtual.h5") << "format-unsupported"
                                    << "samples in other files (/C)";
        QTest::newRow("complex.h5") << "format-unsupported"
                                    << "complex numbers (/z)";
        QTest::newRow("deep.h5") << "format-limit"
                                 << "its groups lie more than 32 deep";
        QTest::newRow("many.h5") << "format-limit"
                                 << "it has more than 10000 objects";
        QTest::newRow("pieces.h5")
            << "format-unsupported"
            << "samples packed in pieces of 160 MiB (a limit of this program is "
               "128 MiB) (/C)";
        QTest::newRow("hollow.h5") << "format-damaged"
                                   << "/C promises more samples than the file can hold";
        QTest::newRow("cubes.h5") << "format-unsupported"
                                  << "an array of 3 dimensions (/cube)";
        QTest::newRow("lzf.h5") << "format-unsupported"
                                << "samples packed by the filter lzf, number 32000 (/C)";
        QTest::newRow("two_rates.h5")
            << "format-unsupported"
            << "two sample rates, 33333 and 33000 Hz (--variables C,D,RATE tells which holds)";
        QTest::newRow("netcdf.h5") << "format-unsupported"
                                   << "values for scale_factor and add_offset (/C)";
        QTest::newRow("cut.h5") << "format-damaged"
                                << "it is shorter than its header says: cut off, or never closed";
    }

    void what_cannot_be_read_is_refused_by_name() {
        QFETCH(QString, code);
        QFETCH(QString, reason);
        const auto recording = open(folder_.file(QTest::currentDataTag()));
        QVERIFY(!recording);
        QCOMPARE(QString::fromStdString(code_name(recording.error().code)), code);
        const std::vector<MessageArg>& args = recording.error().args;
        QCOMPARE(
            QString::fromStdString(english(args.at(code == "format-limit" ? 1 : args.size() - 1))),
            reason);
    }

    void a_file_without_numbers_holds_no_channel() {
        const auto recording = open(folder_.file("empty.h5"));
        QVERIFY(!recording);
        QCOMPARE(recording.error().code, ErrorCode::no_channels);
    }

private:
    Folder folder_;
    Samples demo_;
};

VYBEG_TEST(TestHdf5Reader)

}  // namespace test_hdf5_reader

#include "test_hdf5_reader.moc"
