#include "ui/document/kept_result.h"

#include "core/output/identify_json.h"
#include "core/output/passport_json.h"
#include "core/output/stored_reason.h"
#include "ui/words/program_name.h"

#include <QJsonArray>
#include <QJsonDocument>

#include <cmath>
#include <limits>

namespace vybeg::ui {

namespace {

const QString passport_key = QStringLiteral("passport");
const QString no_modes_key = QStringLiteral("no_modes");
const QString chi2_key = QStringLiteral("chi2_per_dof");
const QString runs_key = QStringLiteral("runs");
const QString warnings_key = QStringLiteral("warnings");
const QString kind_key = QStringLiteral("kind");
const QString args_key = QStringLiteral("args");
const QString input_key = QStringLiteral("input");
const QString window_key = QStringLiteral("window");
const QString windows_key = QStringLiteral("windows");
const QString windows_used_key = QStringLiteral("windows_used");
const QString noise_key = QStringLiteral("noise_sd");

QJsonValue numberToJson(double value) {
    return std::isfinite(value) ? QJsonValue(value) : QJsonValue();
}

double numberFromJson(const QJsonValue& value) {
    return value.toDouble(std::numeric_limits<double>::quiet_NaN());
}

QJsonObject runToJson(const IdentifiedRun& run) {
    return {{window_key, static_cast<qint64>(run.window)},
            {windows_key, static_cast<qint64>(run.windows)},
            {windows_used_key, static_cast<qint64>(run.windows_used)},
            {noise_key, numberToJson(run.noise_sd)}};
}

IdentifiedRun runFromJson(const QJsonObject& json) {
    IdentifiedRun run;
    run.window = json[window_key].toInteger();
    run.windows = json[windows_key].toInteger();
    run.windows_used = json[windows_used_key].toInteger();
    run.noise_sd = numberFromJson(json[noise_key]);
    return run;
}

QJsonArray argsToJson(const std::vector<MessageArg>& args) {
    QJsonArray json;
    for (const MessageArg& arg : args) {
        json.append(QString::fromStdString(english(arg)));
    }
    return json;
}

std::vector<std::string> argsFromJson(const QJsonValue& json) {
    std::vector<std::string> args;
    for (const auto& arg : json.toArray()) {
        args.push_back(arg.toString().toStdString());
    }
    return args;
}

QJsonObject reasonToJson(const Reason& reason) {
    return {{kind_key, QString::fromStdString(reason_name(reason.code))},
            {args_key, argsToJson(reason.args)}};
}

Reason reasonFromJson(const QJsonObject& json) {
    return stored_reason(json[kind_key].toString().toStdString(), argsFromJson(json[args_key]))
        .value_or(Reason{});
}

QJsonObject warningToJson(const IdentifyWarning& warning) {
    return {{kind_key, QString::fromStdString(kind_name(warning.diagnostic.kind))},
            {args_key, argsToJson(warning.diagnostic.args)},
            {input_key, warning.input}};
}

// A warning of a later version, whose words are not known here, is left out.
void addWarning(const QJsonObject& json, Identification& identification) {
    const auto warning =
        stored_diagnostic(json[kind_key].toString().toStdString(), argsFromJson(json[args_key]));
    const int input = json[input_key].toInt(-1);
    if (!warning || input >= static_cast<int>(identification.runs.size())) {
        return;
    }
    auto& list = input < 0 ? identification.fit.warnings
                           : identification.runs[static_cast<std::size_t>(input)].diagnostics;
    list.push_back(*warning);
}

}  // namespace

QJsonObject keptResult(const ResonatorOutcome& outcome) {
    Passport passport =
        passport_of(programName().toStdString(), outcome.inputs, outcome.identification, {});
    for (RunTrack& track : passport.tracks) {
        track = {};
    }
    QJsonArray runs;
    for (const IdentifiedRun& run : outcome.identification.runs) {
        runs.append(runToJson(run));
    }
    QJsonArray warnings;
    for (const IdentifyWarning& warning : all_warnings(outcome.identification)) {
        warnings.append(warningToJson(warning));
    }
    const QByteArray text = QByteArray::fromStdString(passport_json(passport));
    return {{passport_key, QJsonDocument::fromJson(text).object()},
            {no_modes_key, reasonToJson(outcome.identification.fit.no_modes)},
            {chi2_key, numberToJson(outcome.identification.fit.chi2_per_dof)},
            {runs_key, runs},
            {warnings_key, warnings}};
}

Result<ReadResult> readKeptResult(const QJsonObject& json) {
    const QByteArray text =
        QJsonDocument(json[passport_key].toObject()).toJson(QJsonDocument::Compact);
    auto passport = TRY(read_passport(text.toStdString(), {}));
    ReadResult read;
    read.program = QString::fromStdString(passport.program);
    read.outcome.inputs = std::move(passport.inputs);
    Identification& identification = read.outcome.identification;
    ResonatorFit& fit = identification.fit;
    fit.model = passport.model;
    fit.resonator = passport.resonator;
    fit.modes = std::move(passport.modes);
    fit.mode_order = passport.mode_order.value_or(ModeOrder::frequency);
    fit.runs = std::move(passport.runs);
    fit.raw = std::move(passport.raw);
    fit.no_modes = reasonFromJson(json[no_modes_key].toObject());
    fit.chi2_per_dof = numberFromJson(json[chi2_key]);
    const QJsonArray runs = json[runs_key].toArray();
    fit.runs.resize(read.outcome.inputs.size());
    for (qsizetype k = 0; k < static_cast<qsizetype>(read.outcome.inputs.size()); ++k) {
        identification.runs.push_back(runFromJson(runs.at(k).toObject()));
    }
    for (const auto& warning : json[warnings_key].toArray()) {
        addWarning(warning.toObject(), identification);
    }
    return read;
}

}  // namespace vybeg::ui
