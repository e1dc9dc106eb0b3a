#include "ui/panels/recording_facts.h"

#include "ui/words/format_text.h"

#include <QCoreApplication>
#include <QDir>
#include <QLocale>
#include <QMimeData>
#include <QUrl>

#include <algorithm>

namespace vybeg::ui {

namespace {

struct FactWords {
    Q_DECLARE_TR_FUNCTIONS(RecordingFacts)
};

QString channelText(const Recording& recording, int number) {
    const Channel& channel = recording.channels.at(static_cast<std::size_t>(number - 1));
    const QString name = QString::fromStdString(channel.name);
    // The name is omitted if the file names its channels by number.
    QString text = FactWords::tr("%1 of %2").arg(number).arg(recording.channels.size());
    if (name != QString::number(number)) {
        text = QStringLiteral("%1 (%2)").arg(name, text);
    }
    return channel.unit.empty()
               ? text
               : QStringLiteral("%1, %2").arg(text, QString::fromStdString(channel.unit));
}

QString rateText(const Recording& recording) {
    const QString hertz = QLocale().toString(recording.rate_hz, 'g', 10);
    switch (recording.rate_from) {
        case RateOrigin::file: return FactWords::tr("%1 Hz, from the file").arg(hertz);
        case RateOrigin::time_column:
            return FactWords::tr("%1 Hz, from the time column").arg(hertz);
        case RateOrigin::option: break;
    }
    return FactWords::tr("%1 Hz, typed").arg(hertz);
}

}  // namespace

QString recordingFacts(const RecordingEntry& entry) {
    QStringList lines;
    const auto add = [&lines](const QString& name, const QString& value) {
        if (!value.isEmpty()) {
            lines << QStringLiteral("%1: %2").arg(name, value);
        }
    };
    add(FactWords::tr("File"), QDir::toNativeSeparators(entry.path));
    if (entry.recording) {
        const Recording& recording = *entry.recording;
        const QLocale locale;
        add(FactWords::tr("Format"), formatText(recording.format));
        add(FactWords::tr("Rate"), rateText(recording));
        add(FactWords::tr("Length"),
            FactWords::tr("%1 s, %n sample(s)", nullptr, static_cast<int>(recording.frames()))
                .arg(locale.toString(recording.seconds(), 'g', 8)));
        add(QStringLiteral("C"), channelText(recording, recording.channel_c));
        add(QStringLiteral("D"), channelText(recording, recording.channel_d));
        add(FactWords::tr("Start"), QString::fromStdString(recording.start));
        if (entry.f0_hz) {
            add(FactWords::tr("f₀"),
                FactWords::tr("%1 Hz").arg(locale.toString(*entry.f0_hz, 'f', 4)));
        }
        add(QStringLiteral("SHA-256"), entry.sha256);
    }
    return lines.join(QLatin1Char('\n'));
}

bool hasFindings(const RecordingEntry& entry) {
    const auto isWorthAWarning = [](const Diagnostic& diagnostic) {
        return severity(diagnostic.kind) != Severity::note;
    };
    return entry.faults ? std::ranges::any_of(entry.faults->findings, isWorthAWarning)
                        : entry.recording &&
                              std::ranges::any_of(entry.recording->diagnostics, isWorthAWarning);
}

QStringList localFiles(const QMimeData& data) {
    QStringList files;
    for (const QUrl& url : data.urls()) {
        if (url.isLocalFile()) {
            files << url.toLocalFile();
        }
    }
    return files;
}

}  // namespace vybeg::ui
