#include "ui/widgets/section.h"

#include <QVBoxLayout>

namespace vybeg::ui {

Section::Section(QWidget* content, QWidget* parent)
    : QWidget(parent), title_(new QToolButton(this)), content_(content) {
    title_->setCheckable(true);
    title_->setChecked(true);
    title_->setAutoRaise(true);
    title_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    title_->setArrowType(Qt::DownArrow);
    title_->setFocusPolicy(Qt::TabFocus);
    title_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    QFont bold = title_->font();
    bold.setBold(true);
    title_->setFont(bold);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addWidget(title_);
    layout->addWidget(content_);
    connect(title_, &QToolButton::clicked, this, &Section::clicked);
    connect(title_, &QToolButton::toggled, this, [this](bool open) {
        content_->setVisible(open);
        title_->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
    });
}

void Section::setTitle(const QString& title) {
    title_->setText(title);
    title_->setToolTip(tr("Folds this part away, and opens it again"));
}

void Section::setOpen(bool open) {
    title_->setChecked(open);
}

}  // namespace vybeg::ui
