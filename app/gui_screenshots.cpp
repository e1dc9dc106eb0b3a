#include "app/gui_screenshots.h"

#include "app/gui_analysis.h"
#include "app/gui_pictured_batch.h"
#include "app/gui_pictured_history.h"
#include "core/base/system_reason.h"
#include "core/output/output_file.h"
#include "core/output/sample_files.h"
#include "core/simulation/simulate.h"
#include "ui/batch/batch_window.h"
#include "ui/document/document.h"
#include "ui/history/history_page.h"
#include "ui/plots/track_view.h"
#include "ui/residuals/residuals_page.h"
#include "ui/sweep/sweep_page.h"
#include "ui/window/file_commands.h"
#include "ui/window/main_window.h"

#include <QAction>
#include <QApplication>
#include <QBuffer>
#include <QComboBox>
#include <QDir>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QKeyEvent>
#include <QPushButton>
#include <QSettings>
#include <QTabBar>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTimer>

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <numbers>
#include <utility>

namespace vybeg::cli {
namespace {

using namespace vybeg::ui;

constexpr int settle_ms = 150;      // a window that has not changed for so long is ready
constexpr int most_ms = 60'000;     // for the slowest analysis
constexpr double periods_s = 6e-4;  // three of 5300 Hz

void pass(int milliseconds) {
    QEventLoop loop;
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, &loop, &QEventLoop::quit);
    timer.start(milliseconds);
    loop.exec();
}

// Lets the program work until a window's picture stays the same.
QImage settled(QWidget& window, const Document& document) {
    QElapsedTimer clock;
    clock.start();
    QImage last;
    while (clock.elapsed() < most_ms) {
        pass(settle_ms);
        const QImage now = window.grab().toImage();
        const auto* residuals = window.findChild<ResidualsPage*>();
        const bool computes = document.busy() || (residuals && residuals->computing());
        if (!computes && now == last) {
            break;
        }
        last = now;
    }
    return last;
}

// Four recordings of one resonator, started at different angles.
Result<QStringList> simulated(const QDir& folder) {
    QStringList paths;
    for (int k = 0; k < 4; ++k) {
        FreeDecay decay;
        decay.seconds = 28;
        decay.f0_hz = 5300 + 0.01 * k;
        decay.two_theta_A = k * std::numbers::pi / 4;
        decay.split_hz = 2e-3;
        decay.theta_w = 0.35;
        decay.tau_s = 30;
        decay.damping_anisotropy_per_s = 2e-4;
        decay.theta_tau = -0.2;
        decay.noise = 1e-3;
        decay.seed = static_cast<std::uint64_t>(k) + 1;
        const QString path = folder.filePath(QStringLiteral("HRG-17_%1.wav").arg(22.5 * k));
        const auto samples = simulate(decay, JobControl());
        auto file = OutputFile::create(path.toStdString(), JobControl());
        if (!samples || !file) {
            return samples ? file.error() : samples.error();
        }
        Status written = write_samples(*file, SampleFormat::wav,
                                       {samples->c, samples->d, decay.rate_hz}, JobControl());
        written = written ? file->commit() : written;
        if (!written) {
            return written.error();
        }
        paths << path;
    }
    return paths;
}

struct Content {
    const char* name;
    qsizetype recordings;
};

struct PagePicture {
    const char* name;
    std::function<void(MainWindow&)> show;
    QWidget* of = nullptr;  // null: of the main window
};

// Every page, and what the panels beside the plots show.
std::vector<PagePicture> pages_of(const MainWindow& window) {
    std::vector<PagePicture> pages;
    const auto* tabs = window.findChild<QTabBar*>(QStringLiteral("pages"));
    static constexpr std::array commands{
        std::pair{Command::page_tracks, "tracks"},
        std::pair{Command::page_signals, "signals"},
        std::pair{Command::page_resonator, "resonator"},
        std::pair{Command::page_residuals, "residuals"},
        std::pair{Command::page_windows, "windows"},
        std::pair{Command::page_history, "history"},
    };
    if (tabs->isVisible()) {
        for (const auto& page : commands) {
            pages.push_back({page.second, [command = page.first](MainWindow& shown) {
                                 shown.findChild<TrackView*>()->fit();
                                 shown.action(command)->trigger();
                             }});
        }
        // A sweep is computed when it is asked for.
        std::prev(pages.end(), 2)->show = [](MainWindow& shown) {
            shown.action(Command::page_windows)->trigger();
            auto* compute = shown.findChild<QPushButton*>(QStringLiteral("computeSweep"));
            if (const auto* page = shown.findChild<SweepPage*>(); page->sweep() == nullptr) {
                compute->click();
                while (page->running()) {
                    pass(settle_ms);
                }
            }
        };
        pages.push_back({"wave", [](MainWindow& shown) {
                             shown.action(Command::page_tracks)->trigger();
                             shown.findChild<QTabWidget*>()->setCurrentIndex(1);
                         }});
        pages.push_back({"periods", [](MainWindow& shown) {
                             shown.action(Command::page_signals)->trigger();
                             auto& tracks = *shown.findChild<TrackView*>();
                             tracks.setTimeRange({10, 10 + periods_s});
                         }});
        if (auto* batch = window.findChild<BatchWindow*>()) {
            pages.push_back(
                {"batch", [batch](MainWindow& shown) { batch->resize(shown.size()); }, batch});
        }
    } else {
        pages.push_back({"welcome", [](MainWindow&) {}});
    }
    return pages;
}

// Cursors and an identified resonator: all that a page can show.
void fill(MainWindow& window, const QStringList& files, const OpenOptions& open) {
    Document& document = window.document();
    document.setLive(false);
    window.files().open(files, open);
    settled(window, document);
    std::vector<ui::RecordingId> ids;
    for (const RecordingEntry& entry : document.recordings()) {
        ids.push_back(entry.id);
    }
    if (!ids.empty()) {
        document.sets().addToCurrent(ids);
        document.sets().identify();
        auto& tracks = *window.findChild<TrackView*>();
        const AxisRange shown = tracks.timeRange();
        for (const auto& [part, key] : {std::pair{0.25, Qt::Key_1}, std::pair{0.75, Qt::Key_2}}) {
            tracks.setTracker(shown.lower + part * shown.span());
            QKeyEvent press(QEvent::KeyPress, key, Qt::NoModifier);
            QCoreApplication::sendEvent(&tracks, &press);
        }
        settled(window, document);
    }
}

// A gyro of which one result lies outside.
void show_history(HistoryPage& page, const QString& database) {
    const auto wait = [&page] {
        while (page.reading()) {
            pass(settle_ms);
        }
    };
    page.openDatabase(database, false);
    wait();
    auto* gyro = page.findChild<QComboBox*>(QStringLiteral("historyGyro"));
    gyro->setCurrentIndex(1);
    emit gyro->activated(1);
    wait();
}

// A table of many sets.
void show_batch(MainWindow& window, const QStringList& files, const QDir& folder) {
    start_pictured_batch(window, files, folder);
    const auto* batch = window.findChild<BatchWindow*>();
    QElapsedTimer clock;
    clock.start();
    constexpr qint64 begins_ms = 1500;  // once its passport is written
    do {
        pass(settle_ms);
    } while (clock.elapsed() < most_ms && (batch->running() || clock.elapsed() < begins_ms));
}

Status write_picture(const QImage& image, const QString& path) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    if (!image.save(&buffer, "PNG")) {
        return Error{ErrorCode::out_of_memory, {}, {}};
    }
    return write_file(path.toStdString(),
                      {bytes.constData(), static_cast<std::size_t>(bytes.size())}, JobControl());
}

Status picture_all(MainWindow& window, const Content& content, const QDir& folder) {
    static constexpr std::array sizes{std::pair{1280, 720}, std::pair{2560, 1440}};
    for (const char* const language : {"en", "ru"}) {
        window.setLanguage(QLatin1String(language));
        for (const auto& [theme, theme_name] :
             {std::pair{ThemeMode::light, "light"}, std::pair{ThemeMode::dark, "dark"}}) {
            window.setThemeMode(theme);
            for (const auto& [width, height] : sizes) {
                window.resize(width, height);
                for (const PagePicture& page : pages_of(window)) {
                    window.findChild<QTabWidget*>()->setCurrentIndex(0);
                    page.show(window);
                    const QString name =
                        QStringLiteral("%1-%2-%3-%4-%5x%6@%7.png")
                            .arg(QLatin1String(page.name), QLatin1String(content.name),
                                 QLatin1String(language), QLatin1String(theme_name))
                            .arg(width)
                            .arg(height)
                            .arg(window.devicePixelRatioF());
                    const QImage picture = settled(page.of ? *page.of : window, window.document());
                    const Status written = write_picture(picture, folder.filePath(name));
                    if (!written) {
                        return written;
                    }
                }
            }
        }
    }
    return {};
}

}  // namespace

int take_screenshots(const ScreenshotRequest& request) {
    const QString target = QString::fromStdString(request.folder);
    if (!QDir().mkpath(target)) {
        return fail({ErrorCode::output_failed, request.folder, {system_reason(errno)}});
    }
    const QTemporaryDir own(QDir::temp().filePath(
        QStringLiteral("recordings-XXXXXX")));  // settings and simulated recordings
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, own.path());
    QStringList files;
    for (const std::string& input : request.inputs) {
        files << QString::fromStdString(input);
    }
    if (files.isEmpty()) {
        const Result<QStringList> made = simulated(QDir(own.path()));
        if (!made) {
            return fail(made.error());
        }
        files = *made;
    }
    const QString database = QDir(own.path()).filePath(QStringLiteral("laboratory.db"));
    if (const Status made = write_pictured_history(database.toStdString()); !made) {
        return fail(made.error());
    }
    for (const Content& content :
         {Content{"none", 0}, Content{"one", 1}, Content{"all", 1 << 20}}) {
        if (content.recordings > 1 && files.size() == 1) {
            continue;
        }
        Document document;
        MainWindow window(document);
        window.show();
        fill(window, files.mid(0, content.recordings), request.open);
        // The page without a database belongs to one recording.
        if (content.recordings > 1) {
            show_history(*window.findChild<HistoryPage*>(), database);
            show_batch(window, files, QDir(own.path()));
        }
        if (const Status done = picture_all(window, content, QDir(target)); !done) {
            return fail(done.error());
        }
        document.cancel();
    }
    return 0;
}

}  // namespace vybeg::cli
