#pragma once

#include <QEvent>
#include <QMargins>
#include <QString>
#include <QStringList>
#include <QToolButton>
#include <QWidget>

#include <algorithm>
#include <array>
#include <functional>
#include <initializer_list>
#include <optional>
#include <utility>
#include <vector>

class QBoxLayout;
class QComboBox;
class QFormLayout;
class QLabel;
class QLayout;
class QScrollArea;
class QVBoxLayout;

namespace vybeg::ui {

// Parts of pages.

// A widget under the name by which others find it.
template <class Widget>
Widget* withName(Widget* widget, const char* name) {
    widget->setObjectName(QLatin1String(name));
    return widget;
}

// What a screen reader calls a widget, and its tool tip.
void setWords(QWidget& widget, const QString& name, const QString& tip);
// A row of a form: a field with its label, which is its name for a screen reader, too.
void addRow(QFormLayout& form, const QString& label, QWidget* field, const QString& tip);

// A part of a row or column of a layout: a widget, another layout, or room that grows.
struct LayoutPart {
    LayoutPart(QWidget* of, int stretch_of = 0, Qt::Alignment aligned = {})
        : widget(of), stretch(stretch_of), alignment(aligned) {}
    LayoutPart(QLayout* of, int stretch_of = 0) : layout(of), stretch(stretch_of) {}
    explicit LayoutPart(int stretch_of) : stretch(stretch_of) {}

    QWidget* widget = nullptr;
    QLayout* layout = nullptr;
    int stretch = 0;
    Qt::Alignment alignment;
};
using LayoutParts = std::initializer_list<LayoutPart>;

// Puts parts into a row or column, with so much room around and between them.
void addParts(QBoxLayout& layout, LayoutParts parts);
template <class Layout>
Layout* fill(Layout* layout, LayoutParts parts) {
    addParts(*layout, parts);
    return layout;
}
template <class Layout>
Layout* fill(Layout* layout, const QMargins& around, LayoutParts parts) {
    layout->setContentsMargins(around);
    return fill(layout, parts);
}
template <class Layout>
Layout* fill(Layout* layout, const QMargins& around, int between, LayoutParts parts) {
    layout->setSpacing(between);
    return fill(layout, around, parts);
}

// A label of whole sentences, rich text.
constexpr QMargins around_sentence{6, 2, 6, 2};
QLabel* sentence(QWidget* parent, const char* name, const QMargins& around = around_sentence);
void makeSentence(QLabel& label);
// A sentence in the middle of a page that has nothing to show yet; the layout centres the label.
QLabel* hint(QWidget* parent, const char* name);
// The texts of a box's entries.
void setTexts(QComboBox& box, const QStringList& texts);
// The values of words as entries of a box, behind one that leaves the choice open.
template <class Value, std::size_t count>
constexpr auto entriesOf(const std::array<std::pair<const char*, Value>, count>& words) {
    std::array<std::optional<Value>, count + 1> entries;
    std::ranges::transform(words, entries.begin() + 1, [](auto& each) { return each.second; });
    return entries;
}
// The place of a value among entries; 0 where it is none of them.
template <class Entries, class Value>
int placeIn(const Entries& entries, const Value& value) {
    const auto found = std::ranges::find(entries, value);
    return found == entries.end() ? 0 : static_cast<int>(found - entries.begin());
}

// Each text a paragraph, in the form of `form`, whose %1 it takes.
QString paragraphs(const QStringList& texts, const QString& form);
// A titled part of a panel that can be folded away. The title is a button: Tab reaches it, Space
// folds.
class Section : public QWidget {
    Q_OBJECT

public:
    explicit Section(QWidget* content, QWidget* parent = nullptr);

    void setTitle(const QString& title);
    // The text below the title while the part is folded away.
    void setNote(const QString& note);
    void setOpen(bool open) { title_->setChecked(open); }
    bool isOpen() const { return title_->isChecked(); }

signals:
    // By a person.
    void clicked();

private:
    void showParts();

    QToolButton* title_;
    QLabel* note_;
    QWidget* content_;
};

// One at the end of a layout, with these parts.
Section* addSection(QVBoxLayout& layout, LayoutParts parts);
// A column that scrolls up and down.
QScrollArea* scrolled(QVBoxLayout* column);
QScrollArea* scrolled(QWidget* content, QWidget* parent = nullptr);

// Calls `react` before each event of one of these types reaches the widget.
void whenChanged(QWidget& widget, std::vector<QEvent::Type> types, std::function<void()> react);
// Sets the texts of a widget by `translate`: now, and again in each further language.
void keepTranslated(QWidget& widget, std::function<void()> translate);
// The label of a field, in the language of the interface.
QLabel* labelFor(QWidget* field, std::function<QString()> words);

// After this call the wheel over a combo or spin box inside `panel` changes it only if it has the
// focus, and otherwise scrolls the area around it.
void guardFromWheel(QWidget& panel);

}  // namespace vybeg::ui
