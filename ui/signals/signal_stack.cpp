#include "ui/signals/signal_stack.h"

#include "ui/plots/plot_strip.h"
#include "ui/signals/signal_panel.h"

#include <QCoreApplication>

#include <algorithm>

namespace vybeg::ui {
namespace {

constexpr int paper_width = 900;
constexpr int paper_strips = 66;  // the rows above and below
constexpr int paper_panel_height = 170;

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

}  // namespace vybeg::ui
