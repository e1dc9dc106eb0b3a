#include "core/base/error.h"
#include "tests/closeness.h"
#include "tests/core/recording/audio/audio_files.h"
#include "tests/test_registry.h"

#include <sys/stat.h>
#include <unistd.h>

namespace test_bad_input {

using namespace vybeg;
using namespace vybeg::test;

namespace {

// Ordinary rights for one scope: root may read everything.
class WithoutRootRights {
public:
    WithoutRootRights() {
        if (::geteuid() == 0 && ::seteuid(65534) != 0) {
            qFatal("root rights cannot be given up");
        }
    }
    ~WithoutRootRights() {
        if (::getuid() == 0 && ::seteuid(0) != 0) {
            qFatal("root rights cannot be had back");
        }
    }
};

}  // namespace

class TestBadInput : public QObject {
    Q_OBJECT

private slots:
    void each_bad_file_has_its_error_and_one_line_that_names_it_data() {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<int>("code");
        QTest::addColumn<QStringList>("args");
        const auto add = [](const char* name, const QByteArray& bytes, ErrorCode code,
                            const QStringList& args = {}) {
            QTest::newRow(name) << bytes << static_cast<int>(code) << args;
        };
        const QByteArray rows = "t,C,D\n0,1,2\n0.1,1,2\n0.2,1,2\n0.3,1,2\n0.4,1,2\n";
        add("empty", "", ErrorCode::file_empty);
        add("binary",
            QByteArray("\x7F"
                       "ELF\x02\x01\x01\0\0\0",
                       10),
            ErrorCode::format_unknown);
        add("zeros", QByteArray(5000, '\0'), ErrorCode::format_unknown);
        add("RIFF, but no WAVE", QByteArray("RIFF\x10\0\0\0AVI LIST", 16),
            ErrorCode::format_unknown);
        add("prose", "Dear Sir,\n\nthe gyro is well.\n", ErrorCode::text_no_data);
        add("names alone", "t,E,R,S,Q\n", ErrorCode::text_no_data);
        add("blank lines", "\n\n \n", ErrorCode::text_no_data);
        add("a byte order mark alone", "\xEF\xBB\xBF", ErrorCode::text_no_data);
        add("one column", "1.5\n2.5\n3.5\n4.5\n5.5\n", ErrorCode::too_few_channels,
            {"1", "2", "FILE"});
        add("time and one channel", "t,C\n0,1\n0.1,2\n0.2,1\n0.3,2\n0.4,2\n",
            ErrorCode::too_few_channels, {"1", "2", "FILE"});
        add("no number", rows + "0.5,oops,2\n0.6,1,2\n", ErrorCode::text_not_a_number,
            {"7", "2", "oops"});
        add("no number in the second row", "t,C,D\n0,1,2\n0.1,1,x\n0.2,1,2\n0.3,1,2\n0.4,1,2\n",
            ErrorCode::text_not_a_number, {"3", "3", "x"});
        add("decimal comma in one field", "0;1.5;2\n0.1;1.5;2,5\n0.2;1;2\n0.3;1;2\n",
            ErrorCode::text_not_a_number, {"2", "3", "2,5"});
        add("no time", rows + ",1,2\n", ErrorCode::text_not_a_number, {"7", "1", ""});
        add("time is nan", rows + "nan,1,2\n", ErrorCode::text_not_a_number, {"7", "1", "nan"});
        add("one field too many", rows + "0.5,1,2,3\n", ErrorCode::text_not_a_number,
            {"7", "4", "3"});
        add("a blank-separated field is lost", "0 1 2\n0.1 1 2\n0.2 1\n0.3 1 2\n0.4 1 2\n",
            ErrorCode::text_not_a_number, {"3", "3", ""});
        add("time backwards", rows + "0.35,1,2\n", ErrorCode::text_time_backwards,
            {"7", "0.35", "0.4"});
        // Of times of one digit two may be equal by rounding; of two digits here they are not.
        add("time repeated",
            "t,C,D\n0.00,1,2\n0.10,1,2\n0.20,1,2\n0.30,1,2\n0.40,1,2\n0.40,1,2\n0.60,1,2\n",
            ErrorCode::text_time_backwards, {"7", "0.4", "0.4"});
        add("unnamed time backwards", "0,1,2\n0.1,1,2\n0.2,1,2\n0.15,1,2\n0.3,1,2\n0.4,1,2\n",
            ErrorCode::text_time_backwards, {"4", "0.15", "0.2"});
        add("four rows", "t,C,D\n0,1,2\n0.1,1,2\n0.2,1,2\n0.3,1,2\n", ErrorCode::too_few_frames,
            {"4", "5"});
        // Five rows whose times are uneven are four frames of an even grid.
        add("five uneven rows", "t,C,D\n0.12,1,2\n0.13,1,2\n0.14,1,2\n0.150065,1,2\n0.16,1,2\n",
            ErrorCode::too_few_frames, {"4", "5"});
        add("no time column", "C,D\n1,2\n2,1\n1,2\n2,1\n1,2\n", ErrorCode::rate_unknown);
        add("number of the row is no time", "n,C,D\n0,5,2\n1,7,2\n2,5,2\n3,7,2\n4,5,2\n5,7,2\n",
            ErrorCode::rate_unknown);
        add("counted time without a unit", "t,C,D\n0,5,2\n1,7,2\n2,5,2\n3,7,2\n4,5,2\n5,7,2\n",
            ErrorCode::rate_unknown);
        add("a line without end", "1,2\n" + QByteArray(3 << 20, '1'), ErrorCode::format_limit,
            {"text", "line 2 is longer than 1 MiB",
             "Write a line for each time, with one number for each channel"});
    }

    void each_bad_file_has_its_error_and_one_line_that_names_it() {
        QFETCH(QByteArray, bytes);
        QFETCH(int, code);
        QFETCH(QStringList, args);
        std::vector<MessageArg> expected;
        for (const QString& arg : args) {
            expected.emplace_back(arg.toStdString());
        }
        const Folder folder;
        verifyError(folder.write("run.csv", bytes.toStdString()), {}, static_cast<ErrorCode>(code),
                    expected);
    }

    void a_missing_file_a_folder_and_a_pipe_are_told_apart() {
        const Folder folder;
        verifyError(folder.file("nothing.wav"), {}, ErrorCode::file_missing, {});
        verifyError(folder.write("file", "1") / "inside.wav", {}, ErrorCode::file_missing, {});
        verifyError(folder.file(""), {}, ErrorCode::file_is_directory, {});
        QCOMPARE(::mkfifo(folder.file("pipe").c_str(), 0600), 0);
        verifyError(folder.file("pipe"), {}, ErrorCode::file_not_regular, {});
        verifyError("/dev/zero", {}, ErrorCode::file_not_regular, {});
    }

    void a_file_without_permission_is_told_apart() {
        const Folder folder;
        const auto path = folder.write("run.wav", "1,2\n");
        QCOMPARE(::chmod(folder.file("").c_str(), 0755), 0);
        QCOMPARE(::chmod(path.c_str(), 0), 0);
        const WithoutRootRights ordinary;
        verifyError(path, {}, ErrorCode::file_permission, {});
    }

    void bad_audio_has_its_error_data() {
        QTest::addColumn<int>("channels");
        QTest::addColumn<int>("frames");
        QTest::addColumn<int>("channel_d");
        QTest::addColumn<int>("code");
        QTest::addColumn<QStringList>("args");
        QTest::newRow("mono") << 1 << 100 << 2 << static_cast<int>(ErrorCode::too_few_channels)
                              << QStringList{"1", "2", "FILE"};
        QTest::newRow("third of two")
            << 2 << 100 << 3 << static_cast<int>(ErrorCode::channel_out_of_range)
            << QStringList{"3", "2"};
        QTest::newRow("channel 0")
            << 2 << 100 << 0 << static_cast<int>(ErrorCode::channel_out_of_range)
            << QStringList{"0", "2"};
        QTest::newRow("four frames")
            << 2 << 4 << 2 << static_cast<int>(ErrorCode::too_few_frames) << QStringList{"4", "5"};
        QTest::newRow("no frames")
            << 2 << 0 << 2 << static_cast<int>(ErrorCode::too_few_frames) << QStringList{"0", "5"};
    }

    void bad_audio_has_its_error() {
        QFETCH(int, channels);
        QFETCH(int, frames);
        QFETCH(int, channel_d);
        QFETCH(int, code);
        QFETCH(QStringList, args);
        const Folder folder;
        const OpenOptions options{.channel_d = channel_d};
        std::vector<MessageArg> expected;
        for (const QString& arg : args) {
            expected.emplace_back(arg.toStdString());
        }
        for (const int format : {SF_FORMAT_WAV, SF_FORMAT_W64, SF_FORMAT_AIFF, SF_FORMAT_CAF}) {
            write_audio(folder.file("run"), wave(static_cast<std::size_t>(frames)),
                        format | SF_FORMAT_PCM_16, 1000, channels);
            verifyError(folder.file("run"), options, static_cast<ErrorCode>(code), expected);
        }
    }

    void wrong_options_are_the_callers_fault_data() {
        QTest::addColumn<QString>("setting");
        QTest::addColumn<OpenOptions>("options");
        const auto add = [](const char* name, const char* setting, auto change) {
            OpenOptions options{.rate_hz = 1000, .raw = RawLayout{}};
            change(options);
            QTest::newRow(name) << QString(setting) << options;
        };
        add("rate 0", "--rate", [](OpenOptions& o) { o.rate_hz = 0; });
        add("rate negative", "--rate", [](OpenOptions& o) { o.rate_hz = -5; });
        add("rate nan", "--rate", [](OpenOptions& o) { o.rate_hz = no_value; });
        add("twice the same channel", "--channels", [](OpenOptions& o) { o.channel_d = 1; });
        add("no raw channels", "--raw-channels", [](OpenOptions& o) { o.raw->channels = 0; });
        add("too many raw channels", "--raw-channels",
            [](OpenOptions& o) { o.raw->channels = 1 << 30; });
        add("skip backwards", "--skip", [](OpenOptions& o) { o.raw->skip_bytes = -1; });
        add("scale 0", "--scale", [](OpenOptions& o) { o.scale = 0; });
        add("scale nan", "--scale", [](OpenOptions& o) { o.scale = no_value; });
    }

    void wrong_options_are_the_callers_fault() {
        QFETCH(QString, setting);
        QFETCH(OpenOptions, options);
        const Folder folder;
        const auto recording = open(folder.write("run", std::string(1000, 'x')), options);
        QVERIFY(!recording);
        QCOMPARE(recording.error().code, ErrorCode::setting_invalid);
        QCOMPARE(recording.error().args.at(0), setting.toStdString());
        QCOMPARE(exit_status(recording.error().code), 2);
        QVERIFY(QString::fromStdString(english(recording.error())).startsWith(setting));
    }

    void a_wrong_field_is_quoted_on_one_line_and_not_at_length() {
        const Folder folder;
        const std::string rows = "1,2\n1,2\n1,2\n";
        const OpenOptions options{.rate_hz = 1000};
        verifyError(folder.write("run", rows + "1,a\tb\x0B\xCF\n"), options,
                    ErrorCode::text_not_a_number, {"4", "2", "a b П"});
        verifyError(folder.write("run", rows + "1," + std::string(500, 'z') + "\n"), options,
                    ErrorCode::text_not_a_number, {"4", "2", std::string(40, 'z') + "..."});
    }

    void reading_text_stops_when_it_is_told_to() {
        const Folder folder;
        std::string text;
        for (int i = 0; i < 20000; ++i) {
            text += "1,2\n";
        }
        std::stop_source stop;
        stop.request_stop();
        const OpenOptions options{.rate_hz = 1000};
        const auto recording =
            open_recording(folder.write("run", text), options, JobControl(stop.get_token()));
        QVERIFY(!recording);
        QCOMPARE(recording.error().code, ErrorCode::interrupted);
    }

    void reading_text_tells_how_far_it_has_come() {
        const Folder folder;
        std::string text;
        for (int i = 0; i < 500000; ++i) {
            text += "1.25,2.5\n";
        }
        const OpenOptions options{.rate_hz = 1000};
        std::vector<double> fractions;
        const JobControl job({}, [&](double fraction) { fractions.push_back(fraction); });
        QVERIFY(open_recording(folder.write("run", text), options, job));
        VYBEG_MORE(fractions.size(), 10);
        QVERIFY(std::is_sorted(fractions.begin(), fractions.end()));
        VYBEG_MORE(fractions.front(), 0);
        VYBEG_LESS(fractions.front(), 0.5);
        VYBEG_MORE(fractions.back(), 0.9);
        VYBEG_AT_MOST(fractions.back(), 1);
    }

private:
    static void verifyError(const std::filesystem::path& path, const OpenOptions& options,
                            ErrorCode code, const std::vector<MessageArg>& args) {
        const auto recording = open(path, options);
        QVERIFY(!recording);
        QCOMPARE(static_cast<int>(recording.error().code), static_cast<int>(code));
        QCOMPARE(recording.error().args, args);
        QCOMPARE(exit_status(recording.error().code), 3);
        const QString sentence = QString::fromStdString(english(recording.error()));
        QVERIFY2(sentence.startsWith(QString::fromStdString(path.string())), qPrintable(sentence));
        QVERIFY2(!sentence.contains('\n') && !sentence.contains('\r') && !sentence.contains('%'),
                 qPrintable(sentence));
    }
};

VYBEG_TEST(TestBadInput)

}  // namespace test_bad_input

#include "test_bad_input.moc"
