#include "ui/history/history_database.h"

#include "core/analysis/list_fields.h"
#include "core/analysis/measurement_list.h"
#include "core/analysis/setting_table.h"
#include "core/base/error.h"
#include "core/output/identify_json.h"
#include "ui/resonator/set_panel.h"
#include "ui/widgets/page_parts.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include <iterator>
#include <optional>
#include <utility>

namespace vybeg::ui {

// One text joins those in which the recordings differ.
std::optional<IdentifySettings> settingsOf(const StoredResult& result) {
    const QJsonObject json =
        QJsonDocument::fromJson(QByteArray::fromStdString(result.json)).object();
    const QJsonObject settings = json[QStringLiteral("settings")].toObject();
    const IdentifySettings defaults;
    std::vector<IdentifySettings> each(result.recordings.size());
    for (const SettingRow<IdentifySettings>& row : identify_settings()) {
        const QJsonValue value = settings[QString::fromStdString(row.name)];
        const QStringList parts = value.toString().split(QStringLiteral("; "));
        for (std::size_t k = 0; value.isString() && k < each.size(); ++k) {
            const bool differ = each.size() > 1 && parts.size() == std::ssize(each);
            const std::string text =
                (differ ? parts[static_cast<qsizetype>(k)] : value.toString()).toStdString();
            if (text != row.text(defaults) && !row.read(text, each[k])) {
                return std::nullopt;
            }
        }
    }
    if (settings.isEmpty() || each.empty()) {
        return std::nullopt;
    }
    IdentifySettings whole = each.front();
    for (const IdentifySettings& of_one : each) {
        whole.of_recordings.push_back(of_one.signal);
    }
    return whole;
}

QStringList leaveOutMissing(MeasurementSet& set) {
    QStringList missing;
    leave_out(set, [&missing](const RecordingRef& recording) {
        const QString path = pathText(recording);
        const bool there = QFileInfo(path).isFile();
        missing << (there ? QStringList() : QStringList(path));
        return !there;
    });
    return missing;
}

namespace {

// While another program writes, a reader waits no longer than a person does.
constexpr double patience_s = 20;

Result<ResultsDatabase> opened(Document& document, const QString& path,
                               ResultsDatabase::Access access, const JobControl& job) {
    const auto tell = [&document](const Diagnostic& waiting) {
        QMetaObject::invokeMethod(
            &document,
            [&document, waiting] {
                for (const Message& message : warningMessages({}, {waiting})) {
                    document.report(message);
                }
            },
            Qt::QueuedConnection);
    };
    return ResultsDatabase::open(path.toStdU16String(), access, job, tell, patience_s);
}

template <class Value>
void inDatabase(const DatabaseJob& job, ResultsDatabase::Access access,
                std::function<Result<Value>(ResultsDatabase&)> work, Done<Value> done) {
    job.jobs.run<Value>(
        job.key,
        [&document = job.document, path = job.path, access,
         work = std::move(work)](const JobControl& control) -> Result<Value> {
            auto database = TRY(opened(document, path, access, control));
            return work(database);
        },
        std::move(done));
}

}  // namespace

void makeDatabase(const DatabaseJob& job, Done<bool> done) {
    inDatabase<bool>(
        job, ResultsDatabase::Access::write, [](ResultsDatabase&) { return true; },
        std::move(done));
}

void readHistory(const DatabaseJob& job, const std::optional<std::string>& gyro,
                 const std::string& parameter, Done<StoredHistory> done) {
    inDatabase<StoredHistory>(
        job, ResultsDatabase::Access::read,
        [path = job.path, gyro, parameter](ResultsDatabase& database) -> Result<StoredHistory> {
            const QDateTime written = QFileInfo(path).lastModified();
            auto gyros = TRY(database.gyros());
            auto points = TRY(database.history(gyro, parameter));
            return StoredHistory{std::move(gyros), std::move(points), written};
        },
        std::move(done));
}

void readResult(const DatabaseJob& job, std::int64_t id, Done<StoredResult> done) {
    inDatabase<StoredResult>(
        job, ResultsDatabase::Access::read,
        [path = job.path, id](ResultsDatabase& database) -> Result<StoredResult> {
            auto found = TRY(database.result(id));
            if (!found) {  // another file has taken its place
                return Error{ErrorCode::file_read_failed,
                             path.toStdString(),
                             {Phrase::tr("the result is not there any more")}};
            }
            return std::move(*found);
        },
        std::move(done));
}

namespace {

struct StoreWords {
    Q_DECLARE_TR_FUNCTIONS(Store)
};

// The date is ISO 8601 or empty; typed, also as tables write it, usual_date().
void askForGyroAndDate(const QStringList& gyros, const QString& gyro, const QString& date,
                       QWidget* window,
                       const std::function<void(const QString&, const QString&)>& then) {
    auto* dialog = new QDialog(window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(StoreWords::tr("Add this result"));
    dialog->setMinimumWidth(380);
    auto* named = withName(new QComboBox(dialog), "storeGyro");
    named->setEditable(true);
    named->addItems(gyros);
    named->setCurrentText(gyro);
    auto* dated = withName(new QLineEdit(date, dialog), "storeDate");
    auto* fault = new QLabel(dialog);
    fault->setWordWrap(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, dialog);
    QPushButton* ok = buttons->button(QDialogButtonBox::Ok);
    ok->setText(StoreWords::tr("Add"));
    buttons->button(QDialogButtonBox::Cancel)->setText(StoreWords::tr("Cancel"));
    auto* form = new QFormLayout(dialog);
    addRow(*form, StoreWords::tr("Gyro"), named,
           StoreWords::tr("The name under which the history of this resonator is kept"));
    addRow(
        *form, StoreWords::tr("Date"), dated,
        StoreWords::tr("Of the recordings, as in 31.03.2026 or 2026-03-31, with or without a time "
                       "as in 14:05"));
    form->addRow(fault);
    form->addRow(buttons);
    const auto date_typed = [dated] {
        return QString::fromStdString(usual_date(dated->text().simplified().toStdString()));
    };
    const auto check = [named, date_typed, fault, ok] {
        const QString at = date_typed();
        const bool has_name = !named->currentText().trimmed().isEmpty();
        const bool has_date = at.isEmpty() || is_iso_date(at.toStdString());
        fault->setText(
            !has_name   ? StoreWords::tr("A result without a gyro has no history: name one.")
            : !has_date ? StoreWords::tr(
                              "A date is written as in 31.03.2026 or 2026-03-31, with or without "
                              "a time as in 14:05.")
            : at.isEmpty() ? StoreWords::tr("Without a date the result stands behind all others.")
                           : QString());
        ok->setEnabled(has_name && has_date);
    };
    QObject::connect(named, &QComboBox::editTextChanged, dialog, check);
    QObject::connect(dated, &QLineEdit::textChanged, dialog, check);
    QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
    QObject::connect(buttons, &QDialogButtonBox::accepted, dialog,
                     [dialog, named, date_typed, then] {
                         then(named->currentText().trimmed(), date_typed());
                         dialog->accept();
                     });
    check();
    dialog->open();
}

// Under this gyro and date, for the whole of the set, as `vybeg-cli batch --database` does.
void storeUnder(const DatabaseJob& job, const QString& gyro, const QString& date,
                const std::function<void()>& added) {
    const SetStore& sets = job.document.sets();
    const auto outcome = addableResult(job.document);
    if (!outcome) {
        return;
    }
    SetResult result = sets.underPresentConditions(*sets.current(), *outcome);
    result.set.name = setName(job.document, *sets.current()).toStdString();
    for (RecordingRef& recording : result.set.recordings) {
        recording.conditions.gyro = gyro.toStdString();
        if (!date.isEmpty()) {
            recording.conditions.date = date.toStdString();
        }
    }
    inDatabase<AddedResult>(
        job, ResultsDatabase::Access::write,
        [result = std::move(result)](ResultsDatabase& database) -> Result<AddedResult> {
            const auto stored = TRY(stored_result(result, identify_json(result)));
            return database.add(stored);
        },
        [&document = job.document, name = QFileInfo(job.path).fileName(), gyro,
         added](const Result<AddedResult>& done) {
            if (!done) {
                document.report(errorMessage(done.error()));
                return;
            }
            const auto text = [gyro, name, replaced = done->replaced] {
                return replaced ? StoreWords::tr(
                                      "The result of %1 replaces that of %3 (set %4) in %2: "
                                      "the same recordings and settings.")
                                      .arg(gyro, name, QString::fromStdString(replaced->gyro),
                                           QString::fromStdString(replaced->set))
                                : StoreWords::tr("The result of %1 is in %2.").arg(gyro, name);
            };
            document.report({MessageLevel::info, text});
            added();
        });
}

}  // namespace

std::shared_ptr<const SetResult> addableResult(const Document& document) {
    const RecordingSet* set = document.sets().current();
    const auto outcome = set ? document.sets().outcome(*set) : nullptr;
    return outcome && !document.sets().outOfDate(*set, *outcome) ? outcome : nullptr;
}

void askToAdd(const DatabaseJob& job, const QStringList& gyros, QWidget* window,
              const std::function<void()>& added) {
    const auto outcome = addableResult(job.document);
    if (!outcome) {
        return;
    }
    const RecordingSet& set = *job.document.sets().current();
    const MeasurementSet measured = job.document.sets().underPresentConditions(set, *outcome).set;
    QString gyro = QString::fromStdString(gyro_of(measured));
    gyro = gyro.isEmpty() ? job.document.dossier().dossier().gyro.serial : gyro;
    gyro = gyro.isEmpty() ? set.name : gyro;
    askForGyroAndDate(gyros, gyro, QString::fromStdString(date_of(measured).text), window,
                      [job, added](const QString& named, const QString& date) {
                          storeUnder(job, named, date, added);
                      });
}

}  // namespace vybeg::ui
