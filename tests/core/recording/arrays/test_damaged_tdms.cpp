#include "tests/closeness.h"
#include "tests/core/recording/arrays/tdms_file.h"
#include "tests/core/recording/damaged_files.h"
#include "tests/test_registry.h"

namespace test_damaged_tdms {

using namespace vybeg;
using namespace vybeg::test;

class TestDamagedTdms : public QObject {
    Q_OBJECT

private slots:
    void a_segment_that_was_never_closed_gives_what_is_there_data() {
        QTest::addColumn<bool>("interleave");
        QTest::addColumn<bool>("closed");
        QTest::addColumn<int>("raw_bytes");  // of the 200 in two chunks of 50 frames
        QTest::addColumn<int>("frames");
        QTest::addColumn<int>("promised");
        for (const bool closed : {false, true}) {
            const char* kind = closed ? "cut" : "never closed";
            // A chunk is 50 values of C, then 50 of D.
            QTest::addRow("contiguous, %s", kind) << false << closed << 100 + 50 + 7 << 57 << 100;
            QTest::addRow("contiguous, %s within C", kind)
                << false << closed << 100 + 9 << 50 << 100;
            QTest::addRow("interleaved, %s", kind) << true << closed << 100 + 15 << 57 << 100;
        }
        QTest::addRow("whole chunks, never closed") << false << false << 100 << 50 << 50;
        QTest::addRow("first chunk, never closed") << true << false << 24 << 12 << 50;
    }

    void a_segment_that_was_never_closed_gives_what_is_there() {
        QFETCH(bool, interleave);
        QFETCH(bool, closed);
        QFETCH(int, raw_bytes);
        QFETCH(int, frames);
        QFETCH(int, promised);
        const Samples samples = whole_numbers(100);
        const Tdms t;
        const std::string metadata = both_channels(t, tds_u8, 50);
        std::string raw;
        for (const std::size_t first : {std::size_t{0}, std::size_t{50}}) {
            const auto c = part(samples.c, first, 50);
            const auto d = part(samples.d, first, 50);
            raw += interleave ? t.raw<std::uint8_t>(interleaved(c, d))
                              : t.raw<std::uint8_t>(c) + t.raw<std::uint8_t>(d);
        }
        const std::uint64_t next = closed ? metadata.size() + 200 : ~std::uint64_t{0};
        const std::uint32_t contents = first_segment | (interleave ? toc_interleaved : 0);
        const Recording recording =
            opened(folder_.write("run", t.lead_in(contents, next, metadata.size()) + metadata +
                                            raw.substr(0, static_cast<std::size_t>(raw_bytes))));
        QCOMPARE(recording.frames(), frames);
        // Only a closed segment says how many there were to be.
        QCOMPARE(recording.diagnostics.size(), 1u);
        const Diagnostic& early = recording.diagnostics.front();
        QVERIFY(early.kind ==
                (closed ? DiagnosticKind::file_ends_early : DiagnosticKind::file_not_closed));
        const std::string there = std::to_string(frames);
        QCOMPARE(early.args, (closed ? std::vector<MessageArg>{std::to_string(promised), there}
                                     : std::vector<MessageArg>{there}));
        QCOMPARE(read_all(recording).c, part(samples.c, 0, static_cast<std::size_t>(frames)));
        QCOMPARE(read_all(recording).d, part(samples.d, 0, static_cast<std::size_t>(frames)));
    }

    void what_is_not_read_is_refused_by_name_data() {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("word");
        const Tdms t;
        const auto add = [](const char* name, const std::string& bytes, const char* word) {
            QTest::newRow(name) << QByteArray::fromStdString(bytes) << QString(word);
        };
        const std::string c = t.object(path_c, t.values(tds_i16, 5), {t.real("wf_increment", 0.5)});
        const std::string raw(20, '\1');
        add("table of contents", t.segment(first_segment | toc_daqmx, t.metadata({c}), raw),
            "DAQmx");
        add("index", "TDSh" + small_file(wave(10)).substr(4, 200), "index");
        add("type changes",
            t.segment(first_segment, both_channels(t, tds_i16, 5), raw) +
                t.segment(first_segment, both_channels(t, tds_u16, 5), raw),
            "changes");
        add("unknown type",
            t.segment(first_segment, t.metadata({c, t.object(path_d, t.values(0x4F, 5))}), raw),
            "79");
        add("unknown property",
            t.segment(
                first_segment,
                t.metadata({t.object(path_c, t.values(tds_i16, 5),
                                     {t.text("x") + t.number(std::uint32_t{0x4F}) + "....."})}),
                raw),
            "79");
        add("two rates",
            t.segment(first_segment,
                      t.metadata({c, t.object(path_d, t.values(tds_i16, 5),
                                              {t.real("wf_increment", 0.25)})}),
                      raw),
            "sample rates");
    }

    void what_is_not_read_is_refused_by_name() {
        QFETCH(QByteArray, bytes);
        QFETCH(QString, word);
        const auto recording = open(folder_.write("run", bytes.toStdString()));
        QVERIFY(!recording);
        const QString sentence = QString::fromStdString(english(recording.error()));
        QVERIFY2(recording.error().code == ErrorCode::format_unsupported, qPrintable(sentence));
        QVERIFY2(sentence.contains(word), qPrintable(sentence));
    }

    void wrong_lengths_are_damage_data() {
        QTest::addColumn<QByteArray>("bytes");
        const Tdms t;
        const auto add = [](const char* name, const std::string& bytes) {
            QTest::newRow(name) << QByteArray::fromStdString(bytes);
        };
        const std::string metadata = both_channels(t, tds_i16, 5);
        const std::string raw(20, '\1');
        constexpr std::uint64_t far = std::uint64_t{1} << 63;
        const std::string after = metadata + raw;
        add("values 2^63", t.segment(first_segment, both_channels(t, tds_i16, far), raw));
        add("values 2^64 - 1",
            t.segment(first_segment, both_channels(t, tds_i16, ~far | far), raw));
        add("string 2^32 - 1",
            t.segment(first_segment, t.number(std::uint32_t{1}) + t.number(~std::uint32_t{0}),
                      raw));
        add("objects 2^32 - 1", t.segment(first_segment, t.number(~std::uint32_t{0}), raw));
        add("properties 2^32 - 1", t.segment(first_segment,
                                             t.number(std::uint32_t{1}) + t.text(path_c) +
                                                 t.values(tds_i16, 5) + t.number(~std::uint32_t{0}),
                                             raw));
        add("raw data behind the next segment",
            t.lead_in(first_segment, metadata.size() - 1, metadata.size()) + after);
        add("no segment where the next should be",
            t.lead_in(first_segment, metadata.size() + 20, metadata.size()) + after +
                std::string(40, 'x'));
        add("not the first chunk's length",
            t.segment(first_segment, metadata, std::string(21, '\1')) + t.segment(0, "", ""));
        add("as before, without a before",
            t.segment(first_segment, t.metadata({t.object(path_c, t.as_before())}), raw));
        add("no path",
            t.segment(first_segment, t.metadata({t.object("C", t.values(tds_i16, 5))}), raw));
        add("an open path",
            t.segment(first_segment, t.metadata({t.object("/'Run'/'C", t.values(tds_i16, 5))}),
                      raw));
        const std::string scaler = t.number(std::uint32_t{0x1269}) + t.number(~std::uint32_t{0}) +
                                   t.number(std::uint32_t{1}) + t.number(std::uint64_t{5});
        const std::string lines = t.number(std::uint32_t{0x126A}) + scaler.substr(4);
        for (const auto& [name, index] : {std::pair("scalers of DAQmx cut off", scaler),
                                          std::pair("lines of DAQmx cut off", lines)}) {
            add(name,
                t.segment(first_segment | toc_daqmx, t.metadata({t.object(path_c, index)}), raw));
        }
        add("different lengths interleaved",
            t.segment(
                first_segment | toc_interleaved,
                t.metadata({t.object(path_c, t.values(tds_i16, 5), {t.real("wf_increment", 1)}),
                            t.object(path_d, t.values(tds_i16, 6))}),
                std::string(22, '\1')));
    }

    void wrong_lengths_are_damage() {
        QFETCH(QByteArray, bytes);
        const auto recording = open(folder_.write("run", bytes.toStdString()));
        QVERIFY(!recording);
        QVERIFY2(recording.error().code == ErrorCode::format_damaged,
                 english(recording.error()).c_str());
    }

    void a_file_cut_anywhere_does_no_harm_data() {
        QTest::addColumn<bool>("big_endian");
        QTest::addColumn<bool>("interleave");
        QTest::newRow("little endian, contiguous") << false << false;
        QTest::newRow("big endian, interleaved") << true << true;
    }

    void a_file_cut_anywhere_does_no_harm() {
        QFETCH(bool, big_endian);
        QFETCH(bool, interleave);
        const Tdms t{big_endian};
        const std::uint32_t order = interleave ? toc_interleaved : 0;
        const std::string raw(2 * 2 * 20, '\2');
        const std::string bytes =
            t.segment(first_segment | order, both_channels(t, tds_i16, 20), raw) +
            t.segment(toc_raw | order, "", raw) +
            t.segment(toc_raw | toc_metadata | order,
                      t.metadata({t.object(path_d, t.as_before(), {t.words("unit_string", "V")})}),
                      raw);
        const auto most = static_cast<std::int64_t>(bytes.size());
        const DamageCount cut = cut_everywhere(folder_, bytes, {}, most);
        QCOMPARE(cut.wrong_status + cut.too_long + cut.unreadable, 0);
        VYBEG_MORE(cut.read, 100);
        VYBEG_MORE(cut.refused, 100);
        VYBEG_LESS(cut.slowest_ms, 2000);
    }

private:
    Folder folder_;
};

VYBEG_TEST(TestDamagedTdms)

}  // namespace test_damaged_tdms

#include "test_damaged_tdms.moc"
