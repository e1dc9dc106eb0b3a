#pragma once

#include "core/recording/open_recording.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QFormLayout;
class QGroupBox;
class QLabel;
class QLineEdit;
class QSpinBox;

namespace vybeg::ui {

class NumberField;

// How to read a file that does not tell all by itself: sample rate, which channels are C and D, and
// the layout of raw samples. Does not block the window.
class OpenOptionsDialog : public QDialog {
    Q_OBJECT

public:
    OpenOptionsDialog(const QString& path, const OpenOptions& options, QWidget* parent = nullptr);

    OpenOptions options() const;

signals:
    void chosen(const QString& path, const OpenOptions& options);

protected:
    void changeEvent(QEvent* event) override;

private:
    enum Row {
        rate,
        channel_c,
        channel_d,
        variables,
        raw_type,
        raw_order,
        raw_channels,
        raw_skip,
        raw_scale,
        row_count
    };

    void retranslate();

    QString path_;
    QLabel* title_;
    QLabel* labels_[row_count];
    NumberField* rate_;
    QSpinBox* channel_c_;
    QSpinBox* channel_d_;
    QLineEdit* variables_;
    QGroupBox* raw_;
    QComboBox* type_;
    QComboBox* order_;
    QSpinBox* channels_;
    NumberField* skip_;
    NumberField* scale_;
    QDialogButtonBox* buttons_;
};

}  // namespace vybeg::ui
