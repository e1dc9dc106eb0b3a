#include "ui/signals/signal_overlay.h"

#include "ui/plots/hair_line.h"
#include "ui/signals/signal_panel.h"
#include "ui/signals/signal_stack.h"
#include "ui/words/number_label.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace vybeg::ui {
namespace {

// Six digits of the largest value in a plot.
int decimalsOf(const SignalPanel& panel) {
    const QCPRange range = panel.valueAxis()->range();
    const double largest = std::max(std::abs(range.lower), std::abs(range.upper));
    return std::clamp(5 - static_cast<int>(std::floor(std::log10(largest))), 0, 15);
}

}  // namespace

SignalOverlay::SignalOverlay(QCustomPlot* plot, const SignalStack& stack, const TrackView& tracks)
    : QCPLayerable(plot, QStringLiteral("overlay")), stack_(stack), tracks_(tracks) {
    plot->layer(QStringLiteral("overlay"))->setMode(QCPLayer::lmBuffered);
}

void SignalOverlay::applyDefaultAntialiasingHint(QCPPainter* painter) const {
    painter->setAntialiasing(false);
}

void SignalOverlay::draw(QCPPainter* painter) {
    const Theme& theme = stack_.content().theme;
    const QFont& font = stack_.panels().front()->headFont();
    const auto hair = [&](std::optional<double> time_s, const QColor& color, const char* name) {
        if (time_s) {
            drawHair(*painter, stack_.frames(), *time_s,
                     {color, QLatin1String(name), font, theme.plotBackground});
        }
    };
    hair(tracks_.cursor(Cursor::a), theme.cursorA, "A");
    hair(tracks_.cursor(Cursor::b), theme.cursorB, "B");
    hair(tracks_.tracker(), theme.tracker, "");
    for (const SignalPanel* panel : stack_.panels()) {
        drawReadout(*painter, *panel);
    }
    if (part_) {
        QColor fill = theme.accent;
        fill.setAlphaF(0.15F);
        painter->setPen(QPen(theme.accent, 1));
        painter->setBrush(fill);
        const QRect top = stack_.panels().front()->rect();
        const QRect bottom = stack_.panels().back()->rect();
        painter->drawRect(
            QRectF(part_->lower, top.top(), part_->span(), bottom.bottom() - top.top()));
        painter->setBrush(Qt::NoBrush);
    }
}

void SignalOverlay::drawReadout(QCPPainter& painter, const SignalPanel& panel) const {
    const SignalContent& content = stack_.content();
    const auto& excerpt = content.excerpt;
    if (!tracks_.tracker() || !stack_.picture().samples || !excerpt) {
        return;
    }
    const double k =
        std::round(*tracks_.tracker() * excerpt->rate_hz) - static_cast<double>(excerpt->first);
    if (!(k >= 0 && k < static_cast<double>(excerpt->size()))) {
        return;
    }
    const auto at = static_cast<std::size_t>(k);
    const int decimals = decimalsOf(panel);
    const auto number = [&](double value) {
        return std::isfinite(value) ? numberLabel(value, decimals) : QStringLiteral("—");
    };
    QString text;
    if (panel.part() == SignalPart::residual) {
        if (!content.analysis) {
            return;
        }
        text = QStringLiteral("C %1   D %2")
                   .arg(number(excerpt->residual_c(at)), number(excerpt->residual_d(at)));
    } else {
        const bool d = panel.part() == SignalPart::d;
        text = signalsText(QT_TRANSLATE_NOOP("SignalStack", "sample %1"))
                   .arg(number(d ? excerpt->d[at] : excerpt->c[at]));
        if (content.analysis) {
            text += QStringLiteral("   ") +
                    signalsText(QT_TRANSLATE_NOOP("SignalStack", "wave %1"))
                        .arg(number(d ? excerpt->fit_d[at] : excerpt->fit_c[at]));
        }
    }
    painter.setFont(panel.headFont());
    painter.setPen(content.theme.text);
    painter.drawText(panel.readoutArea(), int(Qt::AlignRight | Qt::AlignVCenter), text);
}

}  // namespace vybeg::ui
