#pragma once

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

    // `outside`: one of them where the chosen analysis has no windows.
    void setTimes(std::optional<double> a_s, std::optional<double> b_s, bool outside);

signals:
    void edited(std::optional<double> a_s, std::optional<double> b_s);

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();
    void showDifference();

    std::array<QLabel*, 2> names_{};
    std::array<NumberField*, 2> fields_{};
    QLabel* difference_;
    std::optional<double> a_s_;
    std::optional<double> b_s_;
    bool outside_ = false;
};

}  // namespace vybeg::ui
