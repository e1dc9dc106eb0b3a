#include "ui/window/file_commands.h"

#include "core/analysis/measurement_list.h"
#include "core/output/drift_json.h"
#include "core/output/output_file.h"
#include "core/output/sample_files.h"
#include "core/recording/samples/open_table.h"
#include "core/simulation/free_decay.h"
#include "core/simulation/simulate.h"
#include "ui/batch/batch_window.h"
#include "ui/import/import_dialog.h"
#include "ui/import/log_dialog.h"
#include "ui/panels/ledger.h"
#include "ui/plots/track_view.h"
#include "ui/session/session_keeper.h"
#include "ui/window/export_dialogs.h"
#include "ui/window/file_questions.h"
#include "ui/words/program_name.h"

#include <QDir>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <QStandardPaths>

#include <algorithm>
#include <filesystem>
#include <iterator>

namespace vybeg::ui {

namespace {

// Whether a file would take the place of an open recording or log.
Status stayAsTheyAre(const Document& document, const QString& path) {
    std::vector<std::filesystem::path> open;
    const auto add = [&open](const std::filesystem::path& file, const OpenOptions& options) {
        open.push_back(file);
        std::ranges::copy(further_files(options), std::back_inserter(open));
    };
    for (const RecordingEntry& entry : document.recordings()) {
        add(entry.path.toStdU16String(), entry.options);
    }
    for (const RecordingSet& set : document.sets().all()) {
        for (const RecordingRef& log : document.sets().measured(set).recordings) {
            add(log.path, log.open);
        }
    }
    for (const RecordingRef& log : document.drift().logs()) {
        open.push_back(log.path);
    }
    const auto taken = [target = std::filesystem::path(path.toStdU16String())](const auto& each) {
        return same_file(each, target);
    };
    return std::ranges::any_of(open, taken)
               ? Status(Error{ErrorCode::output_is_recording, path.toStdString(), {}})
               : Status();
}

// "rec_maximum-likelihood_60" for the track of an analysis: recording, algorithm and window.
QString trackName(const ShownAnalysis& shown) {
    const std::string_view algorithm = algorithm_name(shown.analysis->settings.algorithm);
    return QStringLiteral("%1_%2_%3")
        .arg(QFileInfo(shown.recording).completeBaseName(),
             QString::fromUtf8(algorithm.data(), std::ssize(algorithm)),
             QString::number(shown.analysis->plan.length));
}

// The article's case, simulated, in the program's own folder, unless it is there already.
Status writeDemonstration(const QString& path, const JobControl& job) {
    if (QFileInfo::exists(path)) {
        return {};
    }
    QDir().mkpath(QFileInfo(path).path());
    const FreeDecay decay = demo_decay();
    const auto samples = TRY(simulate(decay, job));
    auto file = TRY(OutputFile::create(std::filesystem::path(path.toStdU16String()), job));
    TRY(write_samples(file, SampleFormat::wav,
                      in_memory(samples.c, samples.d, decay.rate_hz, job)));
    return file.commit();
}

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

FileCommands::FileCommands(Document& document, SessionKeeper& session, TrackView& tracks,
                           Ledger& ledger, QWidget* window)
    : QObject(window),
      document_(document),
      session_(session),
      tracks_(tracks),
      ledger_(ledger),
      ask_(*new FileQuestions(window)),
      window_(window) {
    connect(&document_, &Document::foundLog, this,
            [this](const QString& path) { openLogs({path}); });
    connect(&document_, &Document::logsWanted, this, &FileCommands::editLogs);
    connect(&document_, &Document::importWanted, this, &FileCommands::openImport);
    connect(&session_, &SessionKeeper::fileWanted, this,
            [this](std::size_t absent, const QString& name) {
                ask_.file(FileQuestions::tr("Where is %1?").arg(name), {},
                          [this, absent](const QString& path) { session_.supply(absent, path); });
            });
}

void FileCommands::askForRecordings() {
    ask_.recordings([this](const QStringList& files) { openTogether(files); });
}

void FileCommands::open(const QStringList& paths, const OpenOptions& options) {
    const auto act = [this, paths, options] { session_.open(paths, options); };
    if (std::ranges::any_of(paths, &SessionKeeper::isSession)) {
        askToSaveAndThen(act);
    } else {
        act();
    }
}

void FileCommands::openTogether(const QStringList& paths) {
    const bool two =
        paths.size() == 2 && std::ranges::none_of(paths, [](const QString& path) {
            return SessionKeeper::isSession(path) || is_measurement_list(path.toStdU16String());
        });
    if (!two) {
        open(paths);
        return;
    }
    constexpr int key = 3;  // the dialogs and the demonstration have others
    // By name: C before D, the first number before the second.
    QStringList sorted = paths;
    sorted.sort();
    const auto look = [path = std::filesystem::path(sorted[0].toStdU16String())](
                          const JobControl& job) { return preview_recording(path, {}, job); };
    imports_.run<RecordingPreview>(key, look, [this, paths, sorted](const auto& preview) {
        if (preview && preview->problem && preview->problem->code == ErrorCode::too_few_channels) {
            OpenOptions pair;
            pair.channel_d_file = sorted[1].toStdString();
            openImport(sorted[0], pair);
        } else {
            open(paths);
        }
    });
}

void FileCommands::openDemonstration() {
    const QString path =
        QDir(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation))
            .filePath(QStringLiteral("demonstration.wav"));
    const auto write = [path](const JobControl& job) { return writeDemonstration(path, job); };
    constexpr int key = 1;
    imports_.write(key, write, [this, path](const Status& written) {
        if (written) {
            open({path});
        } else {
            document_.report(errorMessage(written.error()));
        }
    });
}

void FileCommands::saveSession(const std::function<void()>& then) {
    if (session_.path().isEmpty()) {
        saveSessionAs(then);
    } else if (!session_.isSaving() && session_.isChangedElsewhere()) {
        askToReplaceAndThen(then);
    } else {
        session_.save(session_.path(), then);
    }
}

void FileCommands::askToReplaceAndThen(const std::function<void()>& then) {
    auto* question = new QMessageBox(
        QMessageBox::Warning, tr("Save session"),
        tr("Another program has changed %1 since it was opened here. Saving replaces its changes.")
            .arg(QFileInfo(session_.path()).fileName()),
        QMessageBox::Cancel, window_);
    question->setAttribute(Qt::WA_DeleteOnClose);
    const auto* replace = question->addButton(tr("Replace"), QMessageBox::DestructiveRole);
    const auto* other = question->addButton(tr("Save as…"), QMessageBox::AcceptRole);
    connect(question, &QMessageBox::buttonClicked, this,
            [this, then, replace, other](const QAbstractButton* pressed) {
                if (pressed == other) {
                    saveSessionAs(then);
                } else if (pressed == replace) {
                    session_.save(session_.path(), then);
                }
            });
    question->open();
}

void FileCommands::saveSessionAs(const std::function<void()>& then) {
    const RecordingEntry* current = document_.currentRecording();
    const QString name = QFileInfo(!session_.path().isEmpty() ? session_.path()
                                   : current                  ? current->path
                                                              : QStringLiteral("vybeg"))
                             .completeBaseName();
    ask_.target(FileQuestions::tr("Save session"), name + QStringLiteral(".vybeg"),
                {FileQuestions::tr("Session (*.vybeg)")}, [this, then](const QString& path) {
                    put(path, {".vybeg"}, [&](const Done&) { session_.save(path, then); });
                });
}

void FileCommands::askToSaveAndThen(const std::function<void()>& then) {
    if (session_.isSaving()) {
        connect(
            &session_, &SessionKeeper::saveEnded, this, [this, then] { askToSaveAndThen(then); },
            Qt::SingleShotConnection);
        return;
    }
    if (!session_.isModified()) {
        then();
        return;
    }
    auto* question =
        new QMessageBox(QMessageBox::Question, tr("Save changes?"),
                        tr("The session has changes that are not saved."),
                        QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, window_);
    question->setAttribute(Qt::WA_DeleteOnClose);
    connect(question, &QMessageBox::finished, this, [this, then](int answer) {
        if (answer == QMessageBox::Save) {
            saveSession(then);
        } else if (answer == QMessageBox::Discard) {
            then();
        }
    });
    question->open();
}

void FileCommands::askForPassport() {
    ask_.file(FileQuestions::tr("Compare with passport"), {FileQuestions::tr("Passport (*.json)")},
              [this](const QString& path) { document_.passport().open(path); });
}

void FileCommands::askForDatabase(bool make) {
    const auto take = [this, make](const QString& path) { emit databaseChosen(path, make); };
    if (make) {
        ask_.target(FileQuestions::tr("New database"), QStringLiteral("results.db"),
                    {FileQuestions::tr("Database of results (*.db)")}, take);
    } else {
        ask_.file(FileQuestions::tr("Open database"),
                  {FileQuestions::tr("Database of results (*.db *.sqlite)")}, take);
    }
}

void FileCommands::askWhereToPutTrack() {
    if (const AnalysisEntry* entry = document_.analysis(ledger_.currentAnalysis())) {
        ask_.target(
            FileQuestions::tr("Export track"), trackName(entry->shown) + QStringLiteral(".csv"),
            {FileQuestions::tr("Track (*.csv)"), FileQuestions::tr("Track for MATLAB (*.mat)"),
             FileQuestions::tr("Track, HDF5 (*.h5)"), FileQuestions::tr("Track for NumPy (*.npz)")},
            [this](const QString& path) { exportTrackTo(path); });
    }
}

void FileCommands::askForWholeAngleLogs() {
    ask_.wholeAngleLogs([this](const QStringList& files) { document_.drift().open(files); });
}

void FileCommands::askWhereToPutDrift() {
    ask_.target(FileQuestions::tr("Export drift"), QStringLiteral("drift.csv"),
                {FileQuestions::tr("Table (*.csv)"), FileQuestions::tr("Result (*.json)")},
                [this](const QString& path) { exportDriftTo(path); });
}

void FileCommands::askWhereToPutPassport() {
    ask_.target(FileQuestions::tr("Save passport"), QStringLiteral("passport.json"),
                {FileQuestions::tr("Passport (*.json)")},
                [this](const QString& path) { savePassportTo(path); });
}

void FileCommands::askForImport() {
    const RecordingEntry* current = document_.currentRecording();
    // The current one, to read it in another way.
    ask_.file(
        FileQuestions::tr("Import a recording"), {},
        [this](const QString& file) {
            const RecordingEntry* entry = document_.currentRecording();
            openImport(file, entry && entry->path == file ? entry->options : OpenOptions{});
        },
        FileQuestions::Folder::follows, current ? current->path : QString());
}

void FileCommands::askForLogs() {
    ask_.logs([this](const QStringList& files) { openLogs(files); });
}

void FileCommands::editLogs(SetId id, const QStringList& further) {
    if (logs_ && logs_->isVisible()) {
        logs_->add(further);
        return;
    }
    const RecordingSet* set = document_.sets().find(id);
    auto* dialog = new LogDialog(imports_, further,
                                 set ? document_.sets().measured(*set) : MeasurementSet(), window_);
    logs_ = dialog;
    connect(dialog, &LogDialog::filesWanted, &ask_, &FileQuestions::parts);
    connect(dialog, &LogDialog::chosen, this, [this, id](const MeasurementSet& chosen) {
        SetStore& sets = document_.sets();
        if (sets.find(id)) {
            sets.setLogs(id, chosen);
            sets.identifySet(id);
        } else {
            sets.openLogs(chosen);
        }
    });
    dialog->open();
}

void FileCommands::openImport(const QString& path, const OpenOptions& options) {
    delete import_;
    auto* dialog = new ImportDialog(imports_, path, options, window_);
    import_ = dialog;
    connect(dialog, &ImportDialog::filesWanted, &ask_, &FileQuestions::parts);
    connect(dialog, &ImportDialog::chosen, this,
            [this](const QString& file, const OpenOptions& chosen) {
                const RecordingEntry* entry = document_.currentRecording();
                if (entry && entry->path == file) {
                    document_.reopen(entry->id, chosen);
                } else {
                    document_.open({file}, chosen);
                }
            });
    dialog->open();
}

void FileCommands::put(const QString& path, std::initializer_list<std::string_view> endings,
                       const std::function<void(const Done&)>& write) {
    const Done done = [this, path](const Status& status) {
        document_.report(
            status ? Message{MessageLevel::info, [path] { return tr("Written: %1").arg(path); }}
                   : errorMessage(status.error()));
    };
    Status possible = stayAsTheyAre(document_, path);
    if (possible && endings.size() > 0) {
        possible = check_ending(std::filesystem::path(path.toStdU16String()), endings);
    }
    possible ? write(done) : done(possible);
}

void FileCommands::exportPlots(const FigureSource& source) {
    auto* dialog = new ExportDialog(source, window_);
    connect(dialog, &ExportDialog::saveWanted, this, [this, dialog] {
        ask_.target(
            FileQuestions::tr("Export plots"), dialog->figure().name + QStringLiteral(".png"),
            {FileQuestions::tr("PNG image (*.png)"), FileQuestions::tr("SVG drawing (*.svg)"),
             FileQuestions::tr("PDF document (*.pdf)")},
            [this, dialog = QPointer(dialog)](const QString& path) {
                if (dialog && writeFigure(dialog->figure(), dialog->paper(), path)) {
                    dialog->accept();
                }
            });
    });
    dialog->open();
}

void FileCommands::exportPlot(const Figure& figure) {
    exportPlots({{figure.name}, [figure](const auto&) { return figure; }, {}, {}});
}

void FileCommands::exportHistory(const HistoryExport& all) {
    ask_.target(FileQuestions::tr("Export history"), QStringLiteral("history.csv"),
                {FileQuestions::tr("Table (*.csv)"), FileQuestions::tr("PDF document (*.pdf)")},
                [this, all](const QString& path) { exportHistoryTo(path, all); });
}

void FileCommands::exportHistoryTo(const QString& path, const HistoryExport& all) {
    put(path, {"", ".csv", ".txt", ".pdf"}, [&](const Done& done) {
        if (path.endsWith(QStringLiteral(".pdf"), Qt::CaseInsensitive)) {
            reports_.write(all.report, all.figures, path, done);
        } else {
            done(write_file(std::filesystem::path(path.toStdU16String()), all.table, JobControl()));
        }
    });
}

void FileCommands::askForReport(bool of_set) {
    auto* dialog = new ReportDialog(document_, of_set, window_);
    connect(dialog, &ReportDialog::saveWanted, this, [this, dialog] {
        ask_.target(FileQuestions::tr("Save report"),
                    QFileInfo(dialog->subject().name).completeBaseName() + QStringLiteral(".pdf"),
                    {FileQuestions::tr("PDF document (*.pdf)")},
                    [this, dialog = QPointer(dialog)](const QString& path) {
                        if (dialog) {
                            std::vector<ReportContent> contents = dialog->contents();
                            for (ReportContent& content : contents) {
                                content.units = tracks_.units();
                            }
                            writeReport(contents, dialog->subject().name, path);
                            dialog->accept();
                        }
                    });
    });
    dialog->open();
}

void FileCommands::writeReport(const std::vector<ReportContent>& contents, const QString& about,
                               const QString& path) {
    put(path, {".pdf"}, [&](const Done& done) { reports_.write(contents, about, path, done); });
}

bool FileCommands::writeFigure(const Figure& figure, const Paper& paper, const QString& path) {
    bool written = false;
    put(path, {}, [&](const Done& done) {
        const Status status = writeDrawing(figure.draw, paper, path);
        written = bool(status);
        done(status);
    });
    return written;
}

void FileCommands::exportTrackTo(const QString& path) {
    put(path, {},
        [&](const Done& done) { document_.exportTrack(ledger_.currentAnalysis(), path, done); });
}

void FileCommands::exportDriftTo(const QString& path) {
    const auto outcome = document_.drift().outcome();
    if (!outcome) {
        return;
    }
    put(path, {".csv", ".json"}, [&](const Done& done) {
        const std::filesystem::path target(path.toStdU16String());
        const auto text = file_ending(target) == ".json" ? drift_json : drift_csv;
        done(write_file(target, text(programName().toStdString(), *outcome), JobControl()));
    });
}

void FileCommands::savePassportTo(const QString& path) {
    put(path, {"", ".json"}, [&](const Done& done) {
        document_.sets().savePassport(path, document_.dossier().dossier().gyro, done);
    });
}

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

#include "moc_file_commands.cpp"
