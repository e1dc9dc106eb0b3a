#pragma once

#include "ui/history/history_view.h"

#include <QWidget>

#include <optional>
#include <string>
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
    QLabel* gyro_label_;
    QComboBox* gyro_;
    QLabel* parameter_label_;
    QComboBox* parameter_;
    QLabel* axis_label_;
    QComboBox* axis_;
    QLabel* baseline_label_;
    QSpinBox* baseline_;
    QGridLayout* grid_;
};

}  // namespace vybeg::ui
