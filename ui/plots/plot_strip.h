#pragma once

#include <qcustomplot.h>

#include <vector>

namespace vybeg::ui {

// One entry of a strip: a text, with a sample of a curve before it where `line` is set.
struct StripEntry {
    QString text;
    bool literal = false;  // otherwise an underscore introduces an index
    bool line = false;
    QColor color{};
    Qt::PenStyle dash = Qt::SolidLine;
    QCPScatterStyle points = {};  // if not none, in place of the line
};

// A row of texts of fixed height among the plots: the names of the analyses, the title of a column,
// the name of the time axis. Literal texts are shortened to fit; entries without room are replaced
// by an ellipsis.
class PlotStrip : public QCPLayoutElement {
    Q_OBJECT

public:
    PlotStrip(QCustomPlot* plot, int height);

    void setEntries(std::vector<StripEntry> entries, Qt::Alignment alignment);
    void setLook(const QFont& font, const QColor& text);
    // Free space at both ends and above the text.
    void setInset(int left, int right, int above);
    int height() const { return maximumSize().height(); }
    // One that is not shown leaves a gap.
    void setShown(bool shown) { setHeight(shown ? full_height_ : gap); }
    // Entries in as many rows as they need at a width without being shortened; one wider than that
    // has a row of its own.
    static std::vector<std::vector<StripEntry>> rows(const std::vector<StripEntry>& entries,
                                                     const QFont& font, double available);

protected:
    void draw(QCPPainter* painter) override;

private:
    static constexpr int gap = 4;

    void setHeight(int height);
    // Fills shown_: the entries with their names shortened to fit.
    void shorten(double available);

    int full_height_;
    std::vector<StripEntry> entries_;
    std::vector<StripEntry> shown_;
    Qt::Alignment alignment_ = Qt::AlignLeft;
    QFont font_;
    QColor text_;
    int left_ = 0;
    int right_ = 0;
    int above_ = 0;
};

}  // namespace vybeg::ui
