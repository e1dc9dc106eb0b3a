#include "ui/signals/signal_stack.h"

#include "ui/plots/plot_strip.h"
#include "ui/signals/signal_panel.h"
#include "ui/words/number_label.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vybeg::ui {

namespace {

constexpr int paper_width = 900;
constexpr int paper_strips = 66;  // the rows above and below
constexpr int paper_panel_height = 170;

// Six digits of the largest value in a plot.
int decimalsOf(const SignalPanel& panel) {
    const AxisRange range = panel.values();
    const double largest = std::max(std::abs(range.lower), std::abs(range.upper));
    return std::clamp(5 - static_cast<int>(std::floor(std::log10(largest))), 0, 15);
}

}  // namespace

SignalStack::SignalStack(QCustomPlot& plot, const std::vector<SignalPart>& parts, PlotHead head)
    : TimeStack(plot, 0, head) {
    for (const SignalPart part : parts) {
        panels_.push_back(new SignalPanel(&plot, part, head));
    }
    build({panels_.begin(), panels_.end()});
}

void SignalStack::setContent(SignalContent content, QSize size) {
    content_ = std::move(content);
    prepare(size);
    picture_ = pictureOf(content_, frameWidth(size.width()));
    for (SignalPanel* panel : panels_) {
        panel->setPicture(content_, picture_, plotFont(plot()));
    }
    setLook(content_.theme);
    if (head() == PlotHead::line) {
        showLegend();
    }
}

void SignalStack::showLegend() {
    const Theme& theme = content_.theme;
    std::vector<StripEntry> entries;
    const auto add = [&](const QString& text, const QColor& color) {
        entries.push_back({text, true, true, color, Qt::SolidLine});
    };
    const bool fitted = content_.analysis != nullptr;
    add(QStringLiteral("C"), theme.signalC);
    add(QStringLiteral("D"), theme.signalD);
    if (fitted && content_.wave) {
        add(picture_.smooth ? SignalWords::tr("fitted wave")
                            : SignalWords::tr("amplitude of the wave"),
            theme.text);
    }
    if (fitted && !picture_.samples) {
        add(SignalWords::tr("rms of the residual"), theme.mutedText);
    }
    headStrip().setEntries(std::move(entries), Qt::AlignLeft);
}

Figure signalFigure(SignalContent content, const std::vector<SignalPart>& parts) {
    content.theme = lightTheme();
    const QSize proposed(paper_width,
                         paper_strips + paper_panel_height * static_cast<int>(parts.size()));
    const Drawing draw = [content, parts](QCPPainter& painter, QSize size) {
        QCustomPlot plot;
        preparePlot(plot, content.theme);
        SignalStack stack(plot, parts, PlotHead::line);
        stack.setContent(content, size);
        plot.toPainter(&painter, size.width(), size.height());
    };
    return {draw, proposed, QStringLiteral("signals")};
}

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
