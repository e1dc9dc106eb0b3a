#include "ui/batch/batch_form.h"

#include "ui/widgets/page_parts.h"

#include <QCheckBox>
#include <QDir>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

namespace vybeg::ui {

namespace {

// Two lines side by side: label, field, button, button; the upper ones take both.
constexpr int columns_of_line = 4;

std::string absolute(const QString& path) {
    return path.isEmpty() ? std::string() : QFileInfo(path).absoluteFilePath().toStdString();
}

}  // namespace

BatchForm::BatchForm(QWidget* parent) : QWidget(parent) {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    input_ = addLine(BatchPath::list, "batchList", 0, 0);
    folder_ = withName(new QPushButton(this), "batchListFolder");
    grid->addWidget(folder_, 0, 2 * columns_of_line - 1);
    connect(folder_, &QPushButton::clicked, this, [this] { emit pathWanted(BatchPath::folder); });
    results_ = addLine(BatchPath::results, "batchResults", 1, 0);
    passports_ = addLine(BatchPath::passports, "batchPassports", 2, 0);
    database_ = addLine(BatchPath::database, "batchDatabase", 2, columns_of_line);
    json_ = addLine(BatchPath::json, "batchJson", 3, 0);
    panel_ = withName(new QCheckBox(this), "batchPanel");
    grid->addWidget(panel_, 3, columns_of_line, 1, columns_of_line);
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(columns_of_line + 1, 1);
    keepTranslated(*this, [this] { retranslate(); });
}

BatchForm::Line BatchForm::addLine(BatchPath which, const char* name, int row, int column) {
    const bool whole = which == BatchPath::list || which == BatchPath::results;
    Line line{new QLabel(this), new QLineEdit(this), new QPushButton(this)};
    const QString object = QString::fromLatin1(name);
    line.edit->setObjectName(object);
    line.choose->setObjectName(object + QStringLiteral("Choose"));
    line.edit->setClearButtonEnabled(true);
    line.label->setBuddy(line.edit);
    auto* grid = static_cast<QGridLayout*>(layout());
    // The first line has one button more.
    const int end = whole ? 2 * columns_of_line - 2 : column + columns_of_line - 1;
    grid->addWidget(line.label, row, column);
    grid->addWidget(line.edit, row, column + 1, 1, end - column - 1);
    grid->addWidget(line.choose, row, end);
    connect(line.edit, &QLineEdit::textChanged, this, &BatchForm::changed);
    connect(line.choose, &QPushButton::clicked, this, [this, which] { emit pathWanted(which); });
    return line;
}

QLineEdit* BatchForm::editOf(BatchPath which) const {
    switch (which) {
        case BatchPath::list:
        case BatchPath::folder: return input_.edit;
        case BatchPath::results: return results_.edit;
        case BatchPath::passports: return passports_.edit;
        case BatchPath::database: return database_.edit;
        case BatchPath::json: return json_.edit;
    }
    return nullptr;
}

void BatchForm::setPath(BatchPath which, const QString& path) {
    editOf(which)->setText(QDir::toNativeSeparators(path));
    const QString results = results_.edit->text();
    if (editOf(which) == input_.edit && !path.isEmpty() &&
        (results.isEmpty() || results == proposed_)) {
        // Beside a folder, not in it: it is not one of its recordings.
        const QFileInfo input(path);
        const QString name = input.isDir() ? input.fileName() : input.completeBaseName();
        proposed_ = QDir(input.absolutePath()).filePath(name + QStringLiteral("_results.csv"));
        results_.edit->setText(proposed_);
    }
}

QString BatchForm::path(BatchPath which) const {
    return editOf(which)->text().trimmed();
}

bool BatchForm::isComplete() const {
    return !path(BatchPath::list).isEmpty() && !path(BatchPath::results).isEmpty();
}

bool BatchForm::takesPanel() const {
    return panel_->isChecked();
}

BatchRequest BatchForm::request() const {
    BatchRequest request;
    request.list = absolute(path(BatchPath::list));
    request.output = absolute(path(BatchPath::results));
    request.passports = absolute(path(BatchPath::passports));
    request.database = absolute(path(BatchPath::database));
    request.json = absolute(path(BatchPath::json));
    return request;
}

void BatchForm::retranslate() {
    const auto say = [](const Line& line, const QString& name, const QString& tip,
                        const QString& choose) {
        line.label->setText(name);
        line.edit->setAccessibleName(name);
        line.edit->setToolTip(tip);
        line.choose->setText(choose);
        line.choose->setAccessibleName(name + QStringLiteral(": ") + choose);
        line.choose->setToolTip(tip);
    };
    const QString choose = tr("Choose…");
    say(input_, tr("Recordings"),
        tr("A measurement list (CSV), or a folder in which each file is a set of its own"),
        tr("List…"));
    folder_->setText(tr("Folder…"));
    folder_->setToolTip(tr("A folder in which each file is a set of its own"));
    say(results_, tr("Results"),
        tr("The table that is written, CSV: as vybeg-cli batch writes it. Until it is whole, its "
           "rows are beside it, and nothing that is computed is lost."),
        choose);
    say(passports_, tr("Passports"),
        tr("Optional. A folder with GYRO.json for the gyros: each set is compared with the one of "
           "its gyro."),
        choose);
    say(database_, tr("Database"),
        tr("Optional. The results also go into this database of results, for the history."),
        choose);
    say(json_, tr("JSON files"),
        tr("Optional. A folder that also gets the whole result of each set, as vybeg-cli identify "
           "writes it."),
        choose);
    panel_->setText(tr("Settings of the Analysis panel where the list has none"));
    panel_->setToolTip(
        tr("Range, filter, calibration and tolerances as they are now; otherwise "
           "the defaults of the command line"));
}

}  // namespace vybeg::ui
