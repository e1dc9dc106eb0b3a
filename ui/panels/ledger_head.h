#pragma once

#include "ui/panels/measuring.h"

#include <QWidget>

#include <array>

class QComboBox;
class QToolButton;

namespace vybeg::ui {

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
