#pragma once

#include <QStringList>

namespace vybeg::ui {
class MainWindow;
}

namespace vybeg::test {

// Starts a batch of sets of these recordings in its window, with its files in the current folder:
// of each recording alone, of all, and of one that is missing. The passport is that of the window's
// set. Throws std::runtime_error where a file cannot be written.
void start_pictured_batch(ui::MainWindow& window, const QStringList& recordings);

}  // namespace vybeg::test
