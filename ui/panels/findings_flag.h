#pragma once

#include "core/base/diagnostic.h"
#include "ui/document/document.h"
#include "ui/values/ids.h"

#include <QFrame>
#include <QStringList>
#include <QToolButton>
#include <QWidget>

#include <vector>

class QLabel;
class QTreeWidget;
class QTextBrowser;
class QUrl;

namespace vybeg::ui {

// Whether the check or the reading of a recording found something worse than a note.
bool hasFindings(const RecordingEntry& entry);

// Findings of the recording check with their places: the worst, each kind once, or all of them. A
// click on a place emits its choice, one on a remedy that this is wanted.
class CheckList : public QWidget {
    Q_OBJECT

public:
    explicit CheckList(QWidget* parent = nullptr);

    // Shows that the check still runs.
    void setRunning();
    // `remedies`: what can be done about each, in words; empty: nothing.
    void setFindings(const std::vector<Diagnostic>& findings, double rate_hz,
                     const QStringList& remedies = {});

signals:
    void placeChosen(double time_s, double seconds);
    void remedyWanted(int finding);

private:
    void refresh();
    void choose(const QUrl& link);
    QString rowOf(const Diagnostic& finding, const QString& text) const;
    double seconds(std::int64_t frames) const { return static_cast<double>(frames) / rate_hz_; }

    QLabel* title_;
    QTextBrowser* list_;
    std::vector<Diagnostic> findings_;
    QStringList remedies_;
    double rate_hz_ = 1;
    bool running_ = true;
    bool open_ = false;  // each place by itself
};

// The flag beside the overview: the number of findings of the current recording and of events of
// the chosen analysis. A click opens their lists, a click in them goes to the place.
class FindingsFlag : public QToolButton {
    Q_OBJECT

public:
    explicit FindingsFlag(Document& document, QWidget* parent = nullptr);

    void setAnalysis(AnalysisId analysis_id);

signals:
    // Seconds from the start of the recording.
    void placeChosen(double time_s, double seconds);

private:
    void refresh();
    void fillEvents(const AnalysisEntry* entry);
    void retranslate();

    Document& document_;
    QFrame* popup_;
    CheckList* check_;
    QLabel* title_;
    QTreeWidget* events_;
    AnalysisId analysis_id_ = AnalysisId::none;
    std::shared_ptr<const Analysis> listed_;  // analysis of the listed events
};

}  // namespace vybeg::ui
