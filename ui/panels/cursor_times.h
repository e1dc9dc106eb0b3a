#pragma once

#include "core/analysis/analysis.h"

#include <QWidget>

#include <array>
#include <optional>

class QLabel;

namespace vybeg::ui {

class NumberField;

// The times of the cursors A and B, which can be typed, and what lies between them.
class CursorTimes : public QWidget {
    Q_OBJECT

public:
    explicit CursorTimes(QWidget* parent = nullptr);

    // `chosen`: the analysis that they measure; null: none.
    void setTimes(std::optional<double> a_s, std::optional<double> b_s, const Analysis* chosen);

signals:
    void edited(std::optional<double> a_s, std::optional<double> b_s);

private:
    void retranslate();
    void showDifference();

    std::array<QLabel*, 2> names_{};
    std::array<NumberField*, 2> fields_{};
    QLabel* difference_;
    bool outside_ = false;  // one of them where the chosen analysis has no windows
};

}  // namespace vybeg::ui
