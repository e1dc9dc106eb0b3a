#include "core/output/identify_json.h"
#include "tests/test_registry.h"

#include <QtTest>

namespace test_recording_json {

using namespace vybeg;

namespace {

class Silence : public SampleSource {
public:
    std::int64_t frames() const override { return 1000; }
    Status read(std::int64_t, std::span<double>, std::span<double>) const override { return {}; }
};

}  // namespace

class TestRecordingJson : public QObject {
    Q_OBJECT

private slots:
    void it_has_the_members_of_the_interface() {
        Recording recording;
        recording.format = {FormatPart::name("WAV"), FormatPart::name("\"quoted\"")};
        recording.rate_hz = 400.5;
        recording.rate_from = RateOrigin::time_column;
        recording.channels = {{"C", "V"}, {"D", ""}};
        recording.start = "2020-03-20T10:00:00";
        recording.diagnostics = {{DiagnosticKind::time_gap, {"7", "0.5"}, 200, 7}};
        recording.source = std::make_shared<Silence>();
        const QJsonObject expected{
            {"format", "WAV, \"quoted\""},
            {"frames", 1000},
            {"seconds", 1000 / 400.5},
            {"rate_hz", 400.5},
            {"rate_from", "time column"},
            {"channels", QJsonArray{QJsonObject{{"name", "C"}, {"unit", "V"}},
                                    QJsonObject{{"name", "D"}, {"unit", ""}}}},
            {"start", "2020-03-20T10:00:00"},
            {"sha256", "0123"},
            {"check",
             QJsonArray{QJsonObject{
                 {"kind", "time-gap"},
                 {"severity", "warning"},
                 {"first_frame", 200},
                 {"count", 7},
                 {"text", "7 samples are missing at 0.5 s; windows over them are flagged."}}}}};
        const QByteArray json =
            QByteArray::fromStdString(recording_json(recording, "0123", recording.diagnostics));
        QJsonParseError error;
        QCOMPARE(QJsonDocument::fromJson(json, &error).object(), expected);
        QCOMPARE(error.error, QJsonParseError::NoError);
        QVERIFY(json.endsWith("}\n"));
    }

    void what_the_digits_leave_open_of_the_rate_is_a_member_of_its_own() {
        Recording recording;
        recording.rate_hz = 33333;
        recording.rate_relative_sd = 2.5e-6;
        recording.source = std::make_shared<Silence>();
        const QByteArray json = QByteArray::fromStdString(recording_json(recording, "", {}));
        const QJsonObject info = QJsonDocument::fromJson(json).object();
        QCOMPARE(info["rate_relative_sd"].toDouble(), 2.5e-6);
        QCOMPARE(info["rate_hz"].toDouble(), 33333.0);
    }

    void a_rate_of_times_has_the_digits_that_times_can_show() {
        Recording recording;
        recording.rate_hz = 33332.99999999999;
        recording.source = std::make_shared<Silence>();
        for (const auto& [origin, expected] :
             {std::pair{RateOrigin::time_column, 33333.0}, {RateOrigin::file, 33332.99999999999}}) {
            recording.rate_from = origin;
            const QByteArray json = QByteArray::fromStdString(recording_json(recording, "", {}));
            const QJsonObject info = QJsonDocument::fromJson(json).object();
            QCOMPARE(info["rate_hz"].toDouble() - expected, 0.0);
        }
    }

    void names_that_are_no_utf_8_are_replaced() {
        Recording recording;
        recording.rate_hz = 1;
        recording.channels = {{"\xff\xfe", ""}};
        recording.source = std::make_shared<Silence>();
        const QByteArray json = QByteArray::fromStdString(recording_json(recording, "", {}));
        QVERIFY(!QJsonDocument::fromJson(json).isNull());
    }
};

VYBEG_TEST(TestRecordingJson)

}  // namespace test_recording_json

#include "test_recording_json.moc"
