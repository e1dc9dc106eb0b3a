#include "ui/history/history_database.h"

#include "core/analysis/list_fields.h"
#include "core/analysis/measurement_list.h"
#include "core/analysis/setting_table.h"
#include "core/base/error.h"
#include "core/output/identify_json.h"
#include "ui/resonator/set_panel.h"
#include "ui/widgets/page_parts.h"

#include <QComboBox>
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

namespace {

// The settings of each recording; those that differ stand side by side in one text.
std::optional<std::vector<IdentifySettings>> settingsOf(const StoredResult& result) {
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
    return settings.isEmpty() ? std::nullopt : std::optional(std::move(each));
}

}  // namespace

StoredSet storedSet(const StoredResult& result, const IdentifySettings& otherwise) {
    StoredSet stored;
    MeasurementSet set;
    set.name = result.set;
    const auto settings = settingsOf(result);
    stored.settings_known = settings.has_value();
    set.settings = settings && !settings->empty() ? settings->front() : otherwise;
    for (std::size_t k = 0; k < result.recordings.size(); ++k) {
        const RecordingRef& each = result.recordings[k];
        const QString path = QString::fromStdU16String(each.path.u16string());
        if (!QFileInfo(path).isFile()) {
            stored.missing << path;
            continue;
        }
        set.recordings.push_back(each);
        set.settings.of_recordings.push_back(settings ? (*settings)[k].signal : otherwise.signal);
    }
    if (!set.recordings.empty()) {
        stored.list.sets.push_back(std::move(set));
    }
    return stored;
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
    return ResultsDatabase::open(path.toStdU16String(), access, job, patience_s, tell);
}

}  // namespace

void makeDatabase(BackgroundJobs& job, int key, Document& document, const QString& path,
                  Done<bool> done) {
    job.run<bool>(
        key,
        [&document, path](const JobControl& control) -> Result<bool> {
            const auto database = opened(document, path, ResultsDatabase::Access::write, control);
            return database ? Result<bool>(true) : database.error();
        },
        std::move(done));
}

void readHistory(BackgroundJobs& job, int key, Document& document, const QString& path,
                 const std::optional<std::string>& gyro, const std::string& parameter,
                 Done<StoredHistory> done) {
    job.run<StoredHistory>(
        key,
        [&document, path, gyro, parameter](const JobControl& control) -> Result<StoredHistory> {
            auto database = TRY(opened(document, path, ResultsDatabase::Access::read, control));
            auto gyros = database.gyros();
            auto points = TRY(gyros ? database.history(gyro, parameter)
                                    : Result<std::vector<HistoryPoint>>(gyros.error()));
            return StoredHistory{std::move(*gyros), std::move(points)};
        },
        std::move(done));
}

void readResult(BackgroundJobs& job, int key, Document& document, const QString& path,
                std::int64_t id, Done<StoredResult> done) {
    job.run<StoredResult>(
        key,
        [&document, path, id](const JobControl& control) -> Result<StoredResult> {
            auto database = opened(document, path, ResultsDatabase::Access::read, control);
            auto found = TRY(database ? database->result(id)
                                      : Result<std::optional<StoredResult>>(database.error()));
            if (!found) {  // another file has taken its place
                return Error{ErrorCode::file_read_failed,
                             path.toStdString(),
                             {words(VYBEG_MESSAGE("Words", "the result is not there any more"))}};
            }
            return std::move(*found);
        },
        std::move(done));
}

namespace {

// As `vybeg-cli batch --database` does. `done` gets the name of the earlier result that it
// replaces.
void storeResult(BackgroundJobs& job, int key, Document& document, const QString& path,
                 SetResult result, Done<std::optional<StoredName>> done) {
    job.run<std::optional<StoredName>>(
        key,
        [&document, path, result = std::move(result)](
            const JobControl& control) -> Result<std::optional<StoredName>> {
            const auto stored = TRY(stored_result(result, identify_json(result)));
            auto database = TRY(opened(document, path, ResultsDatabase::Access::write, control));
            const auto known = database.holder(stored.key);
            const Result<std::int64_t> id = known ? database.add(stored) : known.error();
            return id ? known : id.error();
        },
        std::move(done));
}

}  // namespace

StoreDialog::StoreDialog(const QStringList& gyros, const QString& gyro, const QString& date,
                         QWidget* parent)
    : QDialog(parent),
      gyro_(withName(new QComboBox(this), "storeGyro")),
      date_(withName(new QLineEdit(date, this), "storeDate")),
      fault_(new QLabel(this)),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this)) {
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Add this result"));
    gyro_->setEditable(true);
    gyro_->addItems(gyros);
    gyro_->setCurrentText(gyro);
    setWords(*gyro_, tr("Gyro"), tr("The name under which the history of this resonator is kept"));
    setWords(*date_, tr("Date"),
             tr("Of the recordings, as in 2026-03-31, with or without a time as in T14:05"));
    fault_->setWordWrap(true);
    buttons_->button(QDialogButtonBox::Ok)->setText(tr("Add"));
    buttons_->button(QDialogButtonBox::Cancel)->setText(tr("Cancel"));
    auto* form = new QFormLayout(this);
    form->addRow(tr("Gyro"), gyro_);
    form->addRow(tr("Date"), date_);
    form->addRow(fault_);
    form->addRow(buttons_);
    connect(gyro_, &QComboBox::editTextChanged, this, &StoreDialog::refresh);
    connect(date_, &QLineEdit::textChanged, this, &StoreDialog::refresh);
    connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(buttons_, &QDialogButtonBox::accepted, this, [this] {
        emit chosen(gyro_->currentText().trimmed(), date_->text().trimmed());
        accept();
    });
    setMinimumWidth(380);
    refresh();
}

void StoreDialog::refresh() {
    const QString date = date_->text().trimmed();
    const bool dated = date.isEmpty() || is_iso_date(date.toStdString());
    const bool named = !gyro_->currentText().trimmed().isEmpty();
    fault_->setText(!named ? tr("A result without a gyro has no history: name one.")
                    : !dated
                        ? tr("A date is written as in 2026-03-31, with or without a time as in "
                             "T14:05.")
                    : date.isEmpty() ? tr("Without a date the result stands behind all others.")
                                     : QString());
    buttons_->button(QDialogButtonBox::Ok)->setEnabled(named && dated);
}

namespace {

constexpr int storing_job = 1;

// The set under this gyro and date, for the whole of it.
void tellGyroAndDate(MeasurementSet& set, const std::string& gyro, const std::string& date) {
    for (RecordingRef& recording : set.recordings) {
        recording.conditions.gyro = gyro;
        if (!date.empty()) {
            recording.conditions.date = date;
        }
    }
}

}  // namespace

std::shared_ptr<const ResonatorOutcome> ResultAdder::addable() const {
    const RecordingSet* set = document_.sets().current();
    const auto outcome = set ? document_.sets().outcome(*set) : nullptr;
    return outcome && !document_.sets().outOfDate(*set, *outcome) ? outcome : nullptr;
}

void ResultAdder::ask(const QString& path, const QStringList& gyros, QWidget* window) {
    const RecordingSet* set = document_.sets().current();
    const auto outcome = addable();
    if (!set || !outcome) {
        return;
    }
    const MeasurementSet measured = document_.sets().underPresentConditions(*set, *outcome).set;
    QString gyro = QString::fromStdString(gyro_of(measured));
    gyro = gyro.isEmpty() ? document_.dossier().dossier().gyro.serial : gyro;
    gyro = gyro.isEmpty() ? set->name : gyro;
    auto* dialog =
        new StoreDialog(gyros, gyro, QString::fromStdString(date_of(measured).text), window);
    connect(dialog, &StoreDialog::chosen, this,
            [this, path](const QString& named, const QString& date) { add(path, named, date); });
    dialog->open();
}

void ResultAdder::add(const QString& path, const QString& gyro, const QString& date) {
    const RecordingSet* set = document_.sets().current();
    const auto outcome = addable();
    if (!outcome) {
        return;
    }
    SetResult result = document_.sets().underPresentConditions(*set, *outcome);
    result.set.name = setName(document_, *set).toStdString();
    tellGyroAndDate(result.set, gyro.toStdString(), date.toStdString());
    storeResult(
        job_, storing_job, document_, path, std::move(result),
        [this, path, gyro](const Result<std::optional<StoredName>>& replaced) {
            if (!replaced) {
                document_.report(errorMessage(replaced.error()));
                return;
            }
            const auto text = [gyro, name = QFileInfo(path).fileName(), replaced = *replaced] {
                return replaced ? tr("The result of %1 replaces that of %3 (set %4) in %2: "
                                     "the same recordings and settings.")
                                      .arg(gyro, name, QString::fromStdString(replaced->gyro),
                                           QString::fromStdString(replaced->set))
                                : tr("The result of %1 is in %2.").arg(gyro, name);
            };
            document_.report({MessageLevel::info, text, {}, {}});
            emit added(path);
        });
}

}  // namespace vybeg::ui
