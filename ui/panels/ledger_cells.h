#pragma once

#include "ui/panels/measuring.h"

#include <QString>
#include <QStringList>
#include <QWidget>

#include <array>
#include <utility>
#include <vector>

class QComboBox;
class QToolButton;

namespace vybeg::ui {

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

    std::array<QToolButton*, 5> buttons_{};  // as ReadAt
    QComboBox* kind_;
};

}  // namespace vybeg::ui
