#include "ui/plots/signal_view.h"

#include <QEvent>

#include <algorithm>

namespace vybeg::ui {
SignalView::SignalView(QWidget* parent) : QWidget(parent), theme_(lightTheme()) {
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setAccessibleName(tr("Overview of the recording"));
}

void SignalView::clear() {
    setReading(0);
}

void SignalView::setReading(double seconds) {
    envelope_.reset();
    faults_.reset();
    seconds_ = seconds;
    visible_ = analysed_ = {0, seconds};
    drawn_ = {};
    update();
}

void SignalView::setEnvelope(std::shared_ptr<const Envelope> envelope, double rate_hz) {
    envelope_ = std::move(envelope);
    rate_hz_ = rate_hz;
    seconds_ = static_cast<double>(envelope_->frames()) / rate_hz;
    drawn_ = {};
    update();
}

void SignalView::setFaults(std::shared_ptr<const SampleFaults> faults) {
    if (faults != faults_) {
        faults_ = std::move(faults);
        update();
    }
}

void SignalView::setVisibleRange(AxisRange range) {
    visible_ = range;
    update();
}

void SignalView::setAnalysedRange(AxisRange range) {
    analysed_ = range;
    update();
}

void SignalView::setTheme(const Theme& theme) {
    theme_ = theme;
    drawn_ = {};
    update();
}

void SignalView::setMargins(int left, int right) {
    if (left == left_ && right == right_) {
        return;
    }
    left_ = left;
    right_ = right;
    drawn_ = {};
    update();
}

QRect SignalView::plotArea() const {
    return rect().adjusted(left_, 2, -right_, -range_row);
}

double SignalView::toPixel(double time_s) const {
    const QRect area = plotArea();
    return area.left() + (seconds_ > 0 ? time_s / seconds_ : 0) * area.width();
}

double SignalView::toTime(double pixel) const {
    const QRect area = plotArea();
    return (pixel - area.left()) / std::max(1, area.width()) * seconds_;
}

void SignalView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    drawn_ = {};
}

void SignalView::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        setAccessibleName(tr("Overview of the recording"));
    }
    drawn_ = {};
    update();
}

}  // namespace vybeg::ui
