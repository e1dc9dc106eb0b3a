#pragma once

#include <QProcess>
#include <QTest>

#include <filesystem>

// Test files that other programs write: scripts for Debian's Python with NumPy.
namespace vybeg::test {

// Runs a script in the folder, with `import numpy as np` before it. A test cannot do without its
// files: it ends here, and says why, where the script fails or what it imports is not installed.
inline void run_python(const std::filesystem::path& folder, const QString& script) {
    QProcess python;
    python.setWorkingDirectory(QString::fromStdString(folder.string()));
    python.setProcessChannelMode(QProcess::MergedChannels);
    python.start("/usr/bin/python3", {"-c", "import numpy as np\n" + script});
    if (!python.waitForFinished(60000) || python.exitStatus() != QProcess::NormalExit ||
        python.exitCode() != 0) {
        qFatal(
            "The test files could not be written (apt-get install python3-numpy "
            "python3-scipy python3-h5py?): %s",
            qPrintable(python.errorString() + "\n" + python.readAll()));
    }
}

}  // namespace vybeg::test
