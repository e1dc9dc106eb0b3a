#pragma once

#include <QDir>
#include <QStringList>

namespace vybeg::ui {
class MainWindow;
}

namespace vybeg::cli {

// Starts a batch of sets of these recordings in its window, with its files in `folder`: of each
// recording alone, of all, and of one that is not there. The passport is that of the window's set.
void start_pictured_batch(ui::MainWindow& window, const QStringList& recordings,
                          const QDir& folder);

}  // namespace vybeg::cli
