#include "ui/batch/batch_message.h"

#include "ui/widgets/theme.h"

#include <QEvent>
#include <QStringList>

#include <utility>

namespace vybeg::ui {

BatchMessage::BatchMessage(QWidget* parent) : QLabel(parent) {
    setObjectName(QStringLiteral("batchMessage"));
    setWordWrap(true);
    setTextFormat(Qt::PlainText);
    setTextInteractionFlags(Qt::TextSelectableByMouse);
    hide();
}

void BatchMessage::begin() {
    warnings_.clear();
    end_ = nullptr;
    fault_ = false;
    refresh();
}

void BatchMessage::warn(Text text) {
    warnings_.push_back(std::move(text));
    refresh();
}

void BatchMessage::end(Text text, bool fault) {
    end_ = std::move(text);
    fault_ = fault;
    refresh();
}

void BatchMessage::refresh() {
    QStringList lines;
    for (const Text& warning : warnings_) {
        lines << QStringLiteral("⚠ ") + warning();
    }
    if (end_) {
        lines << end_();
    }
    setText(lines.join(QLatin1Char('\n')));
    setVisible(!lines.isEmpty());
    color();
}

void BatchMessage::color() {
    const QPalette usual = parentWidget()->palette();
    QPalette colors = usual;
    if (fault_) {
        colors.setColor(QPalette::WindowText, (isDark(usual) ? darkTheme() : lightTheme()).broken);
    }
    if (palette() != colors) {
        setPalette(colors);
    }
}

void BatchMessage::changeEvent(QEvent* event) {
    QLabel::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        color();
    }
}

}  // namespace vybeg::ui
