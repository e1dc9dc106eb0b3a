#include "tests/tools/pictures/pictures.h"

#include "core/base/error.h"
#include "tests/tools/pictures/layout.h"
#include "tests/tools/pictures/pictured_batch.h"
#include "tests/tools/pictures/pictured_history.h"
#include "tests/tools/pictures/simulated_recordings.h"
#include "tests/ui/gui_home.h"
#include "ui/batch/batch_window.h"
#include "ui/document/document.h"
#include "ui/history/history_page.h"
#include "ui/plots/track_view.h"
#include "ui/residuals/residuals_page.h"
#include "ui/session/session_keeper.h"
#include "ui/signals/signals_page.h"
#include "ui/sweep/sweep_page.h"
#include "ui/window/file_commands.h"
#include "ui/window/main_window.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDeadlineTimer>
#include <QFile>
#include <QKeyEvent>
#include <QLockFile>
#include <QPushButton>
#include <QSaveFile>
#include <QTabBar>
#include <QTimer>

#include <functional>
#include <map>
#include <stdexcept>
#include <utility>

namespace vybeg::test {
namespace {

using namespace vybeg::ui;

constexpr int most_ms = 120'000;    // for the slowest job of the window
constexpr double periods_s = 6e-4;  // three of 5300 Hz

// Whether anything is under way that will change what the window shows.
bool working(MainWindow& window) {
    const auto* batch = window.findChild<BatchWindow*>();
    return window.document().working() || window.findChild<SignalsPage*>()->reading() ||
           window.findChild<ResidualsPage*>()->computing() ||
           window.findChild<SweepPage*>()->running() ||
           window.findChild<HistoryPage*>()->reading() || (batch && batch->running());
}

// Runs the event loop until the window has no work left and its picture, or that of its window
// `pictured`, stays the same.
QImage settled(MainWindow& window, QWidget& pictured) {
    const QDeadlineTimer deadline(most_ms);
    QTimer alarm;  // ends the wait for an event that never comes
    alarm.start(most_ms);
    QImage last;
    while (!deadline.hasExpired()) {
        if (working(window)) {
            QCoreApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents);
            continue;
        }
        QCoreApplication::processEvents();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        const QImage now = pictured.grab().toImage();
        if (now == last && !working(window)) {
            return now;
        }
        last = now;
    }
    throw std::runtime_error("The window is still at work after two minutes.");
}

void settle(MainWindow& window) {
    settled(window, window);
}

struct PagePicture {
    const char* name;
    std::function<void(MainWindow&)> show;
    QWidget* of = nullptr;  // null: of the main window
};

// A sweep is computed only on request.
void show_sweep(MainWindow& window) {
    window.action(Command::page_windows)->trigger();
    if (window.findChild<SweepPage*>()->sweep() == nullptr) {
        window.findChild<QPushButton*>(QStringLiteral("computeSweep"))->click();
    }
}

// Every page, and what the panels beside the plots show.
std::vector<PagePicture> pages_of(const MainWindow& window) {
    if (!window.findChild<QTabBar*>(QStringLiteral("pages"))->isVisible()) {
        return {{"welcome", [](MainWindow&) {}}};
    }
    const auto page = [](Command command) {
        return [command](MainWindow& shown) { shown.action(command)->trigger(); };
    };
    std::vector<PagePicture> pages{{"tracks", page(Command::page_tracks)},
                                   {"signals", page(Command::page_signals)},
                                   {"resonator", page(Command::page_resonator)},
                                   {"residuals", page(Command::page_residuals)},
                                   {"windows", show_sweep},
                                   {"drift", page(Command::page_drift)},
                                   {"history", page(Command::page_history)}};
    pages.push_back({"wave", [](MainWindow& shown) {
                         shown.action(Command::page_tracks)->trigger();
                         shown.action(Command::wave)->trigger();
                     }});
    pages.push_back({"periods", [](MainWindow& shown) {
                         shown.action(Command::page_signals)->trigger();
                         shown.findChild<TrackView*>()->setTimeRange({10, 10 + periods_s});
                     }});
    if (auto* batch = window.findChild<BatchWindow*>()) {
        pages.push_back(
            {"batch", [batch](MainWindow& shown) { batch->resize(shown.size()); }, batch});
    }
    return pages;
}

// The status line holds how long the work took, which no two runs share.
void clear_status(MainWindow& window) {
    Message nothing;
    nothing.text = [] { return QString(); };
    window.document().report(nothing);
}

// Cursors and an identified resonator: all that a page can show.
void fill(MainWindow& window, const QStringList& files, const OpenOptions& open) {
    Document& document = window.document();
    document.setLive(false);
    for (const QString& file : files) {  // opened together, the last to arrive is the current one
        window.files().open({file}, open);
        settle(window);
        if (document.recordings().empty()) {
            throw std::runtime_error(file.toStdString() + " cannot be opened.");
        }
    }
    std::vector<ui::RecordingId> ids;
    for (const RecordingEntry& entry : document.recordings()) {
        ids.push_back(entry.id);
    }
    if (!ids.empty()) {
        document.setCurrentRecording(ids.back());  // its analysis is the chosen one
        document.sets().addToCurrent(ids);
        document.sets().identify();
        auto& tracks = *window.findChild<TrackView*>();
        const AxisRange shown = tracks.timeRange();
        for (const auto& [part, key] : {std::pair{0.25, Qt::Key_1}, std::pair{0.75, Qt::Key_2}}) {
            tracks.setTracker(shown.lower + part * shown.span());
            QKeyEvent press(QEvent::KeyPress, key, Qt::NoModifier);
            QCoreApplication::sendEvent(&tracks, &press);
        }
        tracks.setTracker({});  // the ledger reads where a mouse is
        settle(window);
    }
}

// A gyro of which one result lies outside its limits.
void show_history(MainWindow& window, const QString& database) {
    auto& page = *window.findChild<HistoryPage*>();
    page.openDatabase(database, false);
    settle(window);
    auto* gyro = page.findChild<QComboBox*>(QStringLiteral("historyGyro"));
    gyro->setCurrentIndex(1);
    emit gyro->activated(1);
    settle(window);
}

// Writes the whole file, or throws.
void write_file(const QString& path, const std::function<bool(QIODevice&)>& write) {
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || !write(file) || !file.commit()) {
        throw std::runtime_error(
            QStringLiteral("%1: %2").arg(path, file.errorString()).toStdString());
    }
}

// layout.csv of a folder: a row of each picture in it, by their names.
class LayoutTable {
public:
    explicit LayoutTable(const QDir& folder) : folder_(folder) {
        QFile file(path());
        if (file.open(QIODevice::ReadOnly)) {
            const QStringList lines = QString::fromUtf8(file.readAll()).split('\n');
            for (const QString& line : lines.mid(1)) {
                if (const QString picture = line.section(',', 0, 0); folder.exists(picture)) {
                    rows_[picture] = line;
                }
            }
        }
    }

    void set(const QString& picture, const Layout& layout) {
        rows_[picture] = layout_row(picture, layout);
    }

    void write() const {
        QString text = layout_names() + '\n';
        for (const auto& [picture, row] : rows_) {
            text += row + '\n';
        }
        write_file(path(), [&text](QIODevice& file) {
            const QByteArray bytes = text.toUtf8();
            return file.write(bytes) == bytes.size();
        });
    }

private:
    QString path() const { return folder_.filePath(QStringLiteral("layout.csv")); }

    QDir folder_;
    std::map<QString, QString> rows_;
};

bool shows(const PictureRequest& request, const char* page) {
    return request.pages.isEmpty() || request.pages.contains(QLatin1String(page));
}

void picture_pages(MainWindow& window, const QString& name, const PictureRequest& request,
                   LayoutTable& table) {
    for (const PagePicture& page : pages_of(window)) {
        if (!shows(request, page.name)) {
            continue;
        }
        if (window.action(Command::wave)->isChecked()) {
            window.action(Command::wave)->trigger();
        }
        window.findChild<TrackView*>()->fit();
        page.show(window);
        QWidget& pictured = page.of ? *page.of : window;
        const QImage image = settled(window, pictured);
        const QString file = QStringLiteral("%1-%2@%3.png")
                                 .arg(QLatin1String(page.name), name)
                                 .arg(pictured.devicePixelRatioF());
        write_file(request.folder.filePath(file),
                   [&image](QIODevice& device) { return image.save(&device, "PNG"); });
        table.set(file, measure_layout(pictured, image));
    }
}

void picture_all(MainWindow& window, const char* content, const PictureRequest& request,
                 LayoutTable& table) {
    for (const char* const language : {"en", "ru"}) {
        window.setLanguage(QLatin1String(language));
        for (const auto& [theme, theme_name] :
             {std::pair{ThemeMode::light, "light"}, std::pair{ThemeMode::dark, "dark"}}) {
            window.setThemeMode(theme);
            for (const QSize size : request.sizes) {
                window.resize(size);
                const QString name = QStringLiteral("%1-%2-%3-%4x%5")
                                         .arg(QLatin1String(content), QLatin1String(language),
                                              QLatin1String(theme_name))
                                         .arg(size.width())
                                         .arg(size.height());
                picture_pages(window, name, request, table);
            }
        }
    }
}

// The current folder while it exists, at a path that is the same in every run, as the window shows
// it. One process has it at a time.
class CurrentFolder {
public:
    CurrentFolder() {
        lock_.setStaleLockTime(0);
        lock_.lock();
        folder_.removeRecursively();
        if (!QDir().mkpath(folder_.path()) || !QDir::setCurrent(folder_.path())) {
            throw std::runtime_error("The folder cannot be made: " + folder_.path().toStdString());
        }
    }
    CurrentFolder(const CurrentFolder&) = delete;
    CurrentFolder& operator=(const CurrentFolder&) = delete;
    ~CurrentFolder() {
        QDir::setCurrent(QDir::tempPath());
        folder_.removeRecursively();
    }

    const QDir& folder() const { return folder_; }

private:
    QLockFile lock_{QDir::temp().filePath(QStringLiteral("vybeg-pictures.lock"))};
    QDir folder_{QDir::temp().filePath(QStringLiteral("vybeg-pictures"))};
};

// Files to show.
struct Shown {
    QStringList one;
    QStringList all;
};

Shown shown_files(const QStringList& recordings, const QDir& own) {
    return recordings.isEmpty() ? Shown{{write_demonstration(own)}, write_simulated_set(own)}
                                : Shown{recordings.mid(0, 1), recordings};
}

}  // namespace

void save_session(const PictureRequest& request) {
    const GuiTestHome home;
    const CurrentFolder own;
    const Shown files = shown_files(request.recordings, own.folder());
    Document document;
    MainWindow window(document);
    window.setLanguage(QStringLiteral("en"));
    window.resize(request.sizes.front());
    window.show();
    fill(window, files.all, request.open);
    const QString path = request.folder.filePath(QStringLiteral("session.vybeg"));
    bool saved = false;
    window.session().save(path, [&saved] { saved = true; });
    while (window.session().isSaving()) {
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
    if (!saved) {
        throw std::runtime_error("The session cannot be written: " + path.toStdString());
    }
    document.cancel();
}

void make_pictures(const PictureRequest& request) {
    const GuiTestHome home;
    const CurrentFolder own;
    QApplication::setCursorFlashTime(0);
    const Shown files = shown_files(request.recordings, own.folder());
    const QString database = QStringLiteral("laboratory.db");
    if (const Status made = write_pictured_history(database.toStdString()); !made) {
        throw std::runtime_error(english(made.error()));
    }
    LayoutTable table(request.folder);
    std::vector<std::pair<const char*, QStringList>> contents{{"none", {}}, {"one", files.one}};
    if (files.all.size() > 1) {
        contents.emplace_back("all", files.all);
    }
    for (const auto& [content, recordings] : contents) {
        Document document;
        MainWindow window(document);
        window.resize(request.sizes.front());
        window.show();
        fill(window, recordings, request.open);
        // The pages without a database and without logs belong to one recording.
        if (recordings.size() > 1) {
            if (shows(request, "drift")) {
                document.drift().open(write_simulated_logs(own.folder()));
            }
            if (shows(request, "history")) {
                show_history(window, database);
            }
            if (shows(request, "batch")) {
                start_pictured_batch(window, recordings);
            }
            settle(window);
        }
        clear_status(window);
        picture_all(window, content, request, table);
        document.cancel();
    }
    table.write();
}

}  // namespace vybeg::test
