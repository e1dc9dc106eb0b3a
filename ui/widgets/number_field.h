#pragma once

#include <QLineEdit>

#include <limits>
#include <optional>

namespace vybeg::ui {

// A field for one number with its unit inside the frame. Takes a decimal point and a decimal comma,
// whatever the language; shows the one of the interface's language. Empty means "no value", where
// that is allowed. What cannot be a value is framed in red and never leaves the field, which says
// why; Escape brings the last value back. Up and Down step. The window's shortcuts work in it; undo
// and redo are its own as long as there is typing to undo.
class NumberField : public QLineEdit {
    Q_OBJECT
    Q_PROPERTY(QString unit READ unit WRITE setUnit)

public:
    explicit NumberField(QWidget* parent = nullptr);

    void setUnit(const QString& unit);
    QString unit() const { return unit_; }
    // Inclusive limits, in the unit of the field.
    void setLimits(double lowest, double highest);
    void setInteger(bool integer) { integer_ = integer; }
    void setOptional(bool optional) { optional_ = optional; }
    void setStep(double step) { step_ = step; }
    // Significant digits shown.
    void setDigits(int digits) { digits_ = digits; }

    // Shows a value; emits no edit. What is being typed stays as long as the value is the same.
    void setValue(std::optional<double> value);
    std::optional<double> value() const { return value_; }
    // Takes the text over as leaving the field does.
    void commit();
    // Why the text, as it was left, is no value; else what setConflict() told. Empty: all is well.
    QString fault() const { return refusal_.isEmpty() ? conflict_ : refusal_; }
    // Why the value does not go together with those of other fields.
    void setConflict(const QString& sentence);
    // Whether the text as it stands is acceptable.
    bool isValid() const;

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
    void changeEvent(QEvent* event) override;

private:
    struct Reading {
        std::optional<double> value;
        QString refusal;  // empty: a value
    };
    Reading read() const;
    QString refusalOf(std::optional<double> number) const;
    bool isForTheWindow(const QKeyEvent& key) const;
    void setRefusal(const QString& sentence);
    void show();
    int unitWidth() const;

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

// The number in a text with a decimal point or comma, spaces and typographic minus allowed; nothing
// where it is no finite number.
std::optional<double> readNumber(QString text);

}  // namespace vybeg::ui
