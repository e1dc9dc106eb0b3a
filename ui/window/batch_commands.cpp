#include "ui/window/batch_commands.h"

#include "ui/batch/batch_window.h"
#include "ui/document/document.h"
#include "ui/window/file_questions.h"

#include <algorithm>

namespace vybeg::ui {

namespace {

// Whether a set of the document is this one of a list.
bool isSame(const RecordingSet& set, const MeasurementSet& listed) {
    if (!set.listed || set.name.toStdString() != listed.name ||
        set.listed->recordings.size() != listed.recordings.size()) {
        return false;
    }
    return std::ranges::all_of(set.listed->recordings, [&](const RecordingRef& row) {
        return std::ranges::any_of(listed.recordings, [&](const RecordingRef& recording) {
            return recording.path == row.path && recording.open == row.open;
        });
    });
}

}  // namespace

BatchCommands::BatchCommands(Document& document, QWidget* window)
    : QObject(window), document_(document), window_(window) {}

void BatchCommands::show() {
    if (!batch_) {
        batch_ = new BatchWindow(window_);
        batch_->setUnits(units_);
        batch_->setPanelSource(
            [this] { return document_.sets().measured(RecordingSet()).settings; });
        auto* questions = new FileQuestions(batch_);
        connect(&batch_->form(), &BatchForm::pathWanted, this,
                [this, questions](BatchPath which) { ask(*questions, which); });
        connect(batch_, &BatchWindow::setWanted, this, &BatchCommands::openSet);
        connect(batch_, &BatchWindow::helpWanted, this, &BatchCommands::helpWanted);
    }
    batch_->show();
    batch_->raise();
    batch_->activateWindow();
}

void BatchCommands::setUnits(const DisplayUnits& units) {
    units_ = units;
    if (batch_) {
        batch_->setUnits(units);
    }
}

void BatchCommands::leave() {
    if (batch_) {
        batch_->leave();
    }
}

void BatchCommands::ask(FileQuestions& questions, BatchPath which) {
    const auto take = [this, which](const QString& path) { batch_->form().setPath(which, path); };
    switch (which) {
        case BatchPath::list:
            questions.file(FileQuestions::tr("Measurement list"),
                           {FileQuestions::tr("Measurement list (*.csv *.txt)")}, take,
                           FileQuestions::Folder::follows);
            break;
        case BatchPath::folder: questions.folder(tr("Folder of recordings"), take); break;
        case BatchPath::results: {
            const QString now = batch_->form().path(which);
            questions.target(
                FileQuestions::tr("Results"), now.isEmpty() ? QStringLiteral("results.csv") : now,
                {FileQuestions::tr("Table (*.csv)")}, take, FileQuestions::Existing::stays);
            break;
        }
        case BatchPath::passports: questions.folder(tr("Folder of passports"), take); break;
        case BatchPath::database:
            questions.target(FileQuestions::tr("Database of results"), QStringLiteral("results.db"),
                             {FileQuestions::tr("Database of results (*.db *.sqlite)")}, take,
                             FileQuestions::Existing::stays);
            break;
        case BatchPath::json: questions.folder(tr("Folder for JSON files"), take); break;
    }
}

void BatchCommands::openSet(const MeasurementList& list) {
    SetStore& sets = document_.sets();
    const auto& all = sets.all();
    const auto open = std::ranges::find_if(
        all, [&](const RecordingSet& set) { return isSame(set, list.sets.front()); });
    if (open != all.end()) {
        sets.setCurrent(open->id);
    } else {
        sets.open(list);
    }
    emit setOpened();
    window_->show();
    window_->raise();
    window_->activateWindow();
}

}  // namespace vybeg::ui

#include "moc_batch_commands.cpp"
