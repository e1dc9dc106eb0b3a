#include "tests/tools/pictures/pictured_batch.h"

#include "ui/batch/batch_window.h"
#include "ui/document/document.h"
#include "ui/window/main_window.h"

#include <QAction>
#include <QDir>
#include <QFile>
#include <QPushButton>

#include <stdexcept>

namespace vybeg::test {

namespace {

using namespace vybeg::ui;

QByteArray row(const QString& set, int day, const QString& recording, const QString& from) {
    return QStringLiteral("%1,HRG-17,\"%2\",2026-03-%3,%4\n")
        .arg(set, recording, QString::number(day), from)
        .toUtf8();
}

QByteArray list_of(const QStringList& recordings) {
    QByteArray list = "set,gyro,file,date,from\n";
    int day = 11;
    for (const char* const from : {"", "2", "4", "6"}) {
        const QString set = QStringLiteral("from %1 s").arg(QLatin1String(*from ? from : "0"));
        for (const QString& recording : recordings) {
            list += row(set, day, recording, QLatin1String(from));
        }
        ++day;
    }
    list += row(QStringLiteral("lost"), day, QStringLiteral("HRG-17_lost.wav"), {});
    for (qsizetype k = 0; k < recordings.size(); ++k) {
        list += row(QStringLiteral("run %1").arg(k + 1), ++day, recordings[k], {});
    }
    return list;
}

}  // namespace

void start_pictured_batch(MainWindow& window, const QStringList& recordings) {
    const QString list = QStringLiteral("campaign.csv");
    const QString passports = QStringLiteral("passports");
    QFile file(list);
    if (!file.open(QIODevice::WriteOnly) || file.write(list_of(recordings)) < 0 ||
        !QDir().mkpath(passports)) {
        throw std::runtime_error(file.errorString().toStdString());
    }
    file.close();
    window.action(Command::batch)->trigger();
    auto& batch = *window.findChild<BatchWindow*>();
    batch.form().setPath(BatchPath::list, list);
    batch.form().setPath(BatchPath::results, QStringLiteral("campaign_results.csv"));
    batch.form().setPath(BatchPath::passports, passports);
    window.document().sets().savePassport(
        QDir(passports).filePath(QStringLiteral("HRG-17.json")), {}, [&batch](const Status&) {
            batch.findChild<QPushButton*>(QStringLiteral("batchStart"))->click();
        });
}

}  // namespace vybeg::test
