#include "ui/signals/signal_overlay.h"

#include "ui/signals/signal_panel.h"
#include "ui/signals/signal_stack.h"
#include "ui/words/number_label.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vybeg::ui {
namespace {

// Six digits of the largest value in a plot.
int decimalsOf(const SignalPanel& panel) {
    const AxisRange range = panel.values();
    const double largest = std::max(std::abs(range.lower), std::abs(range.upper));
    return std::clamp(5 - static_cast<int>(std::floor(std::log10(largest))), 0, 15);
}

}  // namespace

SignalOverlay::SignalOverlay(const SignalStack& stack, std::function<HairLines()> hairs)
    : TimeOverlay(stack, std::move(hairs)), stack_(stack) {}

void SignalOverlay::draw(QCPPainter* painter) {
    for (const SignalPanel* panel : stack_.panels()) {
        drawNote(*painter, *panel);
    }
    TimeOverlay::draw(painter);
}

// The values at the mouse; without them, what the curves are.
QString SignalOverlay::note(const SignalPanel& panel) const {
    const SignalContent& content = stack_.content();
    const bool residual = panel.part() == SignalPart::residual;
    if (residual && !content.analysis) {
        return {};
    }
    const auto& excerpt = content.excerpt;
    const auto tracker = hairs().tracker;
    const double k =
        tracker && stack_.picture().samples && excerpt
            ? std::round(*tracker * excerpt->rate_hz) - static_cast<double>(excerpt->first)
            : -1;
    if (!(k >= 0 && k < static_cast<double>(excerpt ? excerpt->size() : 0))) {
        if (residual) {
            return stack_.picture().samples ? QString() : SignalWords::tr("rms of the residual");
        }
        return !content.analysis || !content.wave ? QString()
               : stack_.picture().smooth          ? SignalWords::tr("fitted wave")
                                                  : SignalWords::tr("amplitude of the wave");
    }
    const auto at = static_cast<std::size_t>(k);
    const int decimals = decimalsOf(panel);
    const auto number = [&](double value) {
        return std::isfinite(value) ? numberLabel(value, decimals) : QStringLiteral("—");
    };
    if (residual) {
        return QStringLiteral("C %1   D %2")
            .arg(number(excerpt->residual_c(at)), number(excerpt->residual_d(at)));
    }
    const bool d = panel.part() == SignalPart::d;
    QString text = SignalWords::tr("sample %1").arg(number(d ? excerpt->d[at] : excerpt->c[at]));
    if (content.analysis) {
        text += QStringLiteral("   ") +
                SignalWords::tr("wave %1").arg(number(d ? excerpt->fit_d[at] : excerpt->fit_c[at]));
    }
    return text;
}

void SignalOverlay::drawNote(QCPPainter& painter, const SignalPanel& panel) const {
    const QString text = note(panel);
    if (text.isEmpty()) {
        return;
    }
    const Theme& theme = stack_.content().theme;
    painter.setFont(panel.font());
    const QRectF area = QRectF(panel.rect()).adjusted(6, 2, -6, -2);
    const QRectF box =
        painter.boundingRect(area, int(Qt::AlignRight | Qt::AlignTop), text).adjusted(-4, 0, 4, 0);
    QColor plate = theme.panelBackground;
    plate.setAlphaF(0.8F);
    painter.fillRect(box, plate);
    painter.setPen(theme.text);
    painter.drawText(box, int(Qt::AlignCenter), text);
}

}  // namespace vybeg::ui
