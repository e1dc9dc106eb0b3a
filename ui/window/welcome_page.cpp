#include "ui/window/welcome_page.h"

#include <QEvent>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace vybeg::ui {

WelcomePage::WelcomePage(QWidget* parent)
    : QWidget(parent), text_(new QLabel(this)), open_(new QPushButton(this)) {
    text_->setAlignment(Qt::AlignCenter);
    text_->setWordWrap(true);
    auto* layout = new QVBoxLayout(this);
    layout->addStretch(2);
    layout->addWidget(text_);
    layout->addSpacing(12);
    layout->addWidget(open_, 0, Qt::AlignHCenter);
    layout->addStretch(3);
    connect(open_, &QPushButton::clicked, this, &WelcomePage::openWanted);
    retranslate();
}

void WelcomePage::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
    }
}

void WelcomePage::retranslate() {
    text_->setText(
        tr("<p style='font-size:large'>Drop a recording of a free decay here</p>"
           "<p>Two channels, C and D: WAV, FLAC, CSV and other tables of numbers</p>"));
    open_->setText(tr("Open recording…"));
}

}  // namespace vybeg::ui
