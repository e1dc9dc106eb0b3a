#include "ui/batch/batch_form.h"

#include "ui/widgets/page_parts.h"
#include "ui/words/error_text.h"

#include <QCheckBox>
#include <QDir>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include <algorithm>
#include <string>

namespace vybeg::ui {

namespace {

// Two lines side by side: label, field, button, button; the upper ones take both.
constexpr int columns_of_line = 4;

// A field of the form: its place, its part of the batch's request, and its texts.
struct LineRow {
    BatchPath path;
    int row;
    int column;
    std::string BatchRequest::*member;
    const char* option;  // of vybeg-cli batch
    const char* object;
    const char* name;
    const char* tip;
    const char* choose = QT_TRANSLATE_NOOP("vybeg::ui::BatchForm", "Choose…");
};

constexpr std::array line_rows{
    LineRow{BatchPath::list, 0, 0, &BatchRequest::list, "", "batchList",
            QT_TRANSLATE_NOOP("vybeg::ui::BatchForm", "Recordings"),
            QT_TRANSLATE_NOOP("vybeg::ui::BatchForm",
                              "A measurement list (CSV), or a folder in which each file is a set "
                              "of its own"),
            QT_TRANSLATE_NOOP("vybeg::ui::BatchForm", "List…")},
    LineRow{BatchPath::results, 1, 0, &BatchRequest::output, "-o", "batchResults",
            QT_TRANSLATE_NOOP("vybeg::ui::BatchForm", "Results"),
            QT_TRANSLATE_NOOP("vybeg::ui::BatchForm",
                              "The table that is written, CSV: as vybeg-cli batch writes it. Until "
                              "it is whole, its rows are beside it, and nothing that is computed "
                              "is lost.")},
    LineRow{BatchPath::passports, 2, 0, &BatchRequest::passports, "--passport", "batchPassports",
            QT_TRANSLATE_NOOP("vybeg::ui::BatchForm", "Passports"),
            QT_TRANSLATE_NOOP("vybeg::ui::BatchForm",
                              "Optional. A folder with GYRO.json for the gyros: each set is "
                              "compared with the one of its gyro.")},
    LineRow{BatchPath::database, 2, columns_of_line, &BatchRequest::database, "--database",
            "batchDatabase", QT_TRANSLATE_NOOP("vybeg::ui::BatchForm", "Database"),
            QT_TRANSLATE_NOOP("vybeg::ui::BatchForm",
                              "Optional. The results also go into this database of results, for "
                              "the history.")},
    LineRow{BatchPath::json, 3, 0, &BatchRequest::json, "--json", "batchJson",
            QT_TRANSLATE_NOOP("vybeg::ui::BatchForm", "JSON files"),
            QT_TRANSLATE_NOOP("vybeg::ui::BatchForm",
                              "Optional. A folder that also gets the whole result of each set, as "
                              "vybeg-cli identify writes it.")}};
static_assert(line_rows.size() == BatchForm::lines);

}  // namespace

BatchForm::BatchForm(QWidget* parent) : QWidget(parent) {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    for (std::size_t k = 0; k < lines; ++k) {
        const LineRow& row = line_rows[k];
        Line& line = lines_[k];
        const QString object = QString::fromLatin1(row.object);
        line = {new QLabel(this), new QLineEdit(this), new QPushButton(this)};
        line.edit->setObjectName(object);
        line.choose->setObjectName(object + QStringLiteral("Choose"));
        line.edit->setClearButtonEnabled(true);
        line.label->setBuddy(line.edit);
        // The first line has one button more.
        const int end = row.row < 2 ? 2 * columns_of_line - 2 : row.column + columns_of_line - 1;
        grid->addWidget(line.label, row.row, row.column);
        grid->addWidget(line.edit, row.row, row.column + 1, 1, end - row.column - 1);
        grid->addWidget(line.choose, row.row, end);
        connect(line.edit, &QLineEdit::textChanged, this, &BatchForm::changed);
        connect(line.choose, &QPushButton::clicked, this,
                [this, which = row.path] { emit pathWanted(which); });
        if (row.path == BatchPath::list) {
            folder_ = withName(new QPushButton(this), "batchListFolder");
            grid->addWidget(folder_, 0, end + 1);
            connect(folder_, &QPushButton::clicked, this,
                    [this] { emit pathWanted(BatchPath::folder); });
        }
    }
    panel_ = withName(new QCheckBox(this), "batchPanel");
    grid->addWidget(panel_, 3, columns_of_line, 1, columns_of_line);
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(columns_of_line + 1, 1);
    keepTranslated(*this, [this] { retranslate(); });
}

QLineEdit& BatchForm::editOf(BatchPath which) const {
    const BatchPath path = which == BatchPath::folder ? BatchPath::list : which;
    const auto* row = std::ranges::find(line_rows, path, &LineRow::path);
    return *lines_[static_cast<std::size_t>(row - line_rows.begin())].edit;
}

void BatchForm::setPath(BatchPath which, const QString& path) {
    editOf(which).setText(QDir::toNativeSeparators(path));
    QLineEdit& results = editOf(BatchPath::results);
    const bool is_input = which == BatchPath::list || which == BatchPath::folder;
    if (is_input && !path.isEmpty() && (results.text().isEmpty() || results.text() == proposed_)) {
        // Beside a folder, not in it: it is not one of its recordings.
        const QFileInfo input(path);
        const QString name = input.isDir() ? input.fileName() : input.completeBaseName();
        proposed_ = QDir(input.absolutePath()).filePath(name + QStringLiteral("_results.csv"));
        results.setText(proposed_);
    }
}

QString BatchForm::path(BatchPath which) const {
    return editOf(which).text().trimmed();
}

bool BatchForm::isComplete() const {
    return !path(BatchPath::list).isEmpty() && !path(BatchPath::results).isEmpty();
}

bool BatchForm::takesPanel() const {
    return panel_->isChecked();
}

BatchRequest BatchForm::request() const {
    BatchRequest request;
    for (const LineRow& row : line_rows) {
        if (const QString file = path(row.path); !file.isEmpty()) {
            request.*row.member = QFileInfo(file).absoluteFilePath().toStdString();
        }
    }
    return request;
}

QString BatchForm::errorText(Error error) {
    for (const LineRow& row : line_rows) {
        if (error.code == ErrorCode::setting_invalid && *row.option != '\0' &&
            error.args.front().text == row.option) {
            error.args.front() = tr(row.name).toStdString();
        }
    }
    return ui::errorText(error);
}

void BatchForm::retranslate() {
    for (std::size_t k = 0; k < lines; ++k) {
        const LineRow& row = line_rows[k];
        const Line& line = lines_[k];
        const QString name = tr(row.name);
        line.label->setText(name);
        setWords(*line.edit, name, tr(row.tip));
        line.choose->setText(tr(row.choose));
        setWords(*line.choose, name + QStringLiteral(": ") + tr(row.choose), tr(row.tip));
    }
    folder_->setText(tr("Folder…"));
    folder_->setToolTip(tr("A folder in which each file is a set of its own"));
    panel_->setText(tr("Settings of the Analysis panel where the list has none"));
    panel_->setToolTip(
        tr("Range, filter, calibration and tolerances as they are now; otherwise "
           "the defaults of the command line"));
}

}  // namespace vybeg::ui

#include "moc_batch_form.cpp"
