#include "core/recording/bytes/number_type.h"
#include "tests/closeness.h"
#include "tests/core/recording/damaged_files.h"
#include "tests/core/recording/python_script.h"
#include "tests/core/recording/recording_files.h"
#include "tests/test_registry.h"

namespace test_npy_reader {

using namespace vybeg;
using namespace vybeg::test;

namespace {

constexpr int frames = 40000;  // several blocks of the reader

const OpenOptions with_rate{.rate_hz = 33333.0, .raw = std::nullopt};

// What the script in initTestCase() writes: whole numbers that the type can hold.
Samples written(bool is_signed) {
    Samples samples;
    for (int i = 0; i < frames; ++i) {
        samples.c.push_back(7 * i % 100 - (is_signed ? 50 : 0));
        samples.d.push_back(i % 120 - (is_signed ? 60 : 0));
    }
    return samples;
}

std::string npy_bytes(const std::string& header, const std::string& data) {
    std::string bytes("\x93NUMPY\x01\x00", 8);
    bytes += static_cast<char>(header.size() % 256);
    bytes += static_cast<char>(header.size() / 256);
    return bytes + header + data;
}

}  // namespace

class TestNpyReader : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        run_python(folder_.file(""), R"(
i = np.arange(40000)
for kind in 'iuf':
    for size in ((2, 4, 8) if kind == 'f' else (1, 2, 4, 8)):
        for order in '<>':
            less = (0, 0) if kind == 'u' else (50, 60)
            pair = np.stack([7 * i % 100 - less[0], i % 120 - less[1]], axis=1)
            name = kind + str(size) + ('be' if order == '>' else 'le')
            pair = pair.astype(order + kind + str(size))
            np.save(name + '-C-columns', pair)
            np.save(name + '-F-columns', np.asfortranarray(pair))
            np.save(name + '-C-rows', np.ascontiguousarray(pair.T))
            np.save(name + '-F-rows', np.asfortranarray(pair.T))
for version in (1, 2, 3):
    with open('version%d.npy' % version, 'wb') as file:
        np.lib.format.write_array(file, np.stack([3 * i, -i], axis=1).astype('<f8'), (version, 0))
np.save('three', np.stack([3 * i, -i, 2 * i], axis=1).astype('f4'))
np.save('gaps', np.array([[1, 2], [np.nan, 3], [np.inf, -np.inf], [4, 5], [6, 7]]))
np.save('short', np.arange(12.0).reshape(6, 2))
np.save('square', np.arange(25.0).reshape(5, 5))
np.save('vector', np.arange(10.0))
np.save('column', np.arange(10.0).reshape(10, 1))
np.save('scalar', np.float64(3))
np.save('cube', np.zeros((10, 2, 2)))
np.save('none', np.zeros((0, 2)))
np.save('long', np.zeros((10, 2), 'g'))
halves = np.arange(65536, dtype='u2').view('f2')
np.save('halves', np.stack([halves, halves[::-1]], axis=1))
np.save('widened', np.stack([halves, halves[::-1]], axis=1).astype('f8'))
np.save('complex', np.zeros((10, 2), 'c16'))
np.save('flags', np.zeros((10, 2), '?'))
np.save('words', np.array([['a', 'b']] * 10))
np.save('records', np.zeros(10, [('C', 'f8'), ('D', 'f8')]))
np.save('objects', np.array([[None, 1]] * 10, dtype=object), allow_pickle=True)
np.save('wide', np.zeros((5000, 5000), 'i1'))
)");
    }

    void every_type_byte_order_and_layout_gives_back_its_samples_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<bool>("is_signed");
        QTest::addColumn<QString>("format");
        const std::pair<const char*, const char*> types[] = {
            {"i1", "8 bit integer"},  {"u1", "8 bit unsigned integer"},
            {"i2", "16 bit integer"}, {"u2", "16 bit unsigned integer"},
            {"i4", "32 bit integer"}, {"u4", "32 bit unsigned integer"},
            {"i8", "64 bit integer"}, {"u8", "64 bit unsigned integer"},
            {"f2", "16 bit float"},   {"f4", "32 bit float"},
            {"f8", "64 bit float"}};
        for (const auto& [type, text] : types) {
            for (const char* endian : {"le", "be"}) {
                for (const char* layout : {"C-columns", "F-columns", "C-rows", "F-rows"}) {
                    const bool single_byte = type[1] == '1';
                    const bool big = endian[0] == 'b' && !single_byte;
                    QTest::addRow("%s%s %s", type, endian, layout)
                        << QString("%1%2-%3.npy").arg(type, endian, layout) << (type[0] != 'u')
                        << QString("NPY, %1, %2 endian, %3 order, 2 channels")
                               .arg(text, big ? "big" : "little",
                                    layout[0] == 'C' ? "C" : "Fortran");
                }
            }
        }
    }

    void every_type_byte_order_and_layout_gives_back_its_samples() {
        QFETCH(QString, name);
        QFETCH(bool, is_signed);
        QFETCH(QString, format);
        const Recording recording = opened(folder_.file(name.toStdString()), with_rate);
        QCOMPARE(QString::fromStdString(english(recording.format)), format);
        QCOMPARE(recording.rate_hz, 33333.0);
        QCOMPARE(recording.rate_from, RateOrigin::option);
        QVERIFY(recording.diagnostics.empty());
        const Samples read = read_all(recording);
        QCOMPARE(read, written(is_signed));
    }

    void every_number_of_16_bits_is_that_of_numpy() {
        const Samples read = read_all(opened(folder_.file("halves.npy"), with_rate));
        const Samples widened = read_all(opened(folder_.file("widened.npy"), with_rate));
        QCOMPARE(read.c.size(), 65536u);
        const auto same = [](double x, double y) {
            return x == y || (std::isnan(x) && std::isnan(y));
        };
        QVERIFY(std::ranges::equal(read.c, widened.c, same));
        QVERIFY(std::ranges::equal(read.d, widened.d, same));
    }

    void any_part_of_a_file_is_the_same_part_of_its_samples_data() {
        QTest::addColumn<QString>("name");
        for (const char* name : {"f8le-C-columns.npy", "f8be-F-columns.npy", "i2le-C-rows.npy"}) {
            QTest::newRow(name) << QString(name);
        }
    }

    void any_part_of_a_file_is_the_same_part_of_its_samples() {
        QFETCH(QString, name);
        const Recording recording = opened(folder_.file(name.toStdString()), with_rate);
        QVERIFY(same_however_cut(*recording.source, 30000));
    }

    void every_version_of_the_format_is_read_data() {
        QTest::addColumn<QString>("name");
        for (const char* name : {"version1.npy", "version2.npy", "version3.npy"}) {
            QTest::newRow(name) << QString(name);
        }
    }

    void every_version_of_the_format_is_read() {
        QFETCH(QString, name);
        const auto path = folder_.file(name.toStdString());
        QCOMPARE(int{bytes_of(path)[6]}, name[7].digitValue());
        const Samples read = read_all(opened(path, with_rate));
        QCOMPARE(read.c.size(), std::size_t{frames});
        QCOMPARE(read.c[39999], 119997.0);
        QCOMPARE(read.d[39999], -39999.0);
    }

    void the_header_may_have_any_order_and_blanks() {
        const std::string data(80, '\0');
        for (const char* header :
             {"{'shape':(5,2),'fortran_order':False,'descr':'<f8'}",
              "  { \"descr\" : \"f8\" ,\n 'shape' : ( 5L , 2L , ) , 'fortran_order' :\tFalse , }  "
              "\n",
              "{'fortran_order': False, 'descr': '=f8', 'shape': (5, 2), }\n"}) {
            const auto recording =
                open(folder_.write("header", npy_bytes(header, data)), with_rate);
            QVERIFY2(recording, header);
            QCOMPARE(recording->frames(), 5);
        }
        for (const char* header :
             {"", "{", "{}", "{'descr': '<f8'}",
              "{'descr': '<f8', 'fortran_order': 0, 'shape': (5, 2)}",
              "{'descr': '<f8', 'fortran_order': False, 'shape': (5, -2)}",
              "{'descr': '<f8', 'fortran_order': False, 'shape': (5 2)}",
              "{'descr': '<f8', 'fortran_order': False, 'shape': 5}",
              "{'descr': '<f8', 'fortran_order': False, 'shape': (5, 2), 'more': 1}",
              "{'descr': '<f8', 'fortran_order': False, 'shape': (5, 2)} + 1",
              "{'descr': '<f8' 'fortran_order': False, 'shape': (5, 2)}"}) {
            const auto recording =
                open(folder_.write("header", npy_bytes(header, data)), with_rate);
            QVERIFY2(!recording, header);
            QCOMPARE(recording.error().code, ErrorCode::format_damaged);
        }
    }

    void channels_are_chosen_from_more_than_two() {
        OpenOptions options = with_rate;
        options.channel_c = 3;
        options.channel_d = 1;
        const Recording recording = opened(folder_.file("three.npy"), options);
        QCOMPARE(recording.channels.size(), 3u);
        QCOMPARE(recording.channel_c, 3);
        const Samples read = read_all(recording);
        QCOMPARE(read.c[30000], 60000.0);
        QCOMPARE(read.d[30000], 90000.0);
        options.channel_d = 4;
        QCOMPARE(open(folder_.file("three.npy"), options).error().code,
                 ErrorCode::channel_out_of_range);
    }

    void a_first_column_that_counts_seconds_is_the_time() {
        std::string data;
        const Samples samples = wave(300);
        for (int i = 0; i < 300; ++i) {
            const auto k = static_cast<std::size_t>(i);
            data +=
                store(i / 8000.0, false) + store(samples.c[k], false) + store(samples.d[k], false);
        }
        const auto path = folder_.write(
            "timed.npy",
            npy_bytes("{'descr': '<f8', 'fortran_order': False, 'shape': (300, 3), }", data));
        const Recording recording = opened(path);
        QCOMPARE(recording.rate_from, RateOrigin::time_column);
        VYBEG_CLOSE_RATIO(recording.rate_hz, 8000, 1e-9);
        QCOMPARE(recording.channels.size(), 2u);
        QCOMPARE(read_all(recording), samples);
    }

    void missing_and_infinite_samples_are_nan() {
        const Samples read = read_all(opened(folder_.file("gaps.npy"), with_rate));
        QCOMPARE(worst_difference(read.c, {1, no_value, no_value, 4, 6}), 0.0);
        QCOMPARE(worst_difference(read.d, {2, 3, no_value, 5, 7}), 0.0);
    }

    void the_longer_axis_is_time() {
        // Of a square one, the first.
        const Samples read = read_all(opened(folder_.file("square.npy"), with_rate));
        QCOMPARE(read.c, (std::vector<double>{0, 5, 10, 15, 20}));
        QCOMPARE(read.d, (std::vector<double>{1, 6, 11, 16, 21}));
    }

    void a_file_cut_short_opens_with_what_is_there_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<int>("bytes");
        QTest::addColumn<int>("present");
        QTest::newRow("side by side, within a frame")
            << "f8le-C-columns.npy" << 128 + 16 * 700 + 9 << 700;
        QTest::newRow("side by side, D just there")
            << "f8le-C-columns.npy" << 128 + 16 * 700 << 700;
        QTest::newRow("one after the other")
            << "f8le-F-columns.npy" << 128 + 8 * (frames + 700) + 7 << 700;
        QTest::newRow("rows") << "i2le-C-rows.npy" << 128 + 2 * (frames + 5) << 5;
    }

    void a_file_cut_short_opens_with_what_is_there() {
        QFETCH(QString, name);
        QFETCH(int, bytes);
        QFETCH(int, present);
        const std::string whole = bytes_of(folder_.file(name.toStdString()));
        const auto cut = folder_.write(
            "cut", std::string_view(whole).substr(0, static_cast<std::size_t>(bytes)));
        const Recording recording = opened(cut, with_rate);
        QCOMPARE(recording.frames(), present);
        const Diagnostic* early = find(recording, DiagnosticKind::file_ends_early);
        QVERIFY(early);
        QCOMPARE(early->args, (std::vector<MessageArg>{"40000", std::to_string(present)}));
        QCOMPARE(early->first_frame, present);
        Samples expected = written(true);
        expected.c.resize(static_cast<std::size_t>(present));
        expected.d.resize(static_cast<std::size_t>(present));
        const Samples read = read_all(recording);
        QCOMPARE(read, expected);
    }

    void what_cannot_be_a_recording_is_refused_by_name_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<int>("code");
        QTest::addColumn<QString>("word");
        const auto add = [](const char* name, ErrorCode code, const char* word) {
            QTest::newRow(name) << QString(name) + ".npy" << static_cast<int>(code)
                                << QString(word);
        };
        add("vector", ErrorCode::too_few_channels, "1 channel");
        add("column", ErrorCode::too_few_channels, "1 channel");
        add("scalar", ErrorCode::too_few_channels, "1 channel");
        add("none", ErrorCode::too_few_frames, "0 sample");
        add("cube", ErrorCode::format_unsupported, "3 dimensions");
        add("long", ErrorCode::format_unsupported, "<f16");
        add("complex", ErrorCode::format_unsupported, "<c16");
        add("flags", ErrorCode::format_unsupported, "|b1");
        add("words", ErrorCode::format_unsupported, "<U1");
        add("records", ErrorCode::format_unsupported, "records");
        add("objects", ErrorCode::format_unsupported, "|O");
        add("wide", ErrorCode::format_unsupported, "5000 channels");
    }

    void what_cannot_be_a_recording_is_refused_by_name() {
        QFETCH(QString, name);
        QFETCH(int, code);
        QFETCH(QString, word);
        const auto recording = open(folder_.file(name.toStdString()), with_rate);
        QVERIFY(!recording);
        QCOMPARE(static_cast<int>(recording.error().code), code);
        const QString sentence = QString::fromStdString(english(recording.error()));
        QVERIFY2(sentence.contains(word), qPrintable(sentence));
        QCOMPARE(open(folder_.file("short.npy")).error().code, ErrorCode::rate_unknown);
    }

    void lengths_beyond_the_file_are_harmless_data() {
        QTest::addColumn<QString>("shape");
        QTest::addColumn<int>("code");  // of the error; -1: it opens with what is there
        const int damaged = static_cast<int>(ErrorCode::format_damaged);
        QTest::newRow("2^63") << "(9223372036854775808, 2)" << damaged;
        QTest::newRow("2^63 - 1") << "(9223372036854775807, 2)" << damaged;
        QTest::newRow("2^64") << "(18446744073709551616, 2)" << damaged;
        QTest::newRow("product beyond 2^63") << "(4294967296, 4294967296)" << damaged;
        QTest::newRow("zero times 2^63 - 1") << "(0, 9223372036854775807)" << damaged;
        QTest::newRow("2^40") << "(1099511627776, 2)" << -1;
    }

    void lengths_beyond_the_file_are_harmless() {
        QFETCH(QString, shape);
        QFETCH(int, code);
        const std::string header =
            "{'descr': '<f8', 'fortran_order': False, 'shape': " + shape.toStdString() + "}";
        const auto recording =
            open(folder_.write("long", npy_bytes(header, std::string(96, '\0'))), with_rate);
        QCOMPARE(recording ? -1 : static_cast<int>(recording.error().code), code);
        if (recording) {
            QCOMPARE(recording->frames(), 6);
            QVERIFY(find(*recording, DiagnosticKind::file_ends_early));
        }
    }

    void a_file_cut_anywhere_does_no_harm_data() {
        QTest::addColumn<QString>("order");
        QTest::newRow("C") << "False";
        QTest::newRow("Fortran") << "True";
    }

    void a_file_cut_anywhere_does_no_harm() {
        QFETCH(QString, order);
        const std::string header =
            "{'descr': '<f8', 'fortran_order': " + order.toStdString() + ", 'shape': (20, 2), }";
        const std::string bytes = npy_bytes(header, std::string(320, '\x3F'));
        // One byte per sample at the least.
        const auto most = static_cast<std::int64_t>(bytes.size());
        const DamageCount cut = cut_everywhere(folder_, bytes, with_rate, most);
        QCOMPARE(cut.wrong_status + cut.too_long + cut.unreadable, 0);
        VYBEG_MORE(cut.read, 100);
        VYBEG_MORE(cut.refused, 100);
        VYBEG_LESS(cut.slowest_ms, 2000);
    }

private:
    Folder folder_;
};

VYBEG_TEST(TestNpyReader, threads)

}  // namespace test_npy_reader

#include "test_npy_reader.moc"
