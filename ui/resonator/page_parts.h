#pragma once

#include <QString>
#include <QStringList>

#include <initializer_list>

class QLabel;
class QScrollArea;
class QVBoxLayout;
class QWidget;

namespace vybeg::ui {

class Section;

// Parts of the page of the resonator.

// A label of whole sentences.
QLabel* sentence(QWidget* parent);
void makeSentence(QLabel& label);
// Each text a paragraph, in the form of `form`, whose %1 it takes.
QString paragraphs(const QStringList& texts, const QString& form);
// A part that can be folded away, at the end of a layout.
Section* addSection(QVBoxLayout& layout, std::initializer_list<QWidget*> parts);
// A column that scrolls up and down.
QScrollArea* scrolled(QVBoxLayout* column);

}  // namespace vybeg::ui
