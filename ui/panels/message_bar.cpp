#include "ui/panels/message_bar.h"

#include "ui/widgets/page_parts.h"

#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace vybeg::ui {

namespace {

constexpr std::size_t most_messages = 3;
constexpr int line_margin = 1;
constexpr int frame_width = 1;

}  // namespace

MessageBar::MessageBar(QWidget* parent)
    : QWidget(parent),
      layout_(new QVBoxLayout),
      open_(withName(new QToolButton(this), "openMessages")),
      more_(withName(new QWidget(this), "moreMessages")),
      waiting_(new QLabel(more_)),
      close_all_(withName(new QToolButton(more_), "closeMessages")) {
    fill(new QHBoxLayout(more_), {8, 0, 4, 2}, {{waiting_, 1}, close_all_});
    fill(layout_, {}, 0, {more_});
    fill(new QHBoxLayout(this), {}, 0, {{layout_, 1}, {open_, 0, Qt::AlignTop}});
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::ToolTipBase);
    for (QWidget* part : std::initializer_list<QWidget*>{open_, waiting_, close_all_}) {
        part->setForegroundRole(QPalette::ToolTipText);
    }
    connect(open_, &QToolButton::clicked, this, [this] {
        opened_ = !opened_;
        showRows();
    });
    // Questions wait for their answers.
    connect(close_all_, &QToolButton::clicked, this, [this] {
        for (const Row& row : std::vector(rows_)) {
            if (!row.message.until_answered) {
                remove(row.widget);
            }
        }
    });
    hide();
    keepTranslated(*this, [this] { retranslate(); });
}

void MessageBar::floatOver(QWidget& window, std::function<int()> kept_free) {
    setParent(&window);
    kept_free_ = std::move(kept_free);
    const auto settle = [this] { this->settle(); };
    whenChanged(window, {QEvent::Resize}, settle);
    whenChanged(*this, {QEvent::Show, QEvent::LayoutRequest}, settle);
}

void MessageBar::settle() {
    if (rows_.empty()) {
        return;
    }
    const int wide = kept_free_ ? parentWidget()->width() - kept_free_() : width();
    // Beside the count of the others, which is no wider than this.
    const int count_width = rows_.size() > 1 ? waiting_->sizeHint().width() + lineHeight() : 0;
    const bool is_whole = fits(wide - count_width);
    open_->setVisible(opened_ || rows_.size() > 1 || !is_whole);
    open_->setText(opened_ ? tr("Less") : is_whole ? waiting_->text() : tr("More"));
    open_->setFixedHeight(lineHeight());
    if (kept_free_) {
        const int high = std::max(heightForWidth(wide), lineHeight());
        setGeometry(0, parentWidget()->height() - high, wide, high);
        raise();
    }
}

int MessageBar::lineHeight() const {
    const QPushButton button(QStringLiteral("M"));
    return button.sizeHint().height() + 2 * line_margin + 2 * frame_width;
}

bool MessageBar::fits(int width) const {
    const Row& newest = rows_.front();
    const QSize text = fontMetrics().size(0, newest.text->text());
    const int others = newest.widget->sizeHint().width() - newest.text->sizeHint().width();
    return text.width() + others <= width && text.height() <= fontMetrics().height();
}

void MessageBar::add(const Message& message) {
    if (message.severity == MessageLevel::info) {
        return;  // shown in the status bar
    }
    withdraw(message.topic);
    const QString text = message.text();
    const auto same =
        std::ranges::find_if(rows_, [&](const Row& row) { return row.message.text() == text; });
    if (same != rows_.end()) {
        remove(same->widget);
    }

    auto* frame = new QFrame(this);
    frame->setFrameShape(QFrame::StyledPanel);
    frame->setLineWidth(frame_width);
    auto* icon = new QLabel(frame);
    const int size = style()->pixelMetric(QStyle::PM_SmallIconSize);
    const auto sign = message.severity == MessageLevel::error ? QStyle::SP_MessageBoxCritical
                                                              : QStyle::SP_MessageBoxWarning;
    icon->setPixmap(style()->standardIcon(sign).pixmap(size));
    Row row{message, frame, new QLabel(frame), new QToolButton(frame), {}};
    row.text->setWordWrap(true);
    row.text->setTextFormat(Qt::PlainText);
    row.text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    row.text->setForegroundRole(QPalette::ToolTipText);
    auto* line =
        fill(new QHBoxLayout(frame), {8, line_margin, 4, line_margin}, {icon, {row.text, 1}});
    for (const auto& [text_of, act] : message.buttons) {
        row.buttons.push_back(new QPushButton(frame));
        connect(row.buttons.back(), &QPushButton::clicked, this, [this, frame, done = act] {
            remove(frame);
            done();
        });
        line->addWidget(row.buttons.back());
    }
    row.close->setAutoRaise(true);
    row.close->setMaximumHeight(lineHeight() - 2 * (line_margin + frame_width));
    row.close->setIcon(style()->standardIcon(QStyle::SP_TitleBarCloseButton));
    row.close->setVisible(!message.until_answered);
    connect(row.close, &QToolButton::clicked, this, [this, frame] { remove(frame); });
    line->addWidget(row.close);

    rows_.insert(rows_.begin(), row);
    layout_->insertWidget(0, frame);
    nameRow(row);
    showRows();
}

// Of too many messages warnings wait before errors, and older before newer ones; the newest never
// does, nor, in more than one line, a question.
void MessageBar::showRows() {
    int waiting = 0;
    opened_ = opened_ && !rows_.empty();
    const std::size_t most = opened_ ? most_messages : 1;
    std::vector<QWidget*> shown;
    for (const Row& row : rows_) {
        shown.push_back(row.widget);
    }
    for (const MessageLevel level : {MessageLevel::warning, MessageLevel::error}) {
        for (auto row = rows_.rbegin(); row != rows_.rend() && row + 1 != rows_.rend(); ++row) {
            const bool stays = opened_ && row->message.until_answered;
            if (shown.size() > most && row->message.severity == level && !stays) {
                std::erase(shown, row->widget);
                ++waiting;
            }
        }
    }
    for (const Row& row : rows_) {
        row.widget->setVisible(std::ranges::count(shown, row.widget) > 0);
        row.text->setMinimumHeight(opened_ ? 0 : fontMetrics().height());
        row.text->setMaximumHeight(opened_ ? QWIDGETSIZE_MAX : fontMetrics().height());
    }
    more_->setVisible(opened_ && waiting > 0);
    waiting_->setText(tr("%n more message(s)", nullptr, waiting));
    open_->setToolTip(opened_ ? tr("Leaves one line of the newest message")
                              : tr("Shows whole messages, over the window"));
    if (isHidden() != rows_.empty()) {
        setVisible(!rows_.empty());
        emit cameOrWent();
    }
    settle();
}

void MessageBar::remove(QWidget* widget) {
    std::erase_if(rows_, [widget](const Row& row) { return row.widget == widget; });
    widget->hide();
    widget->deleteLater();
    showRows();
}

void MessageBar::clear() {
    while (!rows_.empty()) {
        remove(rows_.back().widget);
    }
}

void MessageBar::withdraw(Topic topic) {
    const auto told = [topic](const Row& row) { return row.message.topic == topic; };
    if (const auto row = std::ranges::find_if(rows_, told);
        topic != Topic::none && row != rows_.end()) {
        remove(row->widget);
    }
}

QStringList MessageBar::texts() const {
    QStringList texts;
    for (const Row& row : rows_) {
        texts << row.text->text();
    }
    return texts;
}

void MessageBar::retranslate() {
    std::ranges::for_each(rows_, [this](const Row& row) { nameRow(row); });
    close_all_->setText(tr("Close all"));
    close_all_->setToolTip(tr("Closes all messages but questions"));
    showRows();
}

void MessageBar::nameRow(const Row& row) {
    row.text->setText(row.message.text());
    row.widget->setAccessibleName(row.message.text());
    row.close->setToolTip(tr("Close this message"));
    row.close->setAccessibleName(tr("Close this message"));
    for (std::size_t k = 0; k < row.buttons.size(); ++k) {
        row.buttons[k]->setText(row.message.buttons[k].first());
    }
}

}  // namespace vybeg::ui

#include "moc_message_bar.cpp"
