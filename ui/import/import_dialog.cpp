#include "ui/import/import_dialog.h"

#include "core/recording/samples/partner_file.h"
#include "ui/import/import_preview.h"
#include "ui/values/json_fields.h"
#include "ui/widgets/page_parts.h"

#include <QDialogButtonBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QJsonArray>
#include <QJsonDocument>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QStringList>
#include <QVBoxLayout>

#include <utility>

namespace vybeg::ui {

namespace {

constexpr qsizetype most_kinds = 50;
const QString imports_key = QStringLiteral("imports");
const QString kind_key = QStringLiteral("kind");
const QString options_key = QStringLiteral("options");

QJsonArray imports() {
    return QJsonDocument::fromJson(QSettings().value(imports_key).toByteArray()).array();
}

}  // namespace

QString importKind(const QString& path, const RecordingPreview& preview, bool raw) {
    const QString ending = QFileInfo(path).suffix().toLower();
    if (raw) {
        return QStringLiteral("raw;%1").arg(ending);
    }
    if (!preview.guessed) {
        return QStringLiteral("file;%1").arg(ending);
    }
    QStringList words{QStringLiteral("text"), ending, QString::number(preview.guessed->columns)};
    for (const Channel& heading : preview.guessed->headings) {
        words << QString::fromStdString(heading.name);
    }
    return words.join(QLatin1Char(';'));
}

std::optional<OpenOptions> rememberedImport(const QString& kind) {
    for (const QJsonValue& each : imports()) {
        if (each[kind_key].toString() == kind) {
            return optionsFromJson(each[options_key].toObject());
        }
    }
    return {};
}

void rememberImport(const QString& kind, const OpenOptions& options) {
    QJsonArray kept{QJsonObject{{kind_key, kind}, {options_key, optionsToJson(options)}}};
    for (const QJsonValue& each : imports()) {
        if (each[kind_key].toString() != kind && kept.size() < most_kinds) {
            kept.append(each);
        }
    }
    QSettings().setValue(imports_key, QJsonDocument(kept).toJson(QJsonDocument::Compact));
}

namespace {

constexpr int preview_key = 0;

}  // namespace

ImportDialog::ImportDialog(BackgroundJobs& job, const QString& path, const OpenOptions& options,
                           QWidget* parent)
    : QDialog(parent),
      job_(&job),
      path_(path),
      proposed_(options != OpenOptions{}),
      raw_proposed_(options.raw.has_value()),
      fields_(new ImportFields),
      view_(new ImportPreview(this)),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel, this)) {
    setAttribute(Qt::WA_DeleteOnClose);
    auto* title = new QLabel(this);
    title->setTextFormat(Qt::PlainText);
    title->setWordWrap(true);
    fields_->setOptions(options);
    auto* choices = scrolled(fields_, this);
    choices->setFocusPolicy(Qt::NoFocus);
    auto* columns = fill(new QHBoxLayout, {choices, {view_, 1}});
    fill(new QVBoxLayout(this), {title, {columns, 1}, buttons_});
    connect(buttons_, &QDialogButtonBox::accepted, this, &ImportDialog::accept);
    connect(buttons_, &QDialogButtonBox::rejected, this, &ImportDialog::reject);
    connect(fields_, &ImportFields::filesWanted, this, &ImportDialog::filesWanted);
    connect(fields_, &ImportFields::edited, this, [this] {
        proposed_ = true;  // from here on, user edits win over guesses
        // Ignores repeated signals: a field that loses the focus, as on a click on Open, emits its
        // last edit again.
        if (this->options() != asked_) {
            refresh();
        } else {
            enableOpen();
        }
    });
    keepTranslated(*this, [this, title] {
        setWindowTitle(tr("Import"));
        title->setText(tr("How to read %1").arg(QFileInfo(path_).fileName()));
    });
    choices->setMinimumWidth(fields_->sizeHint().width() + 20);
    resize(980, 620);
    refresh();
}

ImportDialog::~ImportDialog() {
    fields_->disconnect(this);  // avoids signals of fields to a destroyed object
    if (job_) {
        job_->forget(preview_key);
    }
}

OpenOptions ImportDialog::options() const {
    OpenOptions options = fields_->options();
    find_files_from(QFileInfo(path_).absolutePath().toStdU16String(), options);
    return options;
}

void ImportDialog::refresh() {
    preview_.reset();
    enableOpen();
    asked_ = options();
    job_->preview(preview_key, path_, asked_,
                  [this](const Result<RecordingPreview>& result) { take(result); });
}

std::optional<OpenOptions> ImportDialog::proposal(const RecordingPreview& preview) {
    const bool unknown = !preview.file_format;
    if (!proposed_) {
        proposed_ = true;
        raw_proposed_ = unknown;
        const auto partner = partner_of(path_.toStdU16String());
        if (partner && preview.problem && preview.problem->code == ErrorCode::too_few_channels) {
            OpenOptions pair = options();
            pair.channel_d_file = partner->string();
            return pair;
        }
        if (const auto last = rememberedImport(importKind(path_, preview, unknown))) {
            return last;
        }
        if (unknown) {
            OpenOptions raw = options();
            raw.raw = RawLayout{};
            return raw;
        }
    }
    if (options().raw && !raw_proposed_) {
        raw_proposed_ = true;
        return rememberedImport(importKind(path_, preview, true));
    }
    return {};
}

void ImportDialog::take(const Result<RecordingPreview>& result) {
    if (!result) {
        view_->setError(result.error());
        return;
    }
    const auto better = proposal(*result);
    if (better && *better != options()) {
        fields_->setOptions(*better);
        refresh();
        return;
    }
    preview_ = *result;
    fields_->setPreview(*preview_);
    view_->setPreview(*preview_);
    enableOpen();
    const bool lacks_rate = preview_->problem && preview_->problem->code == ErrorCode::rate_unknown;
    if (!std::exchange(shown_, true) && lacks_rate) {
        fields_->focusRate();  // the only missing value can be typed at once
    }
}

void ImportDialog::enableOpen() {
    buttons_->button(QDialogButtonBox::Open)
        ->setEnabled(preview_ && !preview_->problem && fields_->isValid());
}

void ImportDialog::accept() {
    if (!buttons_->button(QDialogButtonBox::Open)->isEnabled()) {
        return;
    }
    const OpenOptions chosen_options = options();
    OpenOptions of_kind = chosen_options;  // other files have others beside them
    of_kind.channel_d_file.clear();
    of_kind.join.clear();
    rememberImport(importKind(path_, *preview_, chosen_options.raw.has_value()), of_kind);
    emit chosen(path_, chosen_options);
    QDialog::accept();
}

}  // namespace vybeg::ui
