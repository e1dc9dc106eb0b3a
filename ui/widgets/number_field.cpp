#include "ui/widgets/number_field.h"

#include "core/base/number_text.h"
#include "core/base/setting_rows.h"
#include "ui/widgets/page_parts.h"
#include "ui/words/display_units.h"

#include <QAction>
#include <QComboBox>
#include <QKeyEvent>
#include <QLocale>
#include <QPainter>
#include <QSignalBlocker>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace vybeg::ui {

std::optional<double> readNumber(QString text) {
    text.remove(QLatin1Char(' '));
    text.remove(QChar(0x00a0));
    text.remove(QChar(0x202f));
    text.replace(QLatin1Char(','), QLatin1Char('.'));
    text.replace(QChar(0x2212), QLatin1Char('-'));
    if (text.startsWith(QLatin1Char('+'))) {
        text.remove(0, 1);
    }
    const auto number = parse_number(text.toStdString());
    return number && std::isfinite(*number) ? number : std::nullopt;
}

namespace {

// Small numbers without a power of ten: "0.00001".
QString fieldText(double value, int digits) {
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    const QString text = locale.toString(value, 'g', digits);
    return text.contains(QLatin1Char('e'), Qt::CaseInsensitive)
               ? locale.toString(*readNumber(text), 'f', QLocale::FloatingPointShortest)
               : text;
}

}  // namespace

NumberField::NumberField(QWidget* parent) : QLineEdit(parent) {
    setAlignment(Qt::AlignRight);
    connect(this, &QLineEdit::editingFinished, this, &NumberField::commit);
    connect(this, &QLineEdit::textChanged, this, [this] {
        if (isValid()) {
            setRefusal({});
        }
        makeRoom();
        update();
    });
    whenChanged(*this, {QEvent::LanguageChange}, [this] {
        if (!isModified()) {
            showValue();
        } else if (!refusal_.isEmpty()) {
            setRefusal(read().refusal);
        }
    });
}

void NumberField::setUnit(const QString& unit) {
    unit_ = unit;
    makeRoom();
    updateGeometry();
    update();
}

void NumberField::setLimits(double lowest, double highest) {
    lowest_ = lowest;
    highest_ = highest;
    update();
}

void NumberField::setLimits(const Bounds& bounds, double unit) {
    setLimits(bounds.least / unit, bounds.most / unit);
}

void NumberField::setValue(std::optional<double> value) {
    if (isModified() && value == value_) {
        return;
    }
    value_ = value;
    showValue();
}

std::optional<double> NumberField::typed() const {
    return isModified() && isValid() ? readNumber(text()) : value_;
}

void NumberField::setConflict(const QString& sentence) {
    if (sentence != conflict_) {
        conflict_ = sentence;
        update();
        emit faultChanged();
    }
}

void NumberField::setRefusal(const QString& sentence) {
    if (sentence != refusal_) {
        refusal_ = sentence;
        emit faultChanged();
    }
}

void NumberField::showValue() {
    if (!value_) {
        setText({});
        return;
    }
    setText(integer_ ? QLocale().toString(static_cast<qint64>(std::llround(*value_)))
                     : fieldText(*value_, digits_));
}

NumberField::Reading NumberField::read() const {
    if (text().trimmed().isEmpty()) {
        return {std::nullopt, optional_ ? QString() : tr("A number is needed.")};
    }
    const auto number = readNumber(text());
    QString refusal;
    if (!number) {
        refusal = tr("“%1” is no number.").arg(text().trimmed());
    } else if (integer_ && std::floor(*number) != *number) {
        refusal = tr("A whole number is needed.");
    } else if (*number < lowest_) {
        refusal =
            lowest_ == std::numeric_limits<double>::min()
                ? tr("A number above zero is needed.")
                : tr("At least %1 is needed.").arg(groupedDigits(fieldText(lowest_, digits_)));
    } else if (*number > highest_) {
        refusal = tr("At most %1 is possible.").arg(groupedDigits(fieldText(highest_, digits_)));
    }
    return {number, refusal};
}

void NumberField::commit() {
    if (!isModified()) {
        return;
    }
    const Reading reading = read();
    setRefusal(reading.refusal);
    if (!reading.refusal.isEmpty()) {
        if (isVisible()) {
            QToolTip::showText(mapToGlobal(rect().bottomLeft()), reading.refusal, this);
        }
        return;
    }
    setModified(false);
    const bool changed = value_ != reading.value;
    value_ = reading.value;
    showValue();
    if (changed) {
        emit valueEdited(value_);
    }
}

// Whether a key that a line edit would consume, on X11 also Ctrl+E, is the shortcut of a command.
bool NumberField::isForTheWindow(const QKeyEvent& key) const {
    if (!key.text().isEmpty() && key.text().front().isPrint() &&
        !(key.modifiers() & (Qt::ControlModifier | Qt::AltModifier))) {
        return false;  // it is typed
    }
    const bool own_undo = isModified() && isUndoAvailable() && key.matches(QKeySequence::Undo);
    const bool own_redo = isRedoAvailable() && key.matches(QKeySequence::Redo);
    if (own_undo || own_redo) {
        return false;
    }
    const auto is_command = [pressed = QKeySequence(key.keyCombination())](const QAction* action) {
        return action->isEnabled() && action->shortcutContext() == Qt::WindowShortcut &&
               action->shortcuts().contains(pressed);
    };
    const QWidget* window = this->window();
    while (window && !std::ranges::any_of(window->findChildren<QAction*>(), is_command)) {
        // A floating panel forwards its keys to its parent window.
        window = window->parentWidget() ? window->parentWidget()->window() : nullptr;
    }
    return window != nullptr;
}

bool NumberField::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride &&
        isForTheWindow(*static_cast<QKeyEvent*>(event))) {
        event->ignore();
        return true;
    }
    return QLineEdit::event(event);
}

void NumberField::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && isModified()) {
        showValue();
        setModified(false);
        return;
    }
    if (event->key() == Qt::Key_Up || event->key() == Qt::Key_Down) {
        const Reading reading = read();
        if (reading.refusal.isEmpty() && reading.value) {
            const double sign = event->key() == Qt::Key_Up ? 1 : -1;
            const double stepped = *reading.value + sign * step_;
            if (stepped >= lowest_ && stepped <= highest_) {
                value_ = stepped;
                showValue();
                emit valueEdited(value_);
            }
        }
        return;
    }
    QLineEdit::keyPressEvent(event);
}

void NumberField::setPlaceholderText(const QString& text) {
    QLineEdit::setPlaceholderText(text);
    makeRoom();
}

// No unit after a placeholder in words ("as the window"), which needs the room itself.
bool NumberField::showsUnit() const {
    return !unit_.isEmpty() && (!text().isEmpty() || placeholderText().isEmpty() ||
                                readNumber(placeholderText()).has_value());
}

QSize NumberField::minimumSizeHint() const {
    QSize size = QLineEdit::minimumSizeHint();
    size.setWidth(fontMetrics().horizontalAdvance(QStringLiteral("00000000")) + unitWidth() + 14);
    return size;
}

void NumberField::paintEvent(QPaintEvent* event) {
    QLineEdit::paintEvent(event);
    if (showsUnit()) {
        QPainter painter(this);
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(rect().adjusted(0, 0, -6, 0), Qt::AlignRight | Qt::AlignVCenter, unit_);
    }
    if ((!isValid() || !conflict_.isEmpty()) && isEnabled()) {
        frameFault(*this);
    }
}

void frameFault(QWidget& field) {
    QPainter painter(&field);
    painter.setPen(QPen(QColor(0xd5, 0x3e, 0x2a), 2));
    painter.setRenderHint(QPainter::Antialiasing);
    painter.drawRoundedRect(QRectF(field.rect()).adjusted(1, 1, -1, -1), 2, 2);
}

void enterTyped(QWidget& window) {
    QWidget* const focus = window.focusWidget();
    const auto* box = qobject_cast<QComboBox*>(focus);
    QLineEdit* const field = box ? box->lineEdit() : qobject_cast<QLineEdit*>(focus);
    if (field && field->isModified()) {
        emit field->editingFinished();
    }
}

void dropTyped(QWidget& window) {
    if (QWidget* field = window.focusWidget()) {
        const QSignalBlocker quiet(field);
        field->clearFocus();
    }
}

}  // namespace vybeg::ui

#include "moc_number_field.cpp"
