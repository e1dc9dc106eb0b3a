#include "ui/widgets/quantity_table.h"

#include "ui/widgets/page_parts.h"
#include "ui/words/display_units.h"
#include "ui/words/rich_text.h"

#include <QAbstractTextDocumentLayout>
#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLayout>
#include <QLocale>
#include <QPainter>
#include <QRegularExpression>
#include <QResizeEvent>
#include <QScrollBar>
#include <QStyle>
#include <QStyledItemDelegate>
#include <QTextCursor>
#include <QTextDocument>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace vybeg::ui {

namespace {

constexpr int padding = 4;
constexpr int header_margin = 16;

// Of an item: the color of a dot before its text, and how far a number is moved to the right.
constexpr int dot_role = Qt::UserRole;
constexpr int indent_role = Qt::UserRole + 1;
const QString dot = QStringLiteral("● ");

// The text as it is drawn: no line breaks within a unit, in a number or before its deviation.
QString unbroken(QString text) {
    // Nor does a symbol begin a line of its own after the name of its quantity.
    static const QRegularExpression symbol(QStringLiteral(" (\\S{1,4})(?=,|$)"));
    static const QRegularExpression in_number(
        QStringLiteral("(?<=[±=≠≤≥✓✗?●]) | (?=[±≤≥*])|(?<=\\(u) | (?=\\(u )"));
    return text.replace(symbol, QStringLiteral("\u00a0\\1"))
        .replace(QLatin1Char('/'), QStringLiteral("/\u2060"))
        .replace(in_number, QStringLiteral("\u00a0"));
}

void prepare(QTextDocument& document, const QString& text, const QFont& font) {
    document.setDocumentMargin(0);
    document.setDefaultFont(font);
    document.setHtml(richText(unbroken(text)));
}

// Width up to the decimal sign of a number, also of none and of about zero; none of a sentence or a
// verdict.
std::optional<int> wholeWidth(const QString& text, const QFontMetrics& metrics) {
    static const QRegularExpression letter(QStringLiteral("(?<!\\()\\p{L}"));  // but "(u 0.2)"
    static const QRegularExpression whole(QStringLiteral("^(?:—?$|[(≈]?\\s?[−+]?\\d[\\d\u202f]*)"));
    const QRegularExpressionMatch match = whole.match(text);
    if (!match.hasMatch() || text.contains(letter)) {
        return std::nullopt;
    }
    return metrics.horizontalAdvance(match.captured());
}

// Of a cell with a text, pixels: width on one line, height in a column of a given width.
int widthFor(const QString& text, const QFont& font) {
    QTextDocument document;
    prepare(document, text, font);
    return static_cast<int>(std::ceil(document.idealWidth())) + 2 * padding + 2;
}

int heightFor(const QString& text, const QFont& font, int width) {
    QTextDocument document;
    prepare(document, text, font);
    document.setTextWidth(std::max(20, width - 2 * padding - 1));
    return static_cast<int>(std::ceil(document.size().height())) + 5;
}

// Draws the texts of a table with subscripts, in as many lines as needed. The table sets the
// heights of its rows by heightFor(), because a delegate does not know the width in sizeHint().
class WrappingDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        QStyleOptionViewItem item = option;
        initStyleOption(&item, index);
        const QString text = std::exchange(item.text, {});
        const QStyle* style = item.widget ? item.widget->style() : QApplication::style();
        style->drawControl(QStyle::CE_ItemViewItem, &item, painter, item.widget);
        QTextDocument document;
        prepare(document, text, item.font);
        if (const auto color = index.data(dot_role).value<QColor>(); color.isValid()) {
            QTextCursor first(&document);
            first.movePosition(QTextCursor::NextCharacter, QTextCursor::KeepAnchor);
            QTextCharFormat format;
            format.setForeground(color);
            first.mergeCharFormat(format);
        }
        const int indent = index.data(indent_role).toInt();
        const QRect area = item.rect.adjusted(padding + indent, 2, -padding, -2);
        document.setTextWidth(area.width());
        QAbstractTextDocumentLayout::PaintContext context;
        const bool selected = (item.state & QStyle::State_Selected) != 0;
        context.palette.setColor(
            QPalette::Text,
            item.palette.color(selected ? QPalette::HighlightedText : QPalette::Text));
        painter->save();
        painter->setClipRect(item.rect);
        painter->translate(area.topLeft());
        document.documentLayout()->draw(painter, context);
        painter->restore();
    }
};

}  // namespace

QString cellNumber(double value) {
    return QLocale().toString(value, 'g', 12);
}

QuantityCell measuredCell(double value, double sd, const QColor& color) {
    return {
        valueText(value, sd), {cellNumber(value), cellNumber(sd)}, color, conciseText(value, sd)};
}

void dropEmptyColumns(QStringList& headers, std::vector<QuantityRow>& rows) {
    for (auto k = static_cast<std::size_t>(headers.size()); k-- > 0;) {
        if (std::ranges::all_of(
                rows, [k](const QuantityRow& row) { return row.cells[k].text.isEmpty(); })) {
            headers.removeAt(static_cast<qsizetype>(k));
            for (QuantityRow& row : rows) {
                row.cells.erase(row.cells.begin() + static_cast<std::ptrdiff_t>(k));
            }
        }
    }
}

QString tableText(const QStringList& headers, const std::vector<QuantityRow>& rows) {
    QStringList lines;
    QStringList head{QString()};
    for (int column = 0; column < headers.size() && !rows.empty(); ++column) {
        const QStringList all{headers[column], QuantityTable::tr("sd"), QuantityTable::tr("u")};
        const auto& exact = rows.front().cells[static_cast<std::size_t>(column)].exact;
        head << all.mid(0, exact.size());
    }
    if (headers.isEmpty()) {
        head << QuantityTable::tr("value") << QuantityTable::tr("sd") << QuantityTable::tr("u");
    }
    lines << head.join(QLatin1Char('\t'));
    for (const QuantityRow& row : rows) {
        QStringList cells{row.name};
        for (const QuantityCell& cell : row.cells) {
            cells << cell.exact;
        }
        lines << cells.join(QLatin1Char('\t'));
    }
    return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

QuantityTable::QuantityTable(QWidget* parent) : QTableWidget(parent) {
    setItemDelegate(new WrappingDelegate(this));
    verticalHeader()->hide();
    verticalHeader()->setMinimumSectionSize(8);
    horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    horizontalHeader()->setDefaultAlignment(Qt::Alignment(Qt::AlignLeft | Qt::AlignVCenter) |
                                            Qt::Alignment(Qt::TextWordWrap));
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setSelectionMode(QAbstractItemView::ContiguousSelection);
    setShowGrid(false);
    setTabKeyNavigation(false);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setContextMenuPolicy(Qt::ActionsContextMenu);
    auto* copy = new QAction(this);
    copy->setShortcut(QKeySequence::Copy);
    copy->setShortcutContext(Qt::WidgetShortcut);
    addAction(copy);
    connect(copy, &QAction::triggered, this,
            [this] { QGuiApplication::clipboard()->setText(tableText(headers_, rows_)); });
    keepTranslated(*this, [copy] { copy->setText(tr("Copy table")); });
}

void QuantityTable::setContent(const QStringList& headers, const std::vector<QuantityRow>& rows,
                               const QStringList& short_headers) {
    headers_ = headers;
    short_headers_ = short_headers;
    rows_ = rows;
    concise_ = false;
    clear();
    setRowCount(static_cast<int>(rows.size()));
    setAlternatingRowColors(rows.size() > 5);
    setColumnCount(1 + static_cast<int>(rows.empty() ? static_cast<std::size_t>(headers.size())
                                                     : rows.front().cells.size()));
    horizontalHeader()->setVisible(!headers.isEmpty());
    setHorizontalHeaderItem(0, new QTableWidgetItem);
    for (int column = 0; column < headers.size(); ++column) {
        setHorizontalHeaderItem(column + 1, new QTableWidgetItem);
    }
    showHeaders(headers);
    for (int row = 0; row < rowCount(); ++row) {
        const QuantityRow& from = rows[static_cast<std::size_t>(row)];
        auto* name = new QTableWidgetItem(from.dot.isValid() ? dot + from.name : from.name);
        name->setData(dot_role, from.dot);
        name->setToolTip(richTip(from.tip));
        setItem(row, 0, name);
        for (std::size_t k = 0; k < from.cells.size(); ++k) {
            auto* item = new QTableWidgetItem(from.cells[k].text);
            if (from.cells[k].color.isValid()) {
                item->setForeground(from.cells[k].color);
            }
            if (const QString& tip = from.cells[k].tip; !tip.isEmpty()) {
                item->setToolTip(richTip(tip));
                item->setData(Qt::AccessibleTextRole, tip);
            }
            setItem(row, static_cast<int>(k) + 1, item);
        }
    }
    layOut();
}

void QuantityTable::setColumns(const std::vector<QuantityRow>& quantities,
                               std::vector<QuantityRow> things) {
    QStringList headers;
    for (const QuantityRow& quantity : quantities) {
        headers << indexPlain(quantity.name);
        for (std::size_t k = 0; k < things.size(); ++k) {
            things[k].cells.push_back(quantity.cells[k]);
        }
    }
    setContent(headers, things);
    for (std::size_t k = 0; k < quantities.size(); ++k) {
        horizontalHeaderItem(static_cast<int>(k) + 1)->setToolTip(richTip(quantities[k].tip));
    }
}

void QuantityTable::showHeaders(const QStringList& headers) {
    shown_headers_ = headers;
    for (int column = 0; column < headers.size(); ++column) {
        shown_headers_[column].replace(QLatin1Char('/'), QStringLiteral("/\u2060"));
        horizontalHeaderItem(column + 1)->setText(shown_headers_[column]);
    }
}

// Width of a text in a cell, on one line.
int QuantityTable::widthOf(int row, int column, const QString& text) const {
    return widthFor(text, font()) + item(row, column)->data(indent_role).toInt();
}

// Decimal signs below each other, where a column has nothing but numbers.
void QuantityTable::alignDecimals() {
    for (int column = 1; column < columnCount(); ++column) {
        std::vector<std::optional<int>> widths;
        widths.reserve(static_cast<std::size_t>(rowCount()));
        for (int row = 0; row < rowCount(); ++row) {
            widths.push_back(wholeWidth(item(row, column)->text(), fontMetrics()));
        }
        const bool numbers = std::ranges::all_of(widths, &std::optional<int>::has_value);
        const int most = numbers && !widths.empty() ? std::ranges::max(widths).value() : 0;
        for (int row = 0; row < rowCount(); ++row) {
            const int whole = widths[static_cast<std::size_t>(row)].value_or(0);
            item(row, column)->setData(indent_role, numbers ? most - whole : 0);
        }
    }
}

// Width of a column in which no word breaks.
int QuantityTable::leastWidth(int column) const {
    int width = 0;
    if (!shown_headers_.isEmpty() && column > 0) {
        for (const QString& word : shown_headers_[column - 1].split(QLatin1Char(' '))) {
            width = std::max(width, fontMetrics().horizontalAdvance(word) + header_margin);
        }
    }
    for (int row = 0; row < rowCount(); ++row) {
        for (const QString& word : unbroken(item(row, column)->text()).split(QLatin1Char(' '))) {
            width = std::max(width, widthOf(row, column, word) + 2);
        }
    }
    return width;
}

int QuantityTable::leastWidth() {
    setConcise(true);
    int width = 0;
    for (int column = 0; column < columnCount(); ++column) {
        width += leastWidth(column);
    }
    layOut();
    return width;
}

// As high as its texts in their columns.
int QuantityTable::headerHeight(const std::vector<int>& widths) const {
    int texts = 0;
    for (int column = 0; column < shown_headers_.size(); ++column) {
        const int width = widths[static_cast<std::size_t>(column) + 1];
        const QRect room(0, 0, width - header_margin / 2, QWIDGETSIZE_MAX);
        texts = std::max(
            texts,
            fontMetrics().boundingRect(room, Qt::TextWordWrap, shown_headers_[column]).height());
    }
    return texts > 0 ? texts + horizontalHeader()->sizeHint().height() - fontMetrics().height() : 0;
}

// Takes the excess from the columns from the `first` on, each by its share of the room that
// its words leave.
void QuantityTable::narrow(std::vector<int>& widths, int excess, std::size_t first) {
    std::vector<int> slack(first);
    for (std::size_t k = first; k < widths.size(); ++k) {
        slack.push_back(std::max(0, widths[k] - leastWidth(static_cast<int>(k))));
    }
    const int all = std::accumulate(slack.begin(), slack.end(), 0);
    for (std::size_t k = 0; k < widths.size() && all > 0; ++k) {
        widths[k] -= std::min(slack[k], slack[k] * excess / all + 1);
    }
}

int QuantityTable::heightOf(int row, const std::vector<int>& widths) const {
    int height = 0;
    for (std::size_t k = 0; k < widths.size(); ++k) {
        const int column = static_cast<int>(k);
        const int width = widths[k] - item(row, column)->data(indent_role).toInt();
        height = std::max(height, heightFor(item(row, column)->text(), font(), width));
    }
    return height;
}

void QuantityTable::setConcise(bool concise) {
    for (int row = 0; row < rowCount() && concise != concise_; ++row) {
        const std::vector<QuantityCell>& cells = rows_[static_cast<std::size_t>(row)].cells;
        for (std::size_t k = 0; k < cells.size(); ++k) {
            if (!cells[k].concise.isEmpty()) {
                QTableWidgetItem* of = item(row, static_cast<int>(k) + 1);
                of->setText(concise ? cells[k].concise : cells[k].text);
                of->setToolTip(concise ? richTip(cells[k].text) : QString());
            }
        }
    }
    concise_ = concise;
    alignDecimals();
}

// Widths of the columns with each text on one line, or with sentences in several.
std::vector<int> QuantityTable::wishes(bool wrapped) const {
    const int characters = fontMetrics().averageCharWidth();
    std::vector<int> widths(static_cast<std::size_t>(columnCount()), 0);
    for (int column = 0; column < columnCount(); ++column) {
        int& width = widths[static_cast<std::size_t>(column)];
        if (!shown_headers_.isEmpty() && column > 0) {
            width = fontMetrics().horizontalAdvance(shown_headers_[column - 1]) + header_margin;
        }
        for (int row = 0; row < rowCount(); ++row) {
            const QString text = item(row, column)->text();
            const int wish = widthOf(row, column, text);
            const std::size_t k = static_cast<std::size_t>(column) - 1;
            const bool number =
                column > 0 && !rows_[static_cast<std::size_t>(row)].cells[k].concise.isEmpty();
            const bool sentence = wrapped && !number && text.size() > 36;
            width = std::max(width, sentence ? std::min(wish, 26 * characters) : wish);
        }
    }
    return widths;
}

// Column widths: as wide as needed; the second of two columns takes the rest. Where the table is
// wider than its room, names have two fifths of it, or what their words need, and headers are
// short; where that is not enough, sentences are wrapped, and then numbers are concise.
void QuantityTable::layOut() {
    const int characters = fontMetrics().averageCharWidth();
    const int room = viewport()->width();
    std::vector<int> widths;
    // Whether the table has room, its sentences on one line or in several.
    const auto fits = [&](bool wrapped) {
        widths = wishes(wrapped);
        const auto all = [&widths] { return std::accumulate(widths.begin(), widths.end(), 0); };
        if (all() > room) {
            widths[0] = std::min(widths[0], std::max(room * 2 / 5, leastWidth(0)));
        }
        return all() <= room;
    };
    showHeaders(headers_);
    setConcise(false);
    if (!fits(false)) {
        showHeaders(short_headers_.isEmpty() ? headers_ : short_headers_);
        if (!fits(false) && !fits(true)) {
            setConcise(true);
            fits(true);
        }
    }
    if (widths.size() == 2) {
        widths[1] = std::max(room - widths[0], 14 * characters);
    }
    if (const int excess = std::accumulate(widths.begin(), widths.end(), -room); excess > 0) {
        // Names that keep their width may spare more lines than the cells beside them then need.
        const auto height = [this](const std::vector<int>& of) {
            int sum = headerHeight(of);
            for (int row = 0; row < rowCount(); ++row) {
                sum += heightOf(row, of);
            }
            return sum;
        };
        std::vector<int> named = widths;
        narrow(named, excess, 1);
        narrow(widths, excess, 0);
        if (std::accumulate(named.begin(), named.end(), 0) <= room &&
            height(named) < height(widths)) {
            widths = named;
        }
    }
    place(widths, room);
}

void QuantityTable::place(const std::vector<int>& widths, int room) {
    int total = 0;
    for (int column = 0; column < columnCount(); ++column) {
        setColumnWidth(column, widths[static_cast<std::size_t>(column)]);
        total += columnWidth(column);
    }
    int height = headerHeight(widths);
    horizontalHeader()->setFixedHeight(height);
    for (int row = 0; row < rowCount(); ++row) {
        setRowHeight(row, heightOf(row, widths));
        height += rowHeight(row);
    }
    if (total > room) {
        height += horizontalScrollBar()->sizeHint().height();
    }
    setFixedHeight(height + 2 * frameWidth());
}

void QuantityTable::resizeEvent(QResizeEvent* event) {
    QTableWidget::resizeEvent(event);
    if (event->size().width() != event->oldSize().width()) {
        layOut();
        QMetaObject::invokeMethod(this, &QuantityTable::layOutAround, Qt::QueuedConnection);
    }
}

// A page that was hidden while its table changed keeps the height it had then: the layouts around
// the table, from the inmost, measure again.
void QuantityTable::layOutAround() {
    for (QWidget* around = parentWidget(); around != nullptr && !around->isWindow();
         around = around->parentWidget()) {
        if (QLayout* layout = around->layout()) {
            layout->invalidate();
            layout->activate();
        }
    }
}

}  // namespace vybeg::ui

#include "moc_quantity_table.cpp"
