#include "core/output/passport_json.h"
#include "tests/test_registry.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QtTest>

#include <cmath>
#include <limits>

namespace test_passport_json {

using namespace vybeg;

namespace {

Passport example() {
    Passport passport;
    passport.program = "vybeg-cli 1.2.3";
    passport.inputs = {{.file = "r0.wav",
                        .path = "r0.wav",
                        .sha256 = std::string(64, 'a'),
                        .start = "2020-03-20T10:00:00",
                        .seconds = 28,
                        .rate_hz = 33333,
                        .f0_hz = 5300.1}};
    passport.settings = {{"model", "auto"}, {"filter", "5200,5400"}};
    passport.model = ResonatorModel::structured;
    ResonatorEstimate& resonator = passport.resonator;
    resonator.f_mean_hz = {5300.000000001, 1e-9, {}};
    resonator.split_hz = {1.0 / 3e6, 3e-8, {}};
    resonator.tau_s = {400, 0.1, {}, 0.25};
    resonator.q = {6.6e6, 2e3, {}};
    const Reason reason{ReasonCode::one_direction, {"22.5", "28"}};
    for (Estimate* estimate :
         {&resonator.theta_w_rad, &resonator.damping_anisotropy_per_s, &resonator.theta_tau_rad,
          &resonator.angle_rate_rad_s, &resonator.kappa, &resonator.non_orthogonality_rad,
          &resonator.delay_s, &resonator.frequency_per_power}) {
        estimate->reason = reason;
    }
    ModeEstimate mode;
    mode.f_hz = {5300, 1e-7, {}};
    mode.tau_s = {401, 0.2, {}};
    mode.q.reason = {ReasonCode::no_decay, {"1", "2"}};
    passport.gyro = "HRG-17";
    passport.date = "2026-03-31";
    passport.conditions = {{"bias_v", "60"}, {"comment", "тихо"}};
    passport.modes = {mode};
    passport.mode_order = ModeOrder::decay;
    RunEstimate run;
    run.f_offset_hz = {0.01, 1e-7, {}};
    run.a_A = {1, 1e-5, {}, 0.01};
    run.a_B.reason = run.split_sin_hz.reason = run.q_envelope.reason = reason;
    run.two_theta_A_rad = {0.1, 1e-5, {}, 0.005};
    run.direction_f_hz = {5300.1, 1e-7, {}};
    run.direction_tau_s = {400.5, 1e-2, {}};
    run.drift_hz_per_s.reason = {ReasonCode::drift_not_seen, {}};
    passport.runs = {run};
    passport.raw = {{"a", "b"}, {1.5, -2e-300}, {1, 0.5, 0.5, 2}};
    passport.tracks = {{{0, 1},
                        {1, 0.9},
                        {0, 0.01},
                        {1e-5, 1e-5},
                        {0.1, 0.2},
                        {1e-5, 1e-5},
                        {5300, std::numeric_limits<double>::quiet_NaN()},
                        {1e-6, 1e-6}}};
    return passport;
}

std::string reason_of(const std::string& text) {
    const Result<Passport> read = read_passport(text, "p.json");
    if (read) {
        return "";
    }
    if (read.error().where != "p.json") {
        return "where: " + read.error().where;
    }
    return read.error().args.empty() ? "none" : english(read.error().args[0]);
}

}  // namespace

class TestPassportJson : public QObject {
    Q_OBJECT

private slots:
    void a_passport_reads_back_as_it_was() {
        const Passport passport = example();
        const std::string text = passport_json(passport);
        const Result<Passport> read = read_passport(text, "p.json");
        QVERIFY(read);
        QCOMPARE(passport_json(*read), text);
        QCOMPARE(read->program, passport.program);
        QVERIFY(read->inputs == passport.inputs);
        QVERIFY(read->settings == passport.settings);
        QCOMPARE(read->gyro, std::string("HRG-17"));
        QCOMPARE(read->date, std::string("2026-03-31"));
        QVERIFY(read->conditions == passport.conditions);
        QVERIFY(read->model == passport.model);
        QCOMPARE(read->resonator.split_hz.value, passport.resonator.split_hz.value);
        QCOMPARE(read->resonator.split_hz.sd, passport.resonator.split_hz.sd);
        QVERIFY(read->resonator.theta_w_rad.reason == passport.resonator.theta_w_rad.reason);
        QCOMPARE(read->resonator.tau_s.u, 0.25);
        QVERIFY(std::isnan(read->resonator.split_hz.u));
        QVERIFY(read->mode_order == ModeOrder::decay);
        QCOMPARE(read->runs.size(), std::size_t{1});
        QCOMPARE(read->runs[0].two_theta_A_rad.u, 0.005);
        QCOMPARE(read->runs[0].direction_tau_s.value, 400.5);
        QVERIFY(read->modes[0].q.reason == passport.modes[0].q.reason);
        QVERIFY(read->raw.values == passport.raw.values);
        QVERIFY(read->raw.covariance == passport.raw.covariance);
        QVERIFY(read->tracks[0].two_theta_A == passport.tracks[0].two_theta_A);
        QVERIFY(std::isnan(read->tracks[0].f_hz[1]));
    }

    void a_file_without_gyro_is_read() {
        QJsonObject old =
            QJsonDocument::fromJson(QByteArray::fromStdString(passport_json(example()))).object();
        for (const char* name : {"gyro", "date", "conditions"}) {
            old.remove(QLatin1String(name));
        }
        const Result<Passport> read =
            read_passport(QJsonDocument(old).toJson().toStdString(), "p.json");
        QVERIFY(read);
        QVERIFY(read->gyro.empty() && read->date.empty() && read->conditions.empty());
    }

    void it_is_json_for_everyone() {
        const QJsonObject json =
            QJsonDocument::fromJson(QByteArray::fromStdString(passport_json(example()))).object();
        QCOMPARE(json["schema"].toInt(), 2);
        QCOMPARE(json["vybeg"].toString(), QString("passport"));
        const QJsonObject axis = json["resonator"]["theta_w_rad"].toObject();
        QVERIFY(axis["value"].isNull());
        QVERIFY(axis["reason"].toString().endsWith('.'));
        QCOMPARE(json["settings"]["filter"].toString(), QString("5200,5400"));
    }

    void what_is_wrong_is_said_data() {
        QTest::addColumn<QString>("from");
        QTest::addColumn<QString>("to");
        QTest::addColumn<QString>("part");
        const auto row = [](const char* name, const char* from, const char* to, const char* part) {
            QTest::newRow(name) << from << to << part;
        };
        row("no JSON", "\"schema\"", "schema", "no JSON at byte");
        row("another file", "\"passport\"", "\"session\"", "not a passport's");
        row("a result", "\"vybeg\": \"passport\",", "\"modes_by\": \"frequency\",",
            "it is a result of identify; --passport writes the passport");
        row("schema of nothing", "\"schema\": 2", "\"schema\": 0",
            "schema: a positive number is expected, and 0 is there");
        row("schema of an early version", "\"schema\": 2", "\"schema\": 1",
            "its schema 1 is that of an early version");
        row("schema as text", "\"schema\": 2", "\"schema\": \"2\"",
            "schema: a whole number is expected, and \"2\" is there");
        row("member missing", "\"program\"", "\"programme\"", "program is missing");
        row("unknown model", "\"structured\"", "\"rigid\"",
            "model: structured or free is expected, and \"rigid\" is there");
        row("unknown reason", "one-direction", "no-direction", "no-direction");
        row("deviation below zero", "\"sd\": 0.1", "\"sd\": -0.1", "negative");
        row("uncertainty below zero", "\"u\": 0.25", "\"u\": -0.25", "negative");
        row("modes by colour", "\"decay\"", "\"colour\"", "\"colour\"");
        row("runs missing", "\"runs\"", "\"rums\"", "runs");
        row("value as text", "\"value\": 400.0", "\"value\": \"400\"",
            ".value: a number is expected, and \"400\" is there");
        row("half a covariance", "\"names\": [", "\"names\": [\"c\",", "parameters.values: a list");
        row("half a track", "\"a_A\": [", "\"a_A\": [3,", "tracks[0].a_A: a list as long");
    }

    void what_is_wrong_is_said() {
        QFETCH(QString, from);
        QFETCH(QString, to);
        QFETCH(QString, part);
        QString text = QString::fromStdString(passport_json(example()));
        QVERIFY(text.contains(from));
        text.replace(from, to);
        const QString reason = QString::fromStdString(reason_of(text.toStdString()));
        QVERIFY2(reason.contains(part), qPrintable(reason));
        QVERIFY2(!reason.contains('\n') && !reason.contains("exception"), qPrintable(reason));
    }

    void a_newer_schema_is_told_apart() {
        QString text = QString::fromStdString(passport_json(example()));
        text.replace("\"schema\": 2", "\"schema\": 3");
        const Result<Passport> read = read_passport(text.toStdString(), "p.json");
        QVERIFY(!read);
        QVERIFY(read.error() == (Error{ErrorCode::passport_schema, "p.json", {"3", "2"}}));
    }

    void a_cut_passport_is_an_error_wherever_it_ends() {
        const std::string text = passport_json(example());
        for (std::size_t length = 0; length + 2 < text.size(); length += 7) {
            QVERIFY(!read_passport(std::string_view(text).substr(0, length), "p.json"));
        }
    }

    void deep_nesting_is_no_way_in() {
        QVERIFY(!read_passport(std::string(5'000'000, '['), "p.json"));
        QVERIFY(!read_passport("{\"vybeg\": \"passport\", \"schema\": 1e999}", "p.json"));
    }

    void files_are_read_or_refused_with_a_reason() {
        const QTemporaryDir folder;
        const auto path = [&](const char* name) {
            return std::filesystem::path(folder.filePath(name).toStdString());
        };
        QVERIFY(read_passport_file(path("none")).error().code == ErrorCode::file_missing);
        QVERIFY(read_passport_file(path("")).error().code == ErrorCode::file_is_directory);
        QFile file(folder.filePath("p.json"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(QByteArray::fromStdString(passport_json(example())));
        file.close();
        QVERIFY(read_passport_file(path("p.json")));
        QVERIFY(file.resize((qint64{1} << 26) + 1));
        QVERIFY(read_passport_file(path("p.json")).error().code == ErrorCode::format_limit);
    }
};

VYBEG_TEST(TestPassportJson)

}  // namespace test_passport_json

#include "test_passport_json.moc"
