#include "ui/signals/signal_stack.h"

#include "ui/plots/envelope_paint.h"
#include "ui/plots/plot_strip.h"
#include "ui/words/display_units.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vybeg::ui {

namespace {

constexpr double samples_in_pixel = 4;
constexpr double points_in_period = 12;
constexpr double least_period = 8;  // pixels of a period that is seen
constexpr double margin = 0.06;
constexpr double note_inset = 2;  // pixels between the frame and a note

AxisRange withMargin(const Extent& extent) {
    if (extent.low > extent.high) {
        return {-1, 1};
    }
    const double span =
        std::max(extent.high - extent.low, 1e-9 * std::max(std::abs(extent.low), extent.high));
    const double beyond = span > 0 ? margin * span : 1;
    return {extent.low - beyond, extent.high + beyond};
}

// Columns of a whole number of widths from the start of the recording, so that a signal that is
// panned does not flicker.
void addColumns(const SignalContent& content, int width, SignalPicture& picture) {
    const auto frames = static_cast<double>(content.envelope->frames());
    const double step = content.time.span() * content.rate_hz / width;
    const double first = std::floor(content.time.lower * content.rate_hz / step) * step;
    const auto from = static_cast<std::int64_t>(std::clamp(first, 0., frames));
    const auto to = static_cast<std::int64_t>(std::clamp(first + (width + 1) * step, 0., frames));
    if (from >= to) {
        return;
    }
    const double count = static_cast<double>(to - from) / step;
    picture.columns =
        content.envelope->buckets(from, to, std::max(1, static_cast<int>(std::lround(count))));
    picture.columns_from_s = static_cast<double>(from) / content.rate_hz;
    picture.columns_to_s = static_cast<double>(to) / content.rate_hz;
}

void addSamples(const SignalContent& content, SignalPicture& picture) {
    const SignalExcerpt& excerpt = *content.excerpt;
    const auto place = [&](double time_s, double beyond) {
        const double k = time_s * content.rate_hz - static_cast<double>(excerpt.first) + beyond;
        return static_cast<std::size_t>(std::clamp(k, 0., static_cast<double>(excerpt.size())));
    };
    picture.from = place(content.time.lower, -1);
    picture.to = place(content.time.upper, 2);
    picture.whole = covers(excerpt, content.time, content.frames);
}

void addWave(const SignalContent& content, int width, SignalPicture& picture) {
    const AxisRange& time = content.time;
    const double periods = content.analysis->f0_hz() * time.span();
    picture.period_pixels = width / periods;
    picture.smooth = picture.samples && picture.period_pixels >= least_period;
    if (picture.smooth) {
        const int points = static_cast<int>(std::max(points_in_period * periods, 0.5 * width));
        picture.wave =
            wave_curve(*content.analysis, content.rate_hz, time.lower, time.upper, 2 + points);
    } else {
        picture.wave =
            amplitude_curve(*content.analysis, content.rate_hz, time.lower, time.upper, width);
    }
}

struct Channel {
    double gain;
    double offset;
    QColor color;
    ChannelRange EnvelopeBucket::*range;
};

Channel channelOf(const SignalContent& content, bool d) {
    const Calibration& calibration = content.calibration;
    return d ? Channel{calibration.kappa, calibration.offset_d, content.theme.signalD,
                       &EnvelopeBucket::d}
             : Channel{1, calibration.offset_c, content.theme.signalC, &EnvelopeBucket::c};
}

void addSignal(const SignalContent& content, const SignalPicture& picture, bool d, Extent& extent) {
    const Channel channel = channelOf(content, d);
    for (const EnvelopeBucket& column : picture.columns) {
        const ChannelRange& range = column.*channel.range;
        extent.add(channel.gain * (static_cast<double>(range.min) - channel.offset));
        extent.add(channel.gain * (static_cast<double>(range.max) - channel.offset));
    }
    if (picture.samples && content.excerpt) {
        for (const double value : d ? content.excerpt->d : content.excerpt->c) {
            extent.add(value);
        }
    }
    for (const double value : d ? picture.wave.d : picture.wave.c) {
        extent.add(value);
        if (!picture.smooth) {
            extent.add(-value);
        }
    }
}

void addResidual(const SignalContent& content, const SignalPicture& picture, Extent& extent) {
    const auto both = [&](double value) {
        extent.add(value);
        extent.add(-value);
    };
    if (picture.samples && content.excerpt) {
        for (std::size_t k = 0; k < content.excerpt->size(); ++k) {
            both(content.excerpt->residual_c(k));
            both(content.excerpt->residual_d(k));
        }
    }
    for (const CurveColumn& column : picture.rms) {
        both(column.max);
    }
}

}  // namespace

bool fewSamples(const AxisRange& time, double rate_hz, int width) {
    return rate_hz > 0 && time.span() * rate_hz <= samples_in_pixel * width;
}

bool covers(const SignalExcerpt& excerpt, const AxisRange& time, std::int64_t frames) {
    const double first = std::max(0., std::ceil(time.lower * excerpt.rate_hz));
    const double end = std::min(static_cast<double>(frames), time.upper * excerpt.rate_hz);
    return static_cast<double>(excerpt.first) <= first &&
           static_cast<double>(excerpt.first) + static_cast<double>(excerpt.size()) >= end;
}

SignalPicture pictureOf(const SignalContent& content, int width) {
    SignalPicture picture;
    if (!(content.rate_hz > 0) || !(content.time.span() > 0)) {
        return picture;
    }
    picture.samples = fewSamples(content.time, content.rate_hz, width);
    if (picture.samples && content.excerpt) {
        addSamples(content, picture);
    }
    if (!picture.whole) {
        if (content.envelope) {
            addColumns(content, width, picture);
        }
        if (content.rms) {
            picture.rms = content.rms->columns(content.time, width);
        }
    }
    if (content.wave && content.analysis) {
        addWave(content, width, picture);
    }
    return picture;
}

AxisRange valuesOf(const SignalContent& content, const SignalPicture& picture, SignalPart part) {
    Extent extent;
    switch (part) {
        case SignalPart::c: addSignal(content, picture, false, extent); break;
        case SignalPart::d: addSignal(content, picture, true, extent); break;
        case SignalPart::residual: addResidual(content, picture, extent); break;
    }
    return withMargin(extent);
}

namespace {

struct SignalWords {
    Q_DECLARE_TR_FUNCTIONS(SignalStack)
};

constexpr double dots_apart = 4;  // pixels from which on samples are dots
constexpr double large_dots_apart = 10;
constexpr double dense = 0.7;         // pixels below which samples share columns
constexpr double smooth_period = 24;  // pixels of a period that is drawn without steps

// Segments between finite neighbours. Drawn one by one they cost a hundredth of a polyline whose
// parts overlap.
QVector<QLineF> segmentsOf(const QPolygonF& points) {
    QVector<QLineF> lines;
    lines.reserve(points.size());
    for (qsizetype k = 1; k < points.size(); ++k) {
        if (std::isfinite(points[k - 1].y()) && std::isfinite(points[k].y())) {
            lines.append({points[k - 1], points[k]});
        }
    }
    return lines;
}

// The same as one vertical line for each pixel column, which reaches to the column before.
QVector<QLineF> columnsOf(const QPolygonF& points) {
    QVector<QLineF> lines;
    double last = std::nan("");
    for (qsizetype k = 0; k < points.size();) {
        const double column = std::floor(points[k].x());
        double low = last;
        double high = last;
        for (; k < points.size() && std::floor(points[k].x()) == column; ++k) {
            last = points[k].y();
            low = std::fmin(low, last);
            high = std::fmax(high, last);
        }
        if (std::isfinite(low)) {
            lines.append({column, low, column, high + 1});
        }
    }
    return lines;
}

constexpr int paper_width = 900;
constexpr int paper_strips = 66;  // the rows above and below
constexpr int paper_panel_height = 170;

// Six digits of the largest value in a plot.
int decimalsOf(const TimePanel& panel) {
    const AxisRange range = panel.values();
    const double largest = std::max(std::abs(range.lower), std::abs(range.upper));
    return std::clamp(5 - static_cast<int>(std::floor(std::log10(largest))), 0, 15);
}

// What one plot of the signals draws: minima and maxima with the amplitude of the fitted wave, or
// samples as dots with thin lines between them and the wave itself; of the residual the rms of the
// windows or its samples.
class SignalGraph : public TimeGraph {
public:
    // Content and picture outlive its drawings.
    SignalGraph(QCPAxis* keyAxis, QCPAxis* valueAxis, SignalPart part, const SignalContent& content,
                const SignalPicture& picture)
        : TimeGraph(keyAxis, valueAxis), part_(part), content_(content), picture_(picture) {}

protected:
    void draw(QCPPainter* painter) override {
        const bool some = picture_.samples && content_.excerpt && picture_.to > picture_.from;
        if (!picture_.columns.empty() || !picture_.rms.empty()) {
            painter->save();
            if (some) {
                // Beside the samples that are there already.
                const QRectF all(clipRect());
                const double from = x(content_.excerpt->time_s(picture_.from));
                const double to = x(content_.excerpt->time_s(picture_.to - 1));
                QRegion beside(clipRect());
                beside -= QRectF(from, all.top(), to - from, all.height()).toAlignedRect();
                painter->setClipRegion(beside, Qt::IntersectClip);
            }
            part_ == SignalPart::residual ? drawRms(*painter) : drawColumns(*painter);
            painter->restore();
        }
        if (part_ == SignalPart::residual) {
            if (some && content_.analysis) {
                drawDots(*painter, points([](const auto& e, auto k) { return e.residual_c(k); }),
                         content_.theme.signalC);
                drawDots(*painter, points([](const auto& e, auto k) { return e.residual_d(k); }),
                         content_.theme.signalD);
            }
            return;
        }
        const QColor ink = channelOf(content_, isD()).color;
        QPolygonF samples;
        if (some) {
            samples = points([d = isD()](const auto& e, auto k) { return d ? e.d[k] : e.c[k]; });
            const bool dotted = samplesApart() >= dots_apart;
            drawLines(*painter, samples, dotted ? translucent(ink, 0.45) : ink);
            drawLost(*painter);
        }
        drawCurve(*painter, 1);
        if (!picture_.smooth) {
            drawCurve(*painter, -1);
        }
        if (some && samplesApart() >= dots_apart) {
            drawDots(*painter, samples, ink);
        }
    }

private:
    bool isD() const { return part_ == SignalPart::d; }
    double x(double time_s) const { return mKeyAxis->coordToPixel(time_s); }
    double y(double value) const { return mValueAxis->coordToPixel(value); }
    // Pixels.
    double samplesApart() const { return std::abs(x(1 / content_.rate_hz) - x(0)); }

    // Visible samples, by a value of the excerpt, as points of the plot.
    template <class Value>
    QPolygonF points(Value value) const {
        QPolygonF list;
        list.reserve(static_cast<qsizetype>(picture_.to - picture_.from));
        for (std::size_t k = picture_.from; k < picture_.to; ++k) {
            const double stored = value(*content_.excerpt, k);
            list.append(
                {x(content_.excerpt->time_s(k)), std::isfinite(stored) ? y(stored) : std::nan("")});
        }
        return list;
    }

    void drawColumns(QCPPainter& painter) const {
        if (picture_.columns.empty()) {
            return;
        }
        const double from = x(picture_.columns_from_s);
        const double to = x(picture_.columns_to_s);
        const QRectF area(from, clipRect().top(), to - from, clipRect().height());
        const ColumnRow row{area, (to - from) / static_cast<double>(picture_.columns.size())};
        const Channel channel = channelOf(content_, isD());
        const double scale = channel.gain * (y(0) - y(1));
        painter.setAntialiasing(false);
        paintEnvelope(painter, row, picture_.columns,
                      {{channel.color, y(0) + scale * channel.offset, scale, channel.range}},
                      content_.theme);
    }

    // Between minus and plus the rms a pale band, and what lies between the least and the largest
    // rms of a column in full.
    void drawRms(QCPPainter& painter) const {
        QVector<QLineF> band;
        QVector<QLineF> rims;
        if (picture_.rms.empty()) {
            return;
        }
        // Windows may be wider than a pixel.
        const double half =
            0.5 * static_cast<double>(content_.analysis->plan.hop) / content_.rate_hz;
        double next = clipRect().left();  // the first pixel that is not drawn yet
        for (const CurveColumn& column : picture_.rms) {
            if (column.empty()) {
                continue;
            }
            const double from = std::floor(x(column.time_first - half));
            const double to = std::min(std::max(from, x(column.time_last + half) - 1),
                                       static_cast<double>(clipRect().right()));
            for (next = std::max(next, from); next <= to; ++next) {
                band.append({next, y(-column.min), next, y(column.min)});
                for (const double sign : {-1, 1}) {
                    rims.append(
                        {next, y(sign * column.min) - 0.5, next, y(sign * column.max) + 0.5});
                }
            }
        }
        const QColor pale = translucent(content_.theme.text, 0.16);
        painter.setAntialiasing(false);
        painter.setPen(QPen(pale, 1, Qt::SolidLine, Qt::FlatCap));
        painter.drawLines(band);
        painter.setPen(QPen(content_.theme.mutedText, 1, Qt::SolidLine, Qt::FlatCap));
        painter.drawLines(rims);
    }

    void drawLines(QCPPainter& painter, const QPolygonF& points, const QColor& color) const {
        const double apart = samplesApart();
        painter.setAntialiasing(apart >= dots_apart);
        painter.setPen(QPen(color, 1, Qt::SolidLine, Qt::FlatCap));
        painter.drawLines(apart < dense ? columnsOf(points) : segmentsOf(points));
    }

    void drawCurve(QCPPainter& painter, double sign) const {
        const SignalCurve& curve = picture_.wave;
        const std::vector<double>& values = isD() ? curve.d : curve.c;
        QPolygonF points;
        points.reserve(static_cast<qsizetype>(values.size()));
        for (std::size_t k = 0; k < values.size(); ++k) {
            points.append({x(curve.time_s[k]),
                           std::isfinite(values[k]) ? y(sign * values[k]) : std::nan("")});
        }
        const bool fine = !picture_.smooth || picture_.period_pixels >= smooth_period;
        painter.setAntialiasing(fine);
        painter.setPen(QPen(content_.theme.text, fine ? 1.4 : 1, Qt::SolidLine, Qt::FlatCap));
        painter.drawLines(segmentsOf(points));
    }

    void drawDots(QCPPainter& painter, const QPolygonF& points, const QColor& color) const {
        const double apart = samplesApart();
        const double radius = apart < 1                  ? 0.5
                              : apart < dots_apart       ? 1
                              : apart < large_dots_apart ? 1.8
                                                         : 2.8;
        painter.setAntialiasing(apart >= dots_apart);
        painter.setPen(Qt::NoPen);
        painter.setBrush(color);
        QVector<QRectF> squares;
        for (const QPointF& point : points) {
            if (!std::isfinite(point.y())) {
                continue;
            }
            if (apart >= dots_apart) {
                painter.drawEllipse(point, radius, radius);
            } else {
                squares.append({point.x() - radius, point.y() - radius, 2 * radius, 2 * radius});
            }
        }
        painter.drawRects(squares);
        painter.setBrush(Qt::NoBrush);
    }

    // Missing samples, as in the columns.
    void drawLost(QCPPainter& painter) const {
        const std::vector<double>& values = isD() ? content_.excerpt->d : content_.excerpt->c;
        const QColor veil = translucent(content_.theme.warning, 0.35);
        const double width = std::max(1., samplesApart());
        for (std::size_t k = picture_.from; k < picture_.to; ++k) {
            if (!std::isfinite(values[k])) {
                painter.fillRect(QRectF(x(content_.excerpt->time_s(k)) - 0.5 * width,
                                        clipRect().top(), width, clipRect().height()),
                                 veil);
            }
        }
    }

    SignalPart part_;
    const SignalContent& content_;
    const SignalPicture& picture_;
};

}  // namespace

SignalStack::SignalStack(QCustomPlot& plot, const std::vector<SignalPart>& parts, PlotHead head)
    : TimeStack(plot, 0, head), parts_(parts) {
    std::vector<TimePanel*> panels;
    for (const SignalPart part : parts_) {
        panels.push_back(new TimePanel(&plot, head));
        new SignalGraph(panels.back()->timeAxis(), panels.back()->valueAxis(), part, content_,
                        picture_);  // of the plot
    }
    build(std::move(panels));
}

void SignalStack::setContent(SignalContent content, QSize size) {
    content_ = std::move(content);
    prepare(size);
    picture_ = pictureOf(content_, frameWidth(size.width()));
    for (std::size_t k = 0; k < parts_.size(); ++k) {
        refresh(parts_[k], *frames()[k]);
    }
    setLook(content_.theme);
    if (head() == PlotHead::line) {
        showLegend();
    }
}

void SignalStack::refresh(SignalPart part, TimePanel& panel) {
    const QFont font = plotFont(plot());
    const bool residual = part == SignalPart::residual;
    const QString empty = residual && !content_.analysis ? content_.no_residual : QString();
    panel.setLook(content_.theme, font);
    panel.setTexts({residual                ? QCoreApplication::translate("SignalPanel", "Residual")
                    : part == SignalPart::c ? QStringLiteral("C")
                                            : QStringLiteral("D"),
                    content_.unit,
                    takesPrefix(content_.unit),
                    {},
                    empty});
    panel.setScaleShown(empty.isEmpty());
    panel.setTime(content_.time);
    AxisRange values = valuesOf(content_, picture_, part);
    if (head() == PlotHead::margin) {
        // The margin has room for a part of the overlay's line of text above the curves.
        const double line = (QFontMetricsF(font).height() + 2 * note_inset) /
                            std::max(1, panel.expectedSize().height());
        const double beyond = values.span() * margin / (1 + 2 * margin);
        values.upper += std::max(0., line * values.span() - beyond) / (1 - std::min(0.5, line));
    }
    panel.setValues(values);
}

void SignalStack::showLegend() {
    const Theme& theme = content_.theme;
    std::vector<StripEntry> entries;
    const auto add = [&](const QString& text, const QColor& color) {
        entries.push_back({text, true, true, color});
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

void SignalOverlay::draw(QCPPainter* painter) {
    const Theme& theme = stack_.content().theme;
    for (std::size_t k = 0; k < stack_.parts().size(); ++k) {
        const TimePanel& panel = *stack_.frames()[k];
        const QString text = note(stack_.parts()[k], panel);
        if (text.isEmpty()) {
            continue;
        }
        painter->setFont(panel.font());
        const QRectF area = QRectF(panel.rect()).adjusted(6, note_inset, -6, -note_inset);
        const QRectF box = painter->boundingRect(area, int(Qt::AlignRight | Qt::AlignTop), text)
                               .adjusted(-4, 0, 4, 0);
        painter->fillRect(box, translucent(theme.panelBackground, 0.8));
        painter->setPen(theme.text);
        painter->drawText(box, int(Qt::AlignCenter), text);
    }
    TimeOverlay::draw(painter);
}

// The values at the mouse; without them, what the curves are.
QString SignalOverlay::note(SignalPart part, const TimePanel& panel) const {
    const SignalContent& content = stack_.content();
    const bool residual = part == SignalPart::residual;
    if (residual && !content.analysis) {
        return {};
    }
    const auto& excerpt = content.excerpt;
    const auto tracker = gestures().tracker();
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
    const bool d = part == SignalPart::d;
    QString text = SignalWords::tr("sample %1").arg(number(d ? excerpt->d[at] : excerpt->c[at]));
    if (content.analysis) {
        text += QStringLiteral("   ") +
                SignalWords::tr("wave %1").arg(number(d ? excerpt->fit_d[at] : excerpt->fit_c[at]));
    }
    return text;
}

}  // namespace vybeg::ui
