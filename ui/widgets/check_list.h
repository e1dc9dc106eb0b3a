#pragma once

#include "core/base/diagnostic.h"

#include <QWidget>

#include <vector>

class QLabel;
class QTextBrowser;
class QUrl;

namespace vybeg::ui {

// How many of them are worse than a note, as on lines passed over.
int findingsIn(const std::vector<Diagnostic>& diagnostics);

// Findings of the recording check with their places: the worst, each kind once, or all of them. A
// click on a place emits its choice.
class CheckList : public QWidget {
    Q_OBJECT

public:
    explicit CheckList(QWidget* parent = nullptr);

    // Shows that the check still runs.
    void setRunning();
    void setFindings(const std::vector<Diagnostic>& findings, double rate_hz);

signals:
    void placeChosen(double time_s, double seconds);

private:
    void refresh();
    void choose(const QUrl& link);
    QString rowOf(const Diagnostic& finding, const QString& text) const;
    double seconds(std::int64_t frames) const { return static_cast<double>(frames) / rate_hz_; }

    QLabel* title_;
    QTextBrowser* list_;
    std::vector<Diagnostic> findings_;
    double rate_hz_ = 1;
    bool running_ = true;
    bool open_ = false;  // each place by itself
};

}  // namespace vybeg::ui
