#pragma once

#include <QColor>
#include <QString>
#include <QStringList>
#include <QTableWidget>

#include <vector>

namespace vybeg::ui {

// A cell: displayed text, and text for a spreadsheet with all digits.
struct QuantityCell {
    QString text;
    // Value, standard deviation and combined uncertainty, or one text, or none where another cell
    // has it; the same number of texts in all rows of a column.
    QStringList exact;
    QColor color;          // of the text; invalid: the usual one
    QString concise = {};  // a number where there is no room for the text: "5300.012(7)"
    QString tip = {};      // the whole of what the text says in short, for a screen reader, too
};

// A number of a cell with twelve digits, in the decimal sign of the interface's language.
QString cellNumber(double value);
// A value with its standard deviation.
QuantityCell measuredCell(double value, double sd, const QColor& color = {});

struct QuantityRow {
    QString name;  // with its unit; an underscore introduces an index
    QString tip;
    std::vector<QuantityCell> cells;
    QColor dot = {};  // before the name
};

// Takes out the columns without a text in any row, and their headers.
void dropEmptyColumns(QStringList& headers, std::vector<QuantityRow>& rows);

// A line of headers, then the rows; tabs between all digits, in the decimal sign of the interface's
// language.
QString tableText(const QStringList& headers, const std::vector<QuantityRow>& rows);

// Quantities with their names and units, a row each. Where they have no room, numbers become
// concise, with the whole of them as tooltips; sentences are wrapped, numbers never. The decimal
// signs of a column of numbers stand below each other. As high as its rows, for use in a scroll
// area. Ctrl+C copies it as tab-separated text.
class QuantityTable : public QTableWidget {
    Q_OBJECT

public:
    explicit QuantityTable(QWidget* parent = nullptr);

    // One header for each cell of a row; {} : no header line. `short_headers` are used where
    // the others have no room.
    void setContent(const QStringList& headers, const std::vector<QuantityRow>& rows,
                    const QStringList& short_headers = {});
    // The width in which no number is cut and no word of a header; numbers are concise.
    int leastWidth();
    // A quantity is a column, its name the header; `things` are the rows, yet without cells.
    void setColumns(const std::vector<QuantityRow>& quantities, std::vector<QuantityRow> things);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void layOut();
    void layOutAround();
    std::vector<int> wishes(bool wrapped) const;
    void alignDecimals();
    int widthOf(int row, int column, const QString& text) const;
    void place(const std::vector<int>& widths, int room);
    void showHeaders(const QStringList& headers);
    int leastWidth(int column) const;
    int headerHeight(const std::vector<int>& widths) const;
    void narrow(std::vector<int>& widths, int excess, std::size_t first);
    int heightOf(int row, const std::vector<int>& widths) const;
    void setConcise(bool concise);

    QStringList headers_;
    QStringList short_headers_;
    QStringList shown_headers_;
    std::vector<QuantityRow> rows_;
    bool concise_ = false;
};

}  // namespace vybeg::ui
