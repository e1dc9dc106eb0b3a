// Tracks in every format: read back by NumPy, h5py and SciPy they are those of the CSV, bit for
// bit.
#include "core/base/error.h"
#include "core/output/track_file.h"
#include "core/recording/open/open_recording.h"
#include "tests/closeness.h"
#include "tests/core/output/full_disk.h"
#include "tests/core/recording/python_script.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <cmath>
#include <limits>
#include <random>
#include <stop_token>

namespace test_track_file {

using namespace vybeg;
using namespace vybeg::test;

namespace {

// Reads NAME.csv and compares the others with it; every number by its bits.
const char* const comparison = R"(
import glob, h5py, scipy.io
lines = open('NAME.csv', encoding='utf-8', newline='\n').read().split('\n')[:-1]
header = [line[2:] for line in lines if line.startswith('# ')]
rows = [line.split(',') for line in lines[len(header):]]
names = rows.pop(0)
assert len(rows) == ROWS and len(names) == 14, (len(rows), names)
columns = {name: [row[i] for row in rows] for i, name in enumerate(names)}
numbers = {name: np.array([float(x) for x in columns[name]]) for name in names[:-1]}
def same(found, expected):
    assert found.dtype == np.dtype('<f8') and found.shape == expected.shape, found.dtype
    nan = np.isnan(expected)
    assert (np.isnan(found) == nan).all()
    assert (found.view('i8')[~nan] == expected.view('i8')[~nan]).all()
npz = np.load('NAME.npz')
assert npz.files == names + ['header'], npz.files
h5 = h5py.File('NAME.h5')
assert list(h5['/']) == names + ['header'], list(h5['/'])
mat = scipy.io.loadmat('NAME.mat')
assert [name for name in mat if name[0] != '_'] == names + ['header'], mat.keys()
assert h5.attrs['program'].decode() == header[0], h5.attrs['program']
units = {'t_s': b's', 'f_Hz': b'Hz', 'two_theta_A_rad': b'rad', 'sd_alpha_rad': b'rad'}
for name in names:
    assert h5[name].attrs.get('unit', b'') == units.get(name, h5[name].attrs.get('unit', b'')), name
assert 'unit' in h5['t_s'].attrs and 'unit' not in h5['a_A'].attrs and 'unit' not in h5['flag'].attrs
for name in names[:-1]:
    same(npz[name], numbers[name])
    same(h5[name][:], numbers[name])
    assert mat[name].shape == (ROWS, 1)
    same(mat[name][:, 0], numbers[name])
def cells(of):
    return [text[0] if text.size else '' for text in of.reshape(-1)]
for name, expected in [('flag', columns['flag']), ('header', header)]:
    assert npz[name].dtype.kind == 'U' and npz[name].tolist() == expected, name
    assert h5[name].dtype.kind == 'S' and h5[name].asstr()[:].tolist() == expected, name
    assert cells(mat[name]) == expected, name
)";

const std::vector<std::string> header{"vybeg-cli 1.2.3", "input: запись \xF0\x9F\x94\x94.wav",
                                      "a line\nbroken", ""};

Track random_track(std::size_t rows) {
    std::mt19937_64 engine(5);
    std::uniform_real_distribution<double> any(-1, 1);
    Track track(rows);
    for (std::size_t row = 0; row < rows; ++row) {
        track.time_s()[row] = 0.00018 * (static_cast<double>(row) + 0.5);
    }
    for (const SlowVariable variable : all_slow_variables) {
        std::ranges::generate(track.values(variable), [&] { return any(engine); });
        std::ranges::generate(track.sds(variable), [&] { return 1e-9 * any(engine); });
    }
    for (std::size_t row = 0; row < rows; row += 7) {
        track.values(SlowVariable::a_B)[row] = std::nan("");
        track.flags()[row] = Flag::no_quadrature | Flag::at_bound;
    }
    return track;
}

// 100 million windows, an hour at 33333 Hz with a window at nearly every sample.
class ManyRows final : public TrackColumns {
public:
    std::size_t rows() const override { return 100'000'000; }
    Status numbers(std::size_t, const NumberSink&) const override { return {}; }
    Status flags(const FlagSink& sink) const override {
        const std::vector<Flags> piece(1'000'000);
        Status taken;
        for (int k = 0; k < 100 && taken; ++k) {
            taken = sink(piece);
        }
        return taken;
    }
    Status whole_rows(std::size_t, const TrackSink&) const override { return {}; }
};

}  // namespace

class TestTrackFile : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    std::filesystem::path path(const QString& name) const {
        return folder_.filePath(name).toStdString();
    }

    void write(const Track& track, const QString& name) {
        for (const char* ending : {".csv", ".npz", ".h5", ".mat"}) {
            const auto target = path(name + ending);
            auto file = OutputFile::create(target, {});
            QVERIFY(file);
            QVERIFY(write_track(*file, *track_format(target), track, header, {}));
            QVERIFY(file->commit());
        }
    }

    void compare(const QString& name, std::size_t rows) {
        run_python(
            folder_.path().toStdString(),
            QString(comparison).replace("NAME", name).replace("ROWS", QString::number(rows)));
    }

    QByteArray content(const QString& name) const {
        QFile file(folder_.filePath(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("(cannot be opened)");
    }

private slots:
    void the_ending_decides() {
        QCOMPARE(*track_format("a.csv"), TrackFormat::csv);
        QCOMPARE(*track_format("/x.npz/a.MAT"), TrackFormat::mat);
        QCOMPARE(*track_format("a.csv.h5"), TrackFormat::hdf5);
        QCOMPARE(*track_format("a.Hdf5"), TrackFormat::hdf5);
        QCOMPARE(*track_format("запись.npz"), TrackFormat::npz);
        for (const char* other : {"a", "a.txt", "npz", "/dev/null"}) {
            QCOMPARE(*track_format(other), TrackFormat::csv);
        }
        for (const char* other : {"a.npz.gz", "a.xlsx", "a.json"}) {
            QCOMPARE(track_format(other).error().code, ErrorCode::output_format_unknown);
        }
        QCOMPARE(track_format("a.npy").error().code, ErrorCode::output_failed);
    }

    void a_track_is_read_back_with_its_columns_in_their_order_data() {
        QTest::addColumn<bool>("flagged");
        for (const char* name : {"a.csv", "a.npz", "a.h5", "a.mat"}) {
            QTest::addRow("%s without flags", name) << false;
            QTest::addRow("%s with flags", name) << true;
        }
    }

    void a_track_is_read_back_with_its_columns_in_their_order() {
        QFETCH(bool, flagged);
        const QTemporaryDir folder;
        const QString name = QString(QTest::currentDataTag()).section(' ', 0, 0);
        const std::string target = folder.filePath(name).toStdString();
        Track track = random_track(50);
        std::ranges::fill(track.flags(), Flags{});
        if (flagged) {
            track.flags()[3] = static_cast<Flags>(1);
        }
        auto file = OutputFile::create(target, {});
        QVERIFY(file && write_track(*file, *track_format(target), track, header, {}));
        QVERIFY(file->commit());
        const auto read = open_recording(target, {}, {});
        QVERIFY2(read, read ? "" : english(read.error()).c_str());
        QCOMPARE(read->channels.size(), track_number_columns - 1);
        for (std::size_t k = 1; k < track_number_columns; ++k) {
            QCOMPARE(read->channels[k - 1].name, track_column_name(k));
        }
        VYBEG_CLOSE_RATIO(read->rate_hz, 1 / 0.00018, 1e-9);
    }

    void a_disk_that_is_full_at_any_size_leaves_the_old_file_data() {
        QTest::addColumn<QString>("name");
        for (const char* name : {"full.csv", "full.npz", "full.h5", "full.mat"}) {
            QTest::newRow(name) << name;
        }
    }

    void a_disk_that_is_full_at_any_size_leaves_the_old_file() {
        QFETCH(QString, name);
        const Track track = random_track(3000);
        const auto target = path(name);
        check_full_disk({folder_.filePath(name)}, 15, [&]() -> Status {
            auto file = OutputFile::create(target, {});
            if (!file) {
                return file.error();
            }
            const Status written = write_track(*file, *track_format(target), track, header, {});
            return written ? file->commit() : written;
        });
    }

    void every_format_holds_what_the_csv_holds_data() {
        QTest::addColumn<int>("rows");
        for (const int rows : {0, 1, 2, 155554}) {
            QTest::newRow(qPrintable(QString::number(rows))) << rows;
        }
    }

    void every_format_holds_what_the_csv_holds() {
        QFETCH(int, rows);
        write(random_track(static_cast<std::size_t>(rows)), "track");
        compare("track", static_cast<std::size_t>(rows));
    }

    void a_track_without_valid_windows_has_nan_and_its_flags() {
        Track track(300);
        for (std::size_t row = 0; row < track.rows(); ++row) {
            track.time_s()[row] = static_cast<double>(row);
            track.flags()[row] = static_cast<Flags>(Flag::gap);
        }
        write(track, "invalid");
        compare("invalid", 300);
    }

    void no_flag_at_all_is_an_empty_text() {
        Track track(5);
        write(track, "plain");
        compare("plain", 5);
        run_python(folder_.path().toStdString(),
                   "assert np.load('plain.npz')['flag'].tolist() == [''] * 5");
    }

    void extreme_numbers_keep_their_bits() {
        Track track = random_track(9);
        const std::array numbers{-0.0,
                                 std::numeric_limits<double>::denorm_min(),
                                 std::numeric_limits<double>::max(),
                                 std::numeric_limits<double>::infinity(),
                                 -std::numeric_limits<double>::infinity(),
                                 0.1 + 0.2,
                                 1e-300,
                                 5300.000000000001,
                                 0.0};
        std::ranges::copy(numbers, track.values(SlowVariable::f).begin());
        write(track, "extreme");
        compare("extreme", 9);
    }

    // Pieces of different lengths, more than the spool keeps in memory, and flags that are known at
    // the end.
    void a_track_written_while_it_is_computed_is_the_same_file_data() {
        QTest::addColumn<QString>("name");
        for (const char* name : {"s.csv", "s.npz", "s.h5", "s.mat"}) {
            QTest::newRow(name) << name;
        }
    }

    void a_track_written_while_it_is_computed_is_the_same_file() {
        QFETCH(QString, name);
        const std::vector<FlaggedRows> flagged{{30000, 30000, Flag::clipped},
                                               {61234, 5, Flag::gap}};
        const TrackFormat format = *track_format(path(name));
        auto file = OutputFile::create(path(name), {});
        QVERIFY(file);
        TrackSpool spool(*file, {});
        Track whole;
        for (std::size_t piece = 0; piece < 30; ++piece) {
            const Track rows = random_track(2000 + 100 * piece);
            QVERIFY(spool.append(rows));
            whole.append(rows);
        }
        set_flags(whole.flags(), 0, flagged);
        spool.set_flagged(flagged);
        QVERIFY(write_track(*file, format, spool, header, {}));
        QVERIFY(file->commit());
        auto other = OutputFile::create(path("other-" + name), {});
        QVERIFY(other && write_track(*other, format, whole, header, {}) && other->commit());
        QVERIFY(content(name) == content("other-" + name));
        VYBEG_MORE(content(name).size(), 9'000'000);
    }

    void equal_tracks_make_equal_files() {
        const Track track = random_track(10);
        write(track, "one");
        const qint64 second = QDateTime::currentSecsSinceEpoch();
        QTRY_VERIFY(QDateTime::currentSecsSinceEpoch() >= second + 2);  // the step of ZIP's times
        write(track, "two");
        for (const char* ending : {".npz", ".h5", ".mat"}) {
            QVERIFY2(content("one" + QString(ending)) == content("two" + QString(ending)), ending);
        }
    }

    // As recordings: the columns are channels, t_s tells their rate.
    void vybeg_reads_them_as_recordings_data() {
        QTest::addColumn<QString>("ending");
        for (const char* ending : {".npz", ".h5", ".mat"}) {
            QTest::newRow(ending) << ending;
        }
    }

    void vybeg_reads_them_as_recordings() {
        QFETCH(QString, ending);
        const Track track = random_track(2000);
        write(track, "again");
        OpenOptions options{.variables = {"a_A", "f_Hz"}};
        const auto recording = open_recording(path("again" + ending), options, {});
        QVERIFY2(recording, recording ? "" : english(recording.error()).c_str());
        QCOMPARE(recording->frames(), std::int64_t{2000});
        VYBEG_CLOSE(recording->rate_hz, 1 / 0.00018, 1e-6 / 0.00018, "rate of the times");
        QCOMPARE(recording->rate_from, RateOrigin::time_column);
        std::vector<double> c(2000);
        std::vector<double> d(2000);
        QVERIFY(recording->source->read(0, c, d));
        QVERIFY(std::ranges::equal(c, track.values(SlowVariable::a_A)));
        QVERIFY(std::ranges::equal(d, track.values(SlowVariable::f)));
        options.variables.clear();
        const auto all = open_recording(path("again" + ending), options, {});
        QVERIFY(all);
        QCOMPARE(all->channels.size(), std::size_t{12});  // every column but t_s, flag, header
    }

    void one_window_is_no_recording() {
        write(random_track(1), "single");
        for (const auto& [ending, code] :
             {std::pair(".npz", ErrorCode::format_unsupported),  // names the texts that it holds
              {".h5", ErrorCode::no_channels},
              {".mat", ErrorCode::no_channels}}) {
            const auto recording = open_recording(path("single" + QString(ending)), {}, {});
            QVERIFY(!recording);
            QCOMPARE(recording.error().code, code);
            // No file of channel D could help.
            QVERIFY(english(recording.error()).find("--channel-d") == std::string::npos);
        }
    }

    void a_mat_file_refuses_more_than_its_lengths_can_count() {
        auto file = OutputFile::create(path("many.mat"), {});
        QVERIFY(file);
        const Status written = write_track(*file, TrackFormat::mat, ManyRows(), {}, {});
        QVERIFY(!written);
        QCOMPARE(written.error().code, ErrorCode::output_failed);
        QVERIFY(english(written.error()).find("100000000 windows") != std::string::npos);
    }

    void a_pipe_takes_every_format() {
        const Track track = random_track(3000);
        write(track, "file");
        for (const char* ending : {".csv", ".npz", ".h5", ".mat"}) {
            const QString name = "pipe" + QString(ending);
            QFile pipe(folder_.filePath(name));
            QVERIFY(pipe.open(QIODevice::WriteOnly));
            // Written directly, as to a pipe: no seeking.
            OutputFile file = OutputFile::onto(pipe.handle(), name.toStdString(), {});
            QVERIFY(write_track(file, *track_format(path(name)), track, header, {}));
            QVERIFY(file.commit());
            QVERIFY2(content(name) == content("file" + QString(ending)), ending);
        }
    }

    void a_stop_ends_the_writing() {
        const Track track = random_track(20000);
        std::stop_source stop;
        stop.request_stop();
        for (const char* ending : {".csv", ".npz", ".h5", ".mat"}) {
            const auto target = path("stopped" + QString(ending));
            auto file = OutputFile::create(target, JobControl(stop.get_token()));
            QVERIFY(file);
            Status written = write_track(*file, *track_format(target), track, header, {});
            written = written ? file->commit() : written;
            QVERIFY(!written);
            QCOMPARE(written.error().code, ErrorCode::interrupted);
        }
    }
};

VYBEG_TEST(TestTrackFile, threads)

}  // namespace test_track_file

#include "test_track_file.moc"
