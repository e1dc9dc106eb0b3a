#pragma once

#include "core/recording/open/preview.h"

#include <QStringList>
#include <QWidget>

#include <functional>
#include <optional>
#include <string>
#include <vector>

class QAction;
class QComboBox;
class QFormLayout;
class QLineEdit;
class QSpinBox;

namespace vybeg {
struct Bounds;
}

namespace vybeg::ui {

class NumberField;

using TakeFiles = std::function<void(const QStringList&)>;

// A field's words: its label, which is its accessible name, too, and its tip.
struct FieldWords {
    QString label;
    QString tip;
};

// Adds rows to a form, each a label and a field with the name of its object.
struct FormRows {
    QWidget* parent;
    QFormLayout* form;
    int characters;                         // of a list, at least
    std::function<void(QWidget*)> changed;  // follows each change of a field, also each key

    void add(const char* name, const FieldWords& words, QWidget* field) const;
    QComboBox* list(const char* name, const FieldWords& words, const QStringList& entries) const;
    NumberField* number(const char* name, const FieldWords& words, const Bounds& limits) const;
    QLineEdit* text(const char* name, const FieldWords& words) const;
};

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

private:
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

    QFormLayout* form_;
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
