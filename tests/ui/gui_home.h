#pragma once

#include "core/simulation/free_decay.h"

#include <QByteArray>
#include <QCoreApplication>
#include <QDir>
#include <QSettings>
#include <QStandardPaths>
#include <QString>
#include <QTemporaryDir>

namespace vybeg::ui {

// A place of its own for the settings and files of a test program: nothing of the user's is read or
// changed.
class GuiTestHome {
public:
    GuiTestHome();

    QString path(const QString& name) const { return folder_.filePath(name); }
    // A decay of a_A = 1, a_B = 0.1, 2theta_A = 0.4 at 1000 Hz, sampled at 8000 Hz, with noise
    // of standard deviation 1e-3; WAV or CSV by the ending.
    QString recording(const QString& name, double seconds = 2) const;
    QString recording(const QString& name, const FreeDecay& decay) const;
    QString file(const QString& name, const QByteArray& content) const;

private:
    QTemporaryDir folder_;
};

// Lets what is posted to the window's thread arrive: all that is still to come where no work is
// under way.
void deliverPosted();

}  // namespace vybeg::ui
