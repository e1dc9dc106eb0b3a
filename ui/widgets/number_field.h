#pragma once

#include <QLineEdit>

#include <limits>
#include <optional>

namespace vybeg {
struct Bounds;
}

namespace vybeg::ui {

// A field for one number with its unit inside the frame. Accepts decimal point and decimal comma in
// any language; shows that of the interface's language. Empty means "no value", if allowed. An
// invalid text is framed in red with the reason and not emitted; Escape restores the last value. Up
// and Down step. The window's shortcuts work in it; undo and redo are those of the field while it
// has typing to undo.
class NumberField : public QLineEdit {
    Q_OBJECT
    Q_PROPERTY(QString unit READ unit WRITE setUnit)

public:
    explicit NumberField(QWidget* parent = nullptr);

    void setUnit(const QString& unit);
    void setPlaceholderText(const QString& text);  // hides that of QLineEdit
    QString unit() const { return unit_; }
    // Inclusive limits, in the unit of the field.
    void setLimits(double lowest, double highest);
    // Those of core, `unit` of whose units are one of the field's.
    void setLimits(const Bounds& bounds, double unit = 1);
    void setInteger(bool integer) { integer_ = integer; }
    void setOptional(bool optional) { optional_ = optional; }
    void setStep(double step) { step_ = step; }
    // Significant digits shown.
    void setDigits(int digits) { digits_ = digits; }

    // Shows a value without emitting an edit. Keeps text being typed if the value is the same.
    void setValue(std::optional<double> value);
    std::optional<double> value() const { return value_; }
    // The number that is being typed; otherwise the value, which may have more digits than are
    // shown.
    std::optional<double> typed() const;
    // Applies the text as on leaving the field.
    void commit();
    // Reason why the committed text is no value; otherwise the conflict of setConflict(). Empty:
    // none.
    QString fault() const { return refusal_.isEmpty() ? conflict_ : refusal_; }
    // Sets the reason for which the value contradicts other fields.
    void setConflict(const QString& sentence);
    // Whether the present text is acceptable.
    bool isValid() const { return read().refusal.isEmpty(); }

    QSize minimumSizeHint() const override;
    QSize sizeHint() const override { return minimumSizeHint(); }

signals:
    // The user finished an edit that changed the value.
    void valueEdited(std::optional<double> value);
    void faultChanged();

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    struct Reading {
        std::optional<double> value;
        QString refusal;  // empty: a value
    };
    Reading read() const;
    bool isForTheWindow(const QKeyEvent& key) const;
    void setRefusal(const QString& sentence);
    void showValue();
    bool showsUnit() const;
    void makeRoom() { setTextMargins(0, 0, showsUnit() ? unitWidth() : 0, 0); }
    int unitWidth() const {
        return unit_.isEmpty() ? 0 : fontMetrics().horizontalAdvance(unit_) + 6;
    }

    QString unit_;
    std::optional<double> value_;
    QString refusal_;
    QString conflict_;
    double lowest_ = -std::numeric_limits<double>::max();
    double highest_ = std::numeric_limits<double>::max();
    double step_ = 1;
    int digits_ = 10;
    bool integer_ = false;
    bool optional_ = false;
};

// Frames a field whose text is refused, in red.
void frameFault(QWidget& field);

// The number in a text with a decimal point or comma, spaces and typographic minus allowed; empty
// for other texts.
std::optional<double> readNumber(QString text);

// A text being typed into a field of the window counts, as after any other step out of the field.
void enterTyped(QWidget& window);
// It counts no more: a field that loses the focus as it goes would enter it in an object that is
// gone already.
void dropTyped(QWidget& window);

}  // namespace vybeg::ui
