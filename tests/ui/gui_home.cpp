#include "tests/ui/gui_home.h"

#include "core/output/sample_files.h"
#include "core/simulation/simulate.h"

#include <QFile>

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
    return recording(name, decay);
}

QString GuiTestHome::recording(const QString& name, const FreeDecay& decay) const {
    const auto samples = simulate(decay, JobControl());
    const std::filesystem::path target(path(name).toStdString());
    auto file = OutputFile::create(target, JobControl());
    const auto format = sample_format(target);
    if (!samples || !file || !format ||
        !write_samples(*file, *format, in_memory(samples->c, samples->d, decay.rate_hz, {})) ||
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

void deliverPosted() {
    QCoreApplication::sendPostedEvents();
    QCoreApplication::processEvents();
}

}  // namespace vybeg::ui
