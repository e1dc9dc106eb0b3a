#include "tests/closeness.h"
#include "tests/core/recording/arrays/tdms_file.h"
#include "tests/core/recording/recording_files.h"
#include "tests/test_registry.h"

namespace test_tdms_reader {

using namespace vybeg;
using namespace vybeg::test;

namespace {

template <class Number>
std::string several_segments(const Samples& samples, const Tdms& t, std::uint32_t type,
                             bool interleave) {
    const std::uint32_t order = interleave ? toc_interleaved : 0;
    const auto chunk = [&](std::size_t first, std::size_t count) {
        const auto c = part(samples.c, first, count);
        const auto d = part(samples.d, first, count);
        return interleave ? t.raw<Number>(interleaved(c, d)) : t.raw<Number>(c) + t.raw<Number>(d);
    };
    // Two chunks; one without metadata; a new length; the list reversed, with the lengths before.
    std::string bytes = t.segment(first_segment | order, both_channels(t, type, 30000),
                                  chunk(0, 30000) + chunk(30000, 30000));
    bytes += t.segment(toc_raw | order, "", chunk(60000, 30000));
    bytes += t.segment(
        toc_metadata | toc_raw | order,
        t.metadata({t.object(path_d, t.values(type, 700)), t.object(path_c, t.values(type, 700))}),
        chunk(90000, 700));
    bytes += t.segment(toc_metadata, t.metadata({t.object("/", t.no_values())}), "");
    const auto c = part(samples.c, 90700, 700);
    const auto d = part(samples.d, 90700, 700);
    bytes += t.segment(
        first_segment | order,
        t.metadata({t.object(path_d, t.as_before()), t.object(path_c, t.as_before())}),
        interleave ? t.raw<Number>(interleaved(d, c)) : t.raw<Number>(d) + t.raw<Number>(c));
    return bytes;
}

}  // namespace

class TestTdmsReader : public QObject {
    Q_OBJECT

private slots:
    void a_file_written_out_byte_by_byte_is_read() {
        // Independent of the writer above: two channels of five 16 bit integers, 0.001 s apart.
        const QByteArray bytes = QByteArray::fromHex(
            "5444536d 0e000000 69120000 7c00000000000000 6800000000000000"  // lead-in
            "02000000"                                                      // two objects
            "08000000 2f2767272f276127"                                     // /'g'/'a'
            "14000000 02000000 01000000 0500000000000000"                   // I16, 1 dimension, 5
            "01000000 0c000000 77665f696e6372656d656e74 0a000000 fca9f1d24d62503f"  // wf_increment
            "08000000 2f2767272f276227"                                             // /'g'/'b'
            "14000000 02000000 01000000 0500000000000000 00000000"
            "0100 0200 0300 0400 0500  ffff feff fdff fcff fbff");
        const Recording recording = opened(folder_.write("bytes", bytes.toStdString()));
        QCOMPARE(english(recording.format), std::string("TDMS, 16 bit integer, 2 channels"));
        QCOMPARE(recording.rate_hz, 1000.0);
        QVERIFY(recording.diagnostics.empty());
        QCOMPARE(read_all(recording).c, (std::vector<double>{1, 2, 3, 4, 5}));
        QCOMPARE(read_all(recording).d, (std::vector<double>{-1, -2, -3, -4, -5}));
    }

    void every_type_order_and_layout_over_several_segments_data() {
        QTest::addColumn<int>("type");
        QTest::addColumn<bool>("big_endian");
        QTest::addColumn<bool>("interleave");
        for (const std::uint32_t type :
             {tds_i8, tds_i16, tds_i32, tds_i64, tds_u8, tds_u16, tds_u32, tds_f32, tds_f64}) {
            for (const bool big_endian : {false, true}) {
                for (const bool interleave : {false, true}) {
                    QTest::addRow("type %u, %s, %s", type, big_endian ? "big" : "little",
                                  interleave ? "interleaved" : "contiguous")
                        << static_cast<int>(type) << big_endian << interleave;
                }
            }
        }
    }

    void every_type_order_and_layout_over_several_segments() {
        QFETCH(int, type);
        QFETCH(bool, big_endian);
        QFETCH(bool, interleave);
        const Samples samples = whole_numbers(91400);
        const Tdms t{big_endian};
        const auto written = [&](auto number) {
            return several_segments<decltype(number)>(samples, t, static_cast<std::uint32_t>(type),
                                                      interleave);
        };
        std::string bytes;
        switch (static_cast<std::uint32_t>(type)) {
            case tds_i8: bytes = written(std::int8_t{}); break;
            case tds_i16: bytes = written(std::int16_t{}); break;
            case tds_i32: bytes = written(std::int32_t{}); break;
            case tds_i64: bytes = written(std::int64_t{}); break;
            case tds_u8: bytes = written(std::uint8_t{}); break;
            case tds_u16: bytes = written(std::uint16_t{}); break;
            case tds_u32: bytes = written(std::uint32_t{}); break;
            case tds_f32: bytes = written(float{}); break;
            default: bytes = written(double{}); break;
        }
        const Recording recording = opened(folder_.write("run", bytes));
        QVERIFY(recording.diagnostics.empty());
        QCOMPARE(recording.frames(), 91400);
        const Samples read = read_all(recording);
        QCOMPARE(read, samples);
        if (type == tds_i16) {
            QVERIFY(same_however_cut(*recording.source, 40000));
        }
    }

    void many_small_segments_are_one_recording() {
        // As LabVIEW appends: 10 values of each channel at a time, an odd one in between.
        const Samples samples = whole_numbers(20003);
        const Tdms t;
        std::string bytes = t.segment(first_segment, both_channels(t, tds_i16, 10),
                                      t.raw<std::int16_t>(part(samples.c, 0, 10)) +
                                          t.raw<std::int16_t>(part(samples.d, 0, 10)));
        for (std::size_t at = 10; at < 20003;) {
            const std::size_t count = at == 10000 ? 3 : 10;
            const std::string raw = t.raw<std::int16_t>(part(samples.c, at, count)) +
                                    t.raw<std::int16_t>(part(samples.d, at, count));
            const bool changes = at == 10000 || at == 10003;
            bytes += changes ? t.segment(toc_metadata | toc_raw,
                                         t.metadata({t.object(path_c, t.values(tds_i16, count)),
                                                     t.object(path_d, t.values(tds_i16, count))}),
                                         raw)
                             : t.segment(toc_raw, "", raw);
            at += count;
        }
        const Recording recording = opened(folder_.write("run", bytes));
        QCOMPARE(recording.frames(), 20003);
        QCOMPARE(read_all(recording), samples);
        QVERIFY(same_however_cut(*recording.source, 15000));
    }

    void rate_names_unit_and_start_come_from_the_properties_data() {
        QTest::addColumn<bool>("big_endian");
        QTest::addColumn<int>("place");
        for (const bool big_endian : {false, true}) {
            for (const int place : {0, 1, 2}) {
                QTest::addRow("%s, %s", big_endian ? "big" : "little",
                              place == 0   ? "channel"
                              : place == 1 ? "group"
                                           : "file")
                    << big_endian << place;
            }
        }
    }

    void rate_names_unit_and_start_come_from_the_properties() {
        QFETCH(bool, big_endian);
        QFETCH(int, place);
        const Tdms t{big_endian};
        const auto step = [&](int at) {
            return at == place ? std::vector<std::string>{t.real("wf_increment", 1.0 / 33333)}
                               : std::vector<std::string>{};
        };
        std::vector<std::string> c = step(0);
        // 2020-03-01 12:34:56.789 UTC, 3665910896 s after the start of 1904.
        c.push_back(t.time("wf_start_time", 3665910896, 0xC9FBE76C8B439581));
        c.push_back(t.words("unit_string", "мВ"));
        c.push_back(t.whole("wf_samples", 5));
        const std::string metadata = t.metadata(
            {t.object("/", t.no_values(), step(2)), t.object("/'Run'", t.no_values(), step(1)),
             t.object(path_c, t.values(tds_f64, 5), c), t.object(path_d, t.values(tds_f64, 5))});
        const auto path =
            folder_.write("run", t.segment(first_segment, metadata, std::string(80, '\0')));
        const Recording recording = opened(path, {.rate_hz = 5.0, .raw = std::nullopt});
        QCOMPARE(recording.rate_hz, 33333.0);
        QCOMPARE(recording.rate_from, RateOrigin::file);
        QCOMPARE(recording.start, std::string("2020-03-01T12:34:56.789Z"));
        QCOMPARE(recording.channels[0], (Channel{"C", "мВ"}));
        QCOMPARE(recording.channels[1], (Channel{"D", ""}));
    }

    void groups_and_quotes_stand_in_names() {
        const Tdms t;
        const std::string metadata = t.metadata({t.object("/'A'/'Bob''s'", t.values(tds_i8, 5)),
                                                 t.object("/'B'/'x/y'", t.values(tds_i8, 5))});
        const auto path =
            folder_.write("run", t.segment(first_segment, metadata, std::string(10, '\1')));
        QCOMPARE(open(path).error().code, ErrorCode::rate_unknown);
        const Recording recording = opened(path, {.rate_hz = 5.0, .raw = std::nullopt});
        QCOMPARE(recording.rate_from, RateOrigin::option);
        QCOMPARE(recording.channels[0].name, std::string("A/Bob's"));
        QCOMPARE(recording.channels[1].name, std::string("B/x/y"));
    }

    void other_channels_are_passed_over() {
        // Texts, flags, times and a channel without values stand between C and D.
        const Tdms t;
        const std::string metadata =
            t.metadata({t.object("/'Run'/'Note'", t.strings(2, 13)),
                        t.object(path_c, t.values(tds_i16, 6), {t.real("wf_increment", 0.5)}),
                        t.object("/'Run'/'Flag'", t.values(tds_boolean, 3)),
                        t.object("/'Run'/'Stamp'", t.values(tds_time, 1)),
                        t.object("/'Run'/'Empty'", t.no_values()),
                        t.object("/'Run'/'Time'", t.values(tds_f64, 6)),
                        t.object(path_d, t.values(tds_i32, 6))});
        const std::string chunk = std::string(13, 'x') + t.raw<std::int16_t>({1, 2, 3, 4, 5, 6}) +
                                  std::string(3 + 16, 'x') + std::string(48, 'x') +
                                  t.raw<std::int32_t>({6, 5, 4, 3, 2, 1});
        const Recording recording =
            opened(folder_.write("run", t.segment(first_segment, metadata, chunk + chunk)));
        QCOMPARE(recording.channels.size(), 2u);
        QCOMPARE(recording.rate_hz, 2.0);
        QCOMPARE(read_all(recording).c, (std::vector<double>{1, 2, 3, 4, 5, 6, 1, 2, 3, 4, 5, 6}));
        QCOMPARE(read_all(recording).d, (std::vector<double>{6, 5, 4, 3, 2, 1, 6, 5, 4, 3, 2, 1}));

        const OpenOptions options{.channel_d = 3};
        QCOMPARE(open(folder_.file("run"), options).error().code, ErrorCode::channel_out_of_range);
    }

    void a_linear_scale_is_applied() {
        const Tdms t;
        const auto file = [&](const std::string& status, const std::string& type) {
            const std::string metadata = t.metadata(
                {t.object(
                     path_c, t.values(tds_i16, 5),
                     {t.real("wf_increment", 0.5), t.words("NI_Scaling_Status", status),
                      t.whole("NI_Number_Of_Scales", 1), t.words("NI_Scale[0]_Scale_Type", type),
                      t.real("NI_Scale[0]_Linear_Slope", 0.25),
                      t.real("NI_Scale[0]_Linear_Y_Intercept", -1)}),
                 t.object(path_d, t.values(tds_i16, 5))});
            const std::string raw = t.raw<std::int16_t>({0, 4, 8, 12, 16, 0, 4, 8, 12, 16});
            return folder_.write("run", t.segment(first_segment, metadata, raw));
        };
        const Samples scaled = read_all(opened(file("unscaled", "Linear")));
        QCOMPARE(scaled.c, (std::vector<double>{-1, 0, 1, 2, 3}));
        QCOMPARE(scaled.d, (std::vector<double>{0, 4, 8, 12, 16}));
        QCOMPARE(read_all(opened(file("scaled", "Linear"))).c, scaled.d);
        const auto refused = open(file("unscaled", "Strain"));
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::format_unsupported);
    }

    void a_channel_of_times_gives_the_rate() {
        const Tdms t;
        constexpr int count = 40;
        std::vector<double> values;
        for (int i = 0; i < count; ++i) {
            values.push_back(i * 0.5);  // ms
        }
        for (const double scale : {1.0, 2.0}) {
            for (int i = 0; i < count; ++i) {
                values.push_back(scale * i * (i % 3));
            }
        }
        const std::string metadata = t.metadata(
            {t.object("/'Run'/'Time'", t.values(tds_f64, count), {t.words("unit_string", "ms")}),
             t.object(path_c, t.values(tds_f64, count)),
             t.object(path_d, t.values(tds_f64, count))});
        const Recording recording =
            opened(folder_.write("run", t.segment(first_segment, metadata, t.raw<double>(values))));
        QCOMPARE(recording.rate_from, RateOrigin::time_column);
        VYBEG_CLOSE_RATIO(recording.rate_hz, 2000, 1e-9);
        QCOMPARE(recording.channels.size(), 2u);
    }

    void channels_of_different_times_are_told_or_refused() {
        const Tdms t;
        constexpr int count = 400;
        std::vector<double> values;
        const Samples samples = wave(count);
        values.insert(values.end(), samples.c.begin(), samples.c.end());
        values.insert(values.end(), samples.d.begin(), samples.d.end());
        const auto file = [&](const std::vector<std::string>& of_d) {
            const std::string metadata = t.metadata(
                {t.object(path_c, t.values(tds_f64, count), {t.real("wf_increment", 1e-3)}),
                 t.object(path_d, t.values(tds_f64, count), of_d)});
            return folder_.write("run", t.segment(first_segment, metadata, t.raw<double>(values)));
        };
        QCOMPARE(open(file({t.real("wf_increment", 2e-3)})).error().code,
                 ErrorCode::format_unsupported);
        const Recording late =
            opened(file({t.real("wf_increment", 1e-3), t.real("wf_start_offset", 5e-3)}));
        QVERIFY(find(late, DiagnosticKind::channel_delayed));
        VYBEG_CLOSE(read_all(late).d[200], samples.d[195], 1e-9);
    }

    void opening_stops_when_it_is_told_to() {
        std::stop_source stop;
        stop.request_stop();
        const auto recording = open_recording(folder_.write("run", small_file(wave(10))), {},
                                              JobControl(stop.get_token()));
        QVERIFY(!recording);
        QCOMPARE(recording.error().code, ErrorCode::interrupted);
    }

private:
    Folder folder_;
};

VYBEG_TEST(TestTdmsReader, threads)

}  // namespace test_tdms_reader

#include "test_tdms_reader.moc"
