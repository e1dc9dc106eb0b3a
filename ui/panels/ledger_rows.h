#pragma once

#include "ui/document/document.h"
#include "ui/document/recording_store.h"
#include "ui/panels/measuring.h"
#include "ui/values/ids.h"
#include "ui/words/short_names.h"

#include <QString>
#include <QStringList>
#include <QTreeWidgetItem>
#include <QWidget>

#include <array>
#include <utility>
#include <vector>

class QComboBox;
class QToolButton;

namespace vybeg::ui {

// The data of a recording, a line each: file, format, rate, length, channels, start, carrier,
// SHA-256.
QString recordingFacts(const RecordingEntry& entry);

// Of the names, by which the ledger knows its rows.
inline constexpr int name_column = 0;

// One row of the ledger: an analysis, or a recording without one.
struct LedgerRow {
    const RecordingEntry* recording = nullptr;
    const AnalysisEntry* analysis = nullptr;
    bool first = false;  // of its recording
    bool alone = false;  // the recording has no other
};

// The rows in the order of the recordings, those of each in the order of its analyses.
std::vector<LedgerRow> ledgerRows(const Document& document);

// Name, colour and facts of a row, in the first column of its item; behind the name of a recording
// its sets, where they are to tell.
void nameRow(const LedgerRow& row, const QString& sets, bool live, QTreeWidgetItem& item);
// The worst warnings of a row, a line each; empty without any.
QString rowNotes(const LedgerRow& row);

// What an item is the row of.
RecordingId recordingOf(const QTreeWidgetItem& item);
AnalysisId analysisIdOf(const QTreeWidgetItem& item);

// Draws names without what they share with the recording above them, and with their sets.
class LedgerNames : public NameDelegate {
public:
    using NameDelegate::NameDelegate;

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;
};

// What the ledger reads, and where.
struct LedgerReader {
    const Document& document;
    ReadAt at;
    const Measuring& measuring;
    const MeasuredTrends& trends;
    const DisplayUnits& units;
};

// The readings of one variable: all with the unit and power of ten in the head.
struct CellColumn {
    QString head;
    QStringList cells;
};

// `rows`: null for a recording without analysis. `concise`: deviations in brackets.
CellColumn variableColumn(const LedgerReader& reader, const std::vector<const AnalysisEntry*>& rows,
                          SlowVariable variable, bool concise);

// What the trend of an analysis says, or why there is nothing to read, and the whole of it for a
// tooltip.
std::pair<QString, QString> trendCell(const LedgerReader& reader, const AnalysisEntry* entry);

// The switch in the ledger's header: where its columns read, and the kind of the trend.
class LedgerHead : public QWidget {
    Q_OBJECT

public:
    explicit LedgerHead(QWidget* parent = nullptr);

    void show(ReadAt at, const Measuring& measuring);

signals:
    void readAtChosen(vybeg::ui::ReadAt at);
    void kindChosen(vybeg::ui::TrendKind kind);

private:
    void retranslate();
    void showFirst();

    std::array<QToolButton*, 5> buttons_{};  // as ReadAt
    QComboBox* kind_;
    bool mouse_ = false;  // is over the plots
};

}  // namespace vybeg::ui
