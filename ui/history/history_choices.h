#pragma once

#include "ui/history/history_view.h"

#include <QWidget>

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

class QComboBox;
class QGridLayout;
class QLabel;
class QSpinBox;

namespace vybeg::ui {

// What of a database is shown: gyro, parameter, axis and baseline, which is kept between sessions.
class HistoryChoices : public QWidget {
    Q_OBJECT

public:
    explicit HistoryChoices(QWidget* parent = nullptr);

    // The chosen gyro stays chosen where it is among them.
    void setGyros(const std::vector<StoredGyro>& gyros);
    void chooseAllGyros();
    std::optional<std::string> gyro() const;  // nothing: all
    const HistoryParameter& parameter() const;
    HistoryAxis axis() const;
    // Results that set the limits.
    std::size_t baseline() const;

signals:
    void dataWanted();
    void limitsChanged();
    void axisChanged();

private:
    void place(int in_a_row);
    void retranslate();

    std::vector<StoredGyro> gyros_;
    QComboBox* gyro_;
    QComboBox* parameter_;
    QComboBox* axis_;
    QSpinBox* baseline_;
    std::array<std::pair<QLabel*, QWidget*>, 4> choices_;
    QGridLayout* grid_;
};

}  // namespace vybeg::ui
