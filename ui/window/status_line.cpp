#include "ui/window/status_line.h"

#include "ui/document/document.h"
#include "ui/widgets/page_parts.h"
#include "ui/words/display_units.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

#include <cmath>
#include <utility>

namespace vybeg::ui {

namespace {

// Analyses shorter than this come and go without a progress bar, which would only flicker while a
// setting is changed.
constexpr int patience_ms = 250;
// So long a text is shown over a page.
constexpr int news_ms = 6000;

}  // namespace

StatusLine::StatusLine(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      status_(new QLabel(this)),
      time_left_(new QLabel(this)),
      progress_(new QProgressBar(this)),
      cancel_(withName(new QPushButton(this), "cancel")) {
    progress_->setRange(0, 1000);
    progress_->setFixedWidth(180);
    progress_->setTextVisible(false);
    fill(new QHBoxLayout(this), {}, {{status_, 1}, time_left_, progress_, cancel_});
    wait_.setSingleShot(true);
    wait_.setInterval(patience_ms);
    news_.setSingleShot(true);
    news_.setInterval(news_ms);
    setAutoFillBackground(true);
    connect(&wait_, &QTimer::timeout, this, &StatusLine::refresh);
    connect(&news_, &QTimer::timeout, this, &StatusLine::place);
    connect(cancel_, &QPushButton::clicked, this, &StatusLine::cancel);
    connect(&document_, &Document::busyChanged, this, &StatusLine::whenBusyChanged);
    connect(&document_, &Document::progressChanged, this, &StatusLine::refresh);
    connect(&document_.sets(), &SetStore::identified, this, [this](SetId set_id) {
        const auto found = document_.sets().outcome(*document_.sets().find(set_id));
        const auto count = static_cast<int>(found->set.recordings.size());
        tell([count, seconds = found->seconds] {
            return tr("Resonator of %n recording(s) in %1", nullptr, count)
                .arg(secondsText(seconds));
        });
    });
    connect(&document_, &Document::finished, this, [this](AnalysisId analysis_id, double seconds) {
        const auto windows = static_cast<int>(document_.analysis(analysis_id)->summary.windows);
        tell([windows, seconds] {
            return tr("%n window(s) in %1", nullptr, windows).arg(secondsText(seconds));
        });
    });
    connect(&document_, &Document::reported, this, [this](const Message& message) {
        if (message.severity == MessageLevel::info) {
            tell(message.text);
        }
    });
    keepTranslated(*this, [this] { retranslate(); });
}

QString StatusLine::text() const {
    return status_->text();
}

int StatusLine::progressWidth() const {
    return progress_->isHidden() ? 0 : sizeHint().width() - status_->sizeHint().width();
}

void StatusLine::cancel() {
    cancelled_ = true;
    document_.cancel();
}

void StatusLine::tell(std::function<QString()> text) {
    analysing_ = false;
    text_ = std::move(text);
    status_->setText(text_());
    news_.start();
    place();
}

void StatusLine::floatOver(QWidget* page) {
    floats_ = page != nullptr;
    if (floats_) {
        news_.stop();
        setParent(page);
        page->removeEventFilter(this);
        page->installEventFilter(this);
        place();
    }
}

bool StatusLine::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize) {
        place();
    }
    return QWidget::eventFilter(watched, event);
}

void StatusLine::place() {
    if (!floats_) {
        return;
    }
    const bool busy = document_.busy() && !wait_.isActive();
    setVisible(busy || (news_.isActive() && !status_->text().isEmpty()));
    adjustSize();
    move(0, parentWidget()->height() - height());
    raise();
}

void StatusLine::whenBusyChanged() {
    const bool busy = document_.busy();
    if (std::exchange(was_busy_, busy) != busy) {
        if (busy) {
            cancelled_ = false;
            wait_.start();
        } else {
            wait_.stop();
        }
    }
    refresh();
    if (!busy && analysing_) {
        // No outcome has a text of its own; an error is among the messages.
        tell([cancelled = cancelled_] { return cancelled ? tr("Cancelled") : QString(); });
    }
}

void StatusLine::refresh() {
    const bool busy = document_.busy() && !wait_.isActive();
    progress_->setVisible(busy);
    cancel_->setVisible(busy);
    time_left_->setVisible(busy);
    progress_->setValue(static_cast<int>(1000 * document_.progress()));
    const auto left = document_.secondsLeft();
    time_left_->setText(left ? tr("%1 s left").arg(std::ceil(*left)) : QString());
    if (busy) {
        tell([] { return tr("Analysing…"); });
        analysing_ = true;
    }
    place();
    emit progressPlaced();
}

void StatusLine::retranslate() {
    cancel_->setText(tr("Cancel"));
    progress_->setAccessibleName(tr("Progress of the analysis"));
    if (text_) {
        status_->setText(text_());
    }
    refresh();
}

}  // namespace vybeg::ui

#include "moc_status_line.cpp"
