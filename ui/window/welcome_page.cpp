#include "ui/window/welcome_page.h"

#include "ui/widgets/page_parts.h"
#include "ui/words/rich_text.h"

#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

namespace vybeg::ui {

WelcomePage::WelcomePage(QWidget* parent)
    : QWidget(parent),
      text_(new QLabel(this)),
      open_(new QPushButton(this)),
      demonstration_(withName(new QPushButton(this), "demonstration")),
      recent_name_(new QLabel(this)),
      recent_(withName(new QListWidget(this), "recent")) {
    text_->setAlignment(Qt::AlignCenter);
    text_->setWordWrap(true);
    recent_->setMaximumWidth(640);
    recent_->setAlternatingRowColors(true);
    recent_->setTextElideMode(Qt::ElideMiddle);
    recent_name_->setBuddy(recent_);
    auto* buttons = fill(new QHBoxLayout, {LayoutPart(1), open_, demonstration_, LayoutPart(1)});
    auto* files = fill(new QVBoxLayout, {recent_name_, {recent_, 1}});
    auto* middle = fill(new QHBoxLayout, {LayoutPart(1), {files, 4}, LayoutPart(1)});
    auto* layout = fill(new QVBoxLayout(this), {LayoutPart(2), text_});
    layout->addSpacing(12);
    layout->addLayout(buttons);
    layout->addSpacing(18);
    layout->addLayout(middle, 4);
    layout->addStretch(1);
    connect(open_, &QPushButton::clicked, this, &WelcomePage::openWanted);
    connect(demonstration_, &QPushButton::clicked, this, &WelcomePage::demonstrationWanted);
    connect(recent_, &QListWidget::itemActivated, this, [this](const QListWidgetItem* item) {
        emit recentChosen(item->data(Qt::UserRole).toString());
    });
    connect(recent_, &QListWidget::itemClicked, recent_, &QListWidget::itemActivated);
    setRecent({});
    keepTranslated(*this, [this] { retranslate(); });
}

void WelcomePage::setRecent(const QStringList& paths) {
    recent_->clear();
    for (const QString& path : paths) {
        const QFileInfo file(path);
        auto* item = new QListWidgetItem(
            QStringLiteral("%1\n%2").arg(file.fileName(), QDir::toNativeSeparators(file.path())),
            recent_);
        item->setData(Qt::UserRole, path);
        item->setToolTip(plainTip(QDir::toNativeSeparators(path)));
    }
    recent_name_->setVisible(!paths.isEmpty());
    recent_->setVisible(!paths.isEmpty());
}

void WelcomePage::retranslate() {
    text_->setText(
        tr("<p style='font-size:large'>Drop a recording of a free decay here</p>"
           "<p>Two channels, C and D: WAV, FLAC, CSV and other tables of numbers</p>"));
    open_->setText(tr("Open recording…"));
    open_->setToolTip(tr("A recording of a free decay, or a session"));
    demonstration_->setText(tr("Open the demonstration"));
    demonstration_->setToolTip(
        tr("A simulated free decay: 28 s, 5300 Hz, with a frequency split, a decay and noise"));
    recent_name_->setText(tr("Recent files"));
    recent_->setAccessibleName(tr("Recent files"));
    recent_->setToolTip(tr("A click or Return opens a file"));
}

}  // namespace vybeg::ui
