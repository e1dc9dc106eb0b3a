#pragma once

#include "core/analysis/identify_settings.h"
#include "core/analysis/settings.h"
#include "ui/widgets/number_field.h"

#include <QWidget>

#include <optional>
#include <vector>

class QFormLayout;
class QLabel;

namespace vybeg::ui {

// State of the fields of the analysis panel: the settings and their references.
struct SettingsState {
    Settings settings;
    std::optional<double> f0_hz;    // carrier, typed or found
    std::optional<double> rate_hz;  // of the current recording
    std::optional<double> seconds;
    Tolerance tolerance;
};

// One group of fields of the analysis panel. It shows a state and emits edits; it has no other
// state.
class SettingsFields : public QWidget {
    Q_OBJECT

public:
    explicit SettingsFields(QWidget* parent = nullptr);

    void setState(const SettingsState& state);
    // First field with a fault; null without.
    NumberField* faulty() const;

signals:
    void edited(const Settings& settings);

protected:
    // Source texts, marked with QT_TR_NOOP in the class that adds the field. The accessible name is
    // the label; `name` replaces it where several fields share a label.
    struct Texts {
        const char* label;
        const char* unit;
        const char* tip;
        const char* name = nullptr;
    };

    // `unit` of the units of the limits are one of the field's.
    NumberField* addField(const Texts& texts, const Bounds& limits, double unit = 1);
    // A field that the caller puts into a row, and the line below it with the fault of some.
    NumberField* makeField(const Texts& texts);
    void addFaults(const std::vector<NumberField*>& fields);
    // Two fields side by side beside the first one's label, which says their unit.
    std::pair<NumberField*, NumberField*> addPair(const Texts& first, const Texts& second);
    void addWide(QWidget* widget);
    // With a translated tooltip, and the label as its accessible name.
    void addWide(QWidget* widget, const Texts& texts);

    const SettingsState& state() const { return state_; }
    // Emits the settings as an edit changes them.
    template <class Edit>
    void change(Edit edit) {
        Settings settings = state_.settings;
        edit(settings);
        emit edited(settings);
    }
    // Edits of a field go to a setting that may be missing.
    void follow(NumberField* field, std::optional<double> Settings::*member);
    virtual void refresh() = 0;
    virtual void retranslate();

private:
    struct Entry {
        QLabel* label;
        QWidget* widget;
        Texts texts;
        bool unit_in_label = false;
    };
    QLabel* makeLabel(QWidget* buddy);

    QFormLayout* form_;
    SettingsState state_;
    std::vector<Entry> entries_;
};

}  // namespace vybeg::ui
