#include "ui/words/short_names.h"

#include <QApplication>
#include <QFileInfo>
#include <QSet>
#include <QStyle>

#include <algorithm>

namespace vybeg::ui {
namespace {

constexpr qsizetype worthwhile = 4;  // letters that an ellipsis may replace

// Whether the characters on both sides of a place belong to one word or number.
bool insideWord(const QString& text, qsizetype place) {
    const auto digit = [&text](qsizetype at) {
        return 0 <= at && at < text.size() && text[at].isDigit();
    };
    const auto part = [&](qsizetype at) {
        const bool sign = text[at] == '.' || text[at] == ',';
        return text[at].isLetterOrNumber() || (sign && digit(at - 1) && digit(at + 1));
    };
    return 0 < place && place < text.size() && part(place - 1) && part(place);
}

// How many characters all names begin with, up to whole words and numbers; of each, one is left.
qsizetype sharedBeginning(const QStringList& names) {
    const qsizetype shortest = std::ranges::min(names, {}, &QString::size).size();
    const auto all = [&names](const auto& has) { return std::ranges::all_of(names, has); };
    qsizetype begin = 0;
    while (begin < shortest - 1 &&
           all([&](const QString& name) { return name[begin] == names.front()[begin]; })) {
        ++begin;
    }
    while (begin > 0 && !all([&](const QString& name) { return !insideWord(name, begin); })) {
        --begin;
    }
    return begin;
}

QStringList stems(const QStringList& files) {
    QStringList names;
    for (const QString& file : files) {
        names << QFileInfo(file).completeBaseName();
    }
    return names;
}

}  // namespace

QStringList recordingNames(const QStringList& files) {
    const QStringList names = stems(files);
    const bool apart = QSet<QString>(names.begin(), names.end()).size() == names.size();
    return distinctNames(apart ? names : files);
}

QString commonName(const QStringList& files) {
    const QStringList names = stems(files);
    QString name = names.isEmpty() ? QString() : names.front().left(sharedBeginning(names));
    while (!name.isEmpty() && !name.back().isLetterOrNumber()) {
        name.chop(1);
    }
    return name.size() < worthwhile - 1 ? QString() : name;
}

QStringList distinctNames(const QStringList& names, bool beginning) {
    if (names.size() < 2) {
        return names;
    }
    const QString& first = names.front();
    const qsizetype shortest = std::ranges::min(names, {}, &QString::size).size();
    const auto all = [&names](const auto& has) { return std::ranges::all_of(names, has); };
    qsizetype begin = sharedBeginning(names);
    begin = begin < worthwhile || !beginning ? 0 : begin;
    qsizetype end = 0;
    while (end < shortest - begin - 1 &&
           all([&](const QString& name) { return name.right(end + 1) == first.right(end + 1); })) {
        ++end;
    }
    while (end > 0 &&
           !all([&](const QString& name) { return !insideWord(name, name.size() - end); })) {
        --end;
    }
    end = end < worthwhile ? 0 : end;
    const QChar ellipsis(0x2026);
    QStringList distinct;
    for (const QString& name : names) {
        QString text = name.mid(begin, name.size() - begin - end);
        distinct << (begin > 0 ? ellipsis + text : text) +
                        (end > 0 ? QString(ellipsis) : QString());
    }
    return distinct;
}

void NameDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                         const QModelIndex& index) const {
    QStyleOptionViewItem item = option;
    initStyleOption(&item, index);
    const QStyle* style = item.widget ? item.widget->style() : QApplication::style();
    const int margin = style->pixelMetric(QStyle::PM_FocusFrameHMargin, &item, item.widget) + 1;
    const int room =
        style->subElementRect(QStyle::SE_ItemViewItemText, &item, item.widget).width() - 2 * margin;
    const auto fits = [&item, room] {
        return item.fontMetrics.horizontalAdvance(item.text) <= room;
    };
    const QAbstractItemModel* const model = index.model();
    if (model && !fits()) {
        QStringList names;
        for (int row = 0; row < model->rowCount(index.parent()); ++row) {
            names << index.siblingAtRow(row).data().toString();
        }
        item.text = distinctNames(names, false)[index.row()];
        item.text = fits() ? item.text : distinctNames(names)[index.row()];
        item.textElideMode = Qt::ElideMiddle;
    }
    style->drawControl(QStyle::CE_ItemViewItem, &item, painter, item.widget);
}

}  // namespace vybeg::ui

#include "moc_short_names.cpp"
