#include "ui/widgets/page_parts.h"

#include "ui/words/rich_text.h"

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace vybeg::ui {

namespace {

class ChangeWatch : public QObject {
public:
    ChangeWatch(QWidget& widget, std::vector<QEvent::Type> types, std::function<void()> react)
        : QObject(&widget), types_(std::move(types)), react_(std::move(react)) {
        widget.installEventFilter(this);
    }

    bool eventFilter(QObject* watched, QEvent* event) override {
        if (std::ranges::count(types_, event->type()) > 0) {
            react_();
        }
        return QObject::eventFilter(watched, event);
    }

private:
    std::vector<QEvent::Type> types_;
    std::function<void()> react_;
};

class WheelGuard : public QObject {
public:
    using QObject::QObject;

    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() != QEvent::Wheel || static_cast<QWidget*>(watched)->hasFocus()) {
            return QObject::eventFilter(watched, event);
        }
        event->ignore();  // passed on to the parent
        return true;
    }
};

}  // namespace

void setWords(QWidget& widget, const QString& name, const QString& tip) {
    widget.setAccessibleName(name);
    widget.setToolTip(tip);
}

void addRow(QFormLayout& form, const QString& label, QWidget* field, const QString& tip) {
    form.addRow(label, field);
    setWords(*field, label, tip);
}

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

QLabel* hint(QWidget* parent, const char* name) {
    constexpr int characters = 66;
    QLabel* label = sentence(parent, name, QMargins());
    label->setAlignment(Qt::AlignCenter);
    label->setFixedWidth(characters * label->fontMetrics().averageCharWidth());
    return label;
}

void makeSentence(QLabel& label) {
    label.setWordWrap(true);
    label.setTextFormat(Qt::RichText);
    label.setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    label.setContentsMargins(around_sentence);
    label.setAlignment(Qt::AlignLeft | Qt::AlignTop);
    // The document of a text keeps the colour that links had.
    whenChanged(label, {QEvent::PaletteChange}, [&label] {
        const QString text = label.text();
        label.clear();
        label.setText(text);
    });
}

void setTexts(QComboBox& box, const QStringList& texts) {
    for (int k = 0; k < texts.size(); ++k) {
        box.setItemText(k, texts[k]);
    }
}

QString paragraphs(const QStringList& texts, const QString& form) {
    QString html;
    for (const QString& text : texts) {
        html += QStringLiteral("<p style=\"margin:2px 0\">%1</p>").arg(form.arg(richText(text)));
    }
    return html;
}

Section* addSection(QVBoxLayout& layout, LayoutParts parts) {
    auto* content = new QWidget;
    fill(new QVBoxLayout(content), {0, 0, 0, 4}, 2, parts);
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

Section::Section(QWidget* content, QWidget* parent)
    : QWidget(parent), title_(new QToolButton(this)), note_(new QLabel(this)), content_(content) {
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

    constexpr int below_the_text = 20;
    note_->setContentsMargins(below_the_text, 0, 4, 0);
    note_->setForegroundRole(QPalette::PlaceholderText);

    fill(new QVBoxLayout(this), {}, 2, {title_, note_, content_});
    connect(title_, &QToolButton::clicked, this, &Section::clicked);
    connect(title_, &QToolButton::toggled, this, &Section::showParts);
    showParts();
}

void Section::showParts() {
    content_->setVisible(isOpen());
    note_->setVisible(!isOpen() && !note_->text().isEmpty());
    title_->setArrowType(isOpen() ? Qt::DownArrow : Qt::RightArrow);
}

void Section::setNote(const QString& note) {
    note_->setText(note);
    showParts();
}

void Section::setTitle(const QString& title) {
    title_->setText(title);
    title_->setToolTip(tr("Folds this part away, and opens it again"));
}

void whenChanged(QWidget& widget, std::vector<QEvent::Type> types, std::function<void()> react) {
    new ChangeWatch(widget, std::move(types), std::move(react));
}

void keepTranslated(QWidget& widget, std::function<void()> translate) {
    translate();
    whenChanged(widget, {QEvent::LanguageChange}, std::move(translate));
}

QLabel* labelFor(QWidget* field, std::function<QString()> words) {
    auto* label = new QLabel(field->parentWidget());
    label->setBuddy(field);
    keepTranslated(*label, [label, words = std::move(words)] { label->setText(words()); });
    return label;
}

void guardFromWheel(QWidget& panel) {
    auto* guard = new WheelGuard(&panel);
    for (QWidget* field : panel.findChildren<QWidget*>()) {
        if (qobject_cast<QComboBox*>(field) || qobject_cast<QAbstractSpinBox*>(field)) {
            // Qt's default also takes the focus by the wheel.
            field->setFocusPolicy(Qt::StrongFocus);
            field->installEventFilter(guard);
        }
    }
}

}  // namespace vybeg::ui

#include "moc_page_parts.cpp"
