#include "ui/widgets/page_parts.h"

#include "ui/widgets/section.h"
#include "ui/words/rich_text.h"

#include <QComboBox>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>

namespace vybeg::ui {

void addParts(QBoxLayout& layout, LayoutParts parts) {
    for (const LayoutPart& part : parts) {
        if (part.widget) {
            layout.addWidget(part.widget, part.stretch, part.alignment);
        } else if (part.layout) {
            layout.addLayout(part.layout, part.stretch);
        } else {
            layout.addStretch(part.stretch);
        }
    }
}

QLabel* sentence(QWidget* parent, const char* name, const QMargins& around) {
    auto* label = withName(new QLabel(parent), name);
    makeSentence(*label);
    label->setContentsMargins(around);
    return label;
}

void makeSentence(QLabel& label) {
    label.setWordWrap(true);
    label.setTextFormat(Qt::RichText);
    label.setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    label.setContentsMargins(around_sentence);
    label.setAlignment(Qt::AlignLeft | Qt::AlignTop);
}

void setTexts(QComboBox& box, const QStringList& texts, int first) {
    for (int k = 0; k < texts.size(); ++k) {
        box.setItemText(first + k, texts[k]);
    }
}

QString paragraphs(const QStringList& texts, const QString& form) {
    QString html;
    for (const QString& text : texts) {
        html += QStringLiteral("<p style=\"margin:2px 0\">%1</p>").arg(form.arg(richText(text)));
    }
    return html;
}

Section* addSection(QVBoxLayout& layout, std::initializer_list<QWidget*> parts) {
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(0, 0, 0, 4);
    column->setSpacing(2);
    for (QWidget* part : parts) {
        column->addWidget(part);
    }
    auto* section = new Section(content);
    layout.addWidget(section);
    return section;
}

QScrollArea* scrolled(QVBoxLayout* column) {
    auto* content = new QWidget;
    column->setContentsMargins(0, 0, 0, 0);
    content->setLayout(column);
    return scrolled(content);
}

QScrollArea* scrolled(QWidget* content, QWidget* parent) {
    auto* scroll = new QScrollArea(parent);
    scroll->setWidget(content);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    return scroll;
}

}  // namespace vybeg::ui
