#pragma once

#include "core/analysis/identify_settings.h"
#include "core/analysis/settings.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/page_parts.h"

#include <QAbstractButton>

#include <array>
#include <functional>
#include <optional>
#include <type_traits>
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
    // The choices in a few words, for fields that are folded away.
    virtual QString summary() const { return {}; }
    // First field with a fault; null without.
    NumberField* faulty() const;

signals:
    void edited(const Settings& settings);

protected:
    // Source texts, marked with QT_TR_NOOP in the class that adds the widget: of a button or a
    // label its own text, of others that of the label beside them. The accessible name is the
    // label; `name` replaces it where several fields share a label.
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
    std::array<NumberField*, 2> addPair(const Texts& first, const char* second_name,
                                        const std::array<Bounds, 2>& limits);
    template <class Widget>
    Widget* withTexts(Widget* widget, const Texts& texts) {
        entries_.push_back({nullptr, widget, texts});
        return widget;
    }
    void addWide(QWidget* widget);
    // Parts side by side; `between` < 0: as the style has it.
    QWidget* addRow(LayoutParts parts, int between = -1);

    const SettingsState& state() const { return state_; }
    // Emits the settings as an edit changes them.
    template <class Edit>
    void change(Edit edit) {
        Settings settings = state_.settings;
        edit(settings);
        emit edited(settings);
    }
    // A field shows a number of the settings, which may be missing, and changes it: that which
    // `access` returns. `per_unit` units of the field are one of the setting's.
    template <class Access>
    void follow(NumberField* field, Access access, double per_unit = 1) {
        using Number = std::remove_cvref_t<std::invoke_result_t<Access, Settings&>>;
        field->setOptional(std::is_same_v<Number, std::optional<double>>);
        shown_.emplace_back([this, field, access, per_unit] {
            const std::optional<double> number = std::invoke(access, state_.settings);
            field->setValue(number ? std::optional(*number * per_unit) : std::nullopt);
        });
        connect(field, &NumberField::valueEdited, this, [this, access, per_unit](auto value) {
            change([&](Settings& settings) {
                std::invoke(access, settings) = value ? Number(*value / per_unit) : Number{};
            });
        });
    }
    template <class Access>
    void follow(QAbstractButton* box, Access access) {
        shown_.emplace_back(
            [this, box, access] { box->setChecked(std::invoke(access, state_.settings)); });
        connect(box, &QAbstractButton::clicked, this, [this, access](bool on) {
            change([&](Settings& settings) { std::invoke(access, settings) = on; });
        });
    }
    // A function that is called for each state, and in each language.
    void whenShown(std::function<void()> show) { shown_.push_back(std::move(show)); }
    // At the end of a group's constructor.
    void begin() {
        keepTranslated(*this, [this] { translate(); });
    }

private:
    struct Entry {
        QLabel* label;
        QWidget* widget;
        Texts texts;
        bool unit_in_label = false;
    };
    void translate();
    void refresh();

    QFormLayout* form_;
    SettingsState state_;
    std::vector<Entry> entries_;
    std::vector<std::function<void()>> shown_;
};

}  // namespace vybeg::ui
