#pragma once

#include "core/recording/open/preview.h"

#include <QWidget>

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

class QAction;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QSpinBox;

namespace vybeg::ui {

class NumberField;

using TakeFiles = std::function<void(const QStringList&)>;

// Fields of an import. "Automatic" choices show the value from the content; only rows for the kind
// of file are visible. The fields are its only state.
class ImportFields : public QWidget {
    Q_OBJECT

public:
    explicit ImportFields(QWidget* parent = nullptr);

    // Emits no signal.
    void setOptions(const OpenOptions& options);
    OpenOptions options() const;
    void focusRate();
    // Whether every field that is shown has an acceptable text.
    bool isValid() const;
    // Sets the automatic values and the names of the channels from a preview of these options.
    void setPreview(const RecordingPreview& preview);

signals:
    // Emitted on every change, also on each key.
    void edited();
    // Files are to be chosen, which `take` names in a field.
    void filesWanted(const vybeg::ui::TakeFiles& take);

protected:
    void changeEvent(QEvent* event) override;

private:
    enum Row {
        read_as,
        delimiter,
        decimal,
        skip_lines,
        time_column,
        time_unit,
        raw_type,
        raw_order,
        raw_channels,
        raw_skip,
        variables,
        channel_d_file,
        join,
        channel_c,
        channel_d,
        rate,
        scale,
        unit,
        row_count
    };
    enum class ReadAs { content, text, raw };

    ReadAs readAs() const;
    bool isText() const;
    bool hasVariables() const;
    void addChoice(QLineEdit& field);
    void showChoices();
    void showRows();
    void showAutomatic();
    void showColumns();
    void showChannels(QComboBox& box);
    TextChoice textChoice() const;
    std::vector<std::string> pieces() const;
    RawLayout rawLayout() const;
    void retranslate();

    QFormLayout* form_;
    std::array<QLabel*, row_count> labels_{};
    std::array<QWidget*, row_count> fields_{};
    QComboBox* read_as_;
    QComboBox* delimiter_;
    QComboBox* decimal_;
    NumberField* skip_lines_;
    QComboBox* time_column_;
    QComboBox* time_unit_;
    QComboBox* raw_type_;
    QComboBox* raw_order_;
    QSpinBox* raw_channels_;
    NumberField* raw_skip_;
    QLineEdit* variables_;
    QLineEdit* channel_d_file_;
    QLineEdit* join_;
    QComboBox* channel_c_;
    QComboBox* channel_d_;
    NumberField* rate_;
    NumberField* scale_;
    QLineEdit* unit_;
    std::vector<std::string> pieces_;  // as they were set: a path may have commas
    std::vector<QAction*> choose_;
    std::optional<RecordingPreview> preview_;
};

}  // namespace vybeg::ui
