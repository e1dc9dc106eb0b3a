#pragma once

#include "core/recording/open/preview.h"
#include "ui/widgets/theme.h"

#include <QWidget>

class QCustomPlot;
class QLabel;
class QTableWidget;

namespace vybeg::ui {

// Beginning of a recording: the first rows as a table, with the columns of C, D and the time
// marked, and the first samples as curves. A problem is shown above.
class ImportPreview : public QWidget {
    Q_OBJECT

public:
    explicit ImportPreview(QWidget* parent = nullptr);

    void setPreview(const RecordingPreview& preview);
    void setError(const Error& error);

private:
    void showProblem();
    void fillTable();
    void drawSamples();
    void applyLook();
    void retranslate();

    QLabel* what_;  // the format, or the problem
    QTableWidget* table_;
    QCustomPlot* plot_;
    Theme theme_;
    RecordingPreview preview_;
};

}  // namespace vybeg::ui
