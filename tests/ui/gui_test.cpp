#include "tests/ui/gui_test.h"

#include "core/output/sample_files.h"
#include "core/simulation/free_decay.h"
#include "core/simulation/simulate.h"
#include "ui/window/file_commands.h"
#include "ui/window/tracks_page.h"

#include <QFile>
#include <QTest>

#include <numeric>

namespace vybeg::ui {

GuiTestHome::GuiTestHome() {
    QStandardPaths::setTestModeEnabled(true);
    QCoreApplication::setOrganizationName(QStringLiteral("vybeg-tests"));
    QCoreApplication::setApplicationName(QStringLiteral("gui"));
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder_.path());
}

QString GuiTestHome::recording(const QString& name, double seconds) const {
    FreeDecay decay;
    decay.seconds = seconds;
    decay.rate_hz = 8000;
    decay.f0_hz = 1000;
    decay.a_B = 0.1;
    decay.two_theta_A = 0.4;
    decay.noise = 1e-3;
    const auto samples = simulate(decay, JobControl());
    const std::filesystem::path target(path(name).toStdString());
    auto file = OutputFile::create(target, JobControl());
    const auto format = sample_format(target);
    if (!samples || !file || !format ||
        !write_samples(*file, *format, {samples->c, samples->d, decay.rate_hz}, JobControl()) ||
        !file->commit()) {
        qFatal("the test's recording cannot be written");
    }
    return path(name);
}

QString GuiTestHome::file(const QString& name, const QByteArray& content) const {
    QFile file(path(name));
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size()) {
        qFatal("the test's file cannot be written");
    }
    return path(name);
}

NumberField& fieldOf(const QWidget& window, const QString& accessible_name) {
    for (NumberField* each : window.findChildren<NumberField*>()) {
        if (each->accessibleName() == accessible_name) {
            return *each;
        }
    }
    qFatal("no such field: %s", qPrintable(accessible_name));
}

void typeInto(NumberField& field, const char* text) {
    field.setFocus();
    field.selectAll();
    QTest::keyClicks(&field, text);
    QTest::keyClick(&field, Qt::Key_Return);
}

std::unique_ptr<MainWindow> shownWindow() {
    QSettings().clear();
    QSettings().setValue(QStringLiteral("live"), false);
    auto window = std::make_unique<TestWindow>();
    window->setLanguage(QStringLiteral("en"));
    window->resize(1400, 900);
    window->show();
    if (!QTest::qWaitForWindowExposed(window.get())) {
        qFatal("the window does not appear");
    }
    return window;
}

bool exportPlotsTo(MainWindow& window, const QString& path) {
    const FigureSource source = childOf<TracksPage>(window).figures();
    std::vector<int> all(static_cast<std::size_t>(source.plots.size()));
    std::iota(all.begin(), all.end(), 0);
    const Figure figure = source.figure(all);
    return window.files().writeFigure(figure, {figure.size}, path);
}

}  // namespace vybeg::ui
