#include "ui/report/report_document.h"

#include "core/output/output_file.h"
#include "ui/resonator/parameter_text.h"
#include "ui/resonator/resonator_text.h"
#include "ui/words/display_units.h"
#include "ui/words/rich_text.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QCoreApplication>
#include <QDateTime>
#include <QFontDatabase>
#include <QGuiApplication>
#include <QPageLayout>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QTextBlock>
#include <QTextDocument>
#include <QTextFrame>
#include <QTextObjectInterface>
#include <QTextOption>
#include <QTimer>
#include <qpdf/qpdf-c.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <optional>
#include <utility>

namespace vybeg::ui {

namespace {

QString madeText(const QString& program, QDate made) {
    return QStringLiteral("%1, %2").arg(dateText(made.toString(Qt::ISODate)), program);
}

// Placeholder in the table of all sets: the layout puts the number of a chapter's page there.
QString chapterMark(int number) {
    return QStringLiteral("⟦%1⟧").arg(number);
}

// "Set, gyro" where they differ.
QString nameOf(const ReportContent& content) {
    const QString& gyro = content.title.gyro;
    return gyro.isEmpty() || gyro == content.set ? content.set
                                                 : QStringLiteral("%1, %2").arg(content.set, gyro);
}

QStringList lineOf(const ReportContent& content) {
    QStringList cells{nameOf(content).toHtmlEscaped(), chapterMark(content.chapter)};
    if (!content.outcome) {
        return cells << richText(absenceText(content));
    }
    const ResonatorEstimate& resonator = content.outcome->identification.fit.resonator;
    const auto add = [&cells](const Estimate& estimate, double factor) {
        cells << (estimate.given()
                      ? valueText(factor * estimate.value, factor * estimate.uncertainty())
                      : QStringLiteral("—"));
    };
    add(resonator.f_mean_hz, 1);
    add(resonator.split_hz, 1e3);
    add(resonator.theta_w_rad, angleFactor(content.units));
    add(resonator.q, 1);
    return cells;
}

constexpr int resolution = 1200;
constexpr double scale = resolution / pixels_per_inch;  // device pixels of a pixel
// Above the content of a page, and below it, pixels.
constexpr double head_height = 34;
constexpr double foot_height = 34;

constexpr int base_points = 9;
constexpr double least_spacing = 1.0 / 32;  // pixels of the page; Qt counts in 64ths

const char* const style_sheet =
    "h1 { font-size: 17pt; margin-bottom: 8px; }"
    "h2 { font-size: 12.5pt; margin-top: 14px; margin-bottom: 5px; }"
    "h3 { font-size: 10pt; margin-top: 10px; margin-bottom: 3px; }"
    "p, li { margin-top: 2px; margin-bottom: 3px; }"
    "p.figure { margin-top: 0px; margin-bottom: 0px; }"
    "table { border-collapse: collapse; }"
    "th { text-align: left; background-color: #e9edf2; border: 1px solid #b8c0c8; }"
    "td { border: 1px solid #c9d0d6; }"
    ".number { white-space: nowrap; }"
    "table.figures td { border: 0px; }"
    "table.small { font-size: 7.5pt; }";

// Draws the figures in place of images.
class Figures : public QObject, public QTextObjectInterface {
    Q_OBJECT
    Q_INTERFACES(QTextObjectInterface)

public:
    explicit Figures(const std::vector<ReportFigure>& figures) : figures_(figures) {}

    QSizeF intrinsicSize(QTextDocument*, int, const QTextFormat& format) override {
        const ReportFigure* figure = find(format);
        return figure ? figure->paper * scale : QSizeF();
    }

    void drawObject(QPainter* painter, const QRectF& room, QTextDocument*, int,
                    const QTextFormat& format) override {
        if (const ReportFigure* figure = find(format)) {
            QPicture own = figure->picture;
            // What a picture itself scales by as it is played.
            const double own_scale =
                double(painter->device()->logicalDpiX()) / double(own.logicalDpiX());
            painter->save();
            painter->translate(room.topLeft());
            painter->scale(room.width() / (own_scale * figure->drawn.width()),
                           room.height() / (own_scale * figure->drawn.height()));
            painter->drawPicture(0, 0, own);
            painter->restore();
        }
    }

private:
    const ReportFigure* find(const QTextFormat& format) const {
        const auto found =
            std::ranges::find(figures_, format.toImageFormat().name(), &ReportFigure::name);
        return found == figures_.end() ? nullptr : &*found;
    }

    const std::vector<ReportFigure>& figures_;
};

int pageOf(const QTextDocument& document, const QTextBlock& block) {
    const QRectF place = document.documentLayout()->blockBoundingRect(block);
    return static_cast<int>(std::floor(place.bottom() / document.pageSize().height()));
}

// A table that a page has room for starts on a new one, with the headings above it, rather than go
// over its end: Qt breaks the cells of a row one by one.
void keepTablesWhole(QTextDocument& document) {
    const double page = document.pageSize().height();
    for (QTextFrame* frame : document.rootFrame()->childFrames()) {
        const QRectF place = document.documentLayout()->frameBoundingRect(frame);
        const bool whole =
            std::floor(place.top() / page) == std::floor((place.bottom() - 1) / page);
        QTextBlock top = document.findBlock(frame->firstPosition());
        while (top.previous().isValid() && top.previous().blockFormat().headingLevel() > 0) {
            top = top.previous();
        }
        const double height =
            place.bottom() - document.documentLayout()->blockBoundingRect(top).top();
        if (whole || height > page) {
            continue;
        }
        if (top.blockFormat().headingLevel() > 0) {
            QTextBlockFormat format = top.blockFormat();
            format.setPageBreakPolicy(QTextFormat::PageBreak_AlwaysBefore);
            QTextCursor(top).setBlockFormat(format);
        } else {
            QTextFrameFormat format = frame->frameFormat();
            format.setPageBreakPolicy(QTextFormat::PageBreak_AlwaysBefore);
            frame->setFrameFormat(format);
        }
    }
}

// Of a figure that begins on one page and ends on another; Qt draws it over the end of the first.
bool isFigureAcrossPages(const QTextDocument& document, const QTextBlock& block) {
    const double page = document.pageSize().height();
    const QRectF place = document.documentLayout()->blockBoundingRect(block);
    return block.begin() != block.end() && block.begin().fragment().charFormat().isImageFormat() &&
           std::floor(place.top() / page) != std::floor((place.bottom() - 1) / page);
}

// A heading is kept with the text below it, a figure on one page. Each break moves all that
// follows, so that blocks are looked at one after the other.
void keepTogether(QTextDocument& document) {
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
        QTextBlock below = block.next();
        while (below.isValid() && below.blockFormat().headingLevel() > 0) {
            below = below.next();
        }
        const bool is_heading = block.blockFormat().headingLevel() > 0;
        if ((is_heading && below.isValid() && pageOf(document, below) != pageOf(document, block)) ||
            isFigureAcrossPages(document, block)) {
            QTextBlockFormat format = block.blockFormat();
            format.setPageBreakPolicy(QTextFormat::PageBreak_AlwaysBefore);
            QTextCursor(block).setBlockFormat(format);
        }
    }
}

// The text with the page of each chapter in place of its mark.
QString withPages(QString html, const QTextDocument& document) {
    int chapter = 0;
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
        const QTextBlockFormat format = block.blockFormat();
        if (format.headingLevel() == 1 &&
            format.pageBreakPolicy() == QTextFormat::PageBreak_AlwaysBefore) {
            html.replace(chapterMark(++chapter), QString::number(pageOf(document, block) + 1));
        }
    }
    return html;
}

// Lays out all: Qt does so step by step, and a change before the last step leaves out the blocks of
// the rest; counting the pages finishes it.
void setHtml(QTextDocument& document, const QString& html, QTextOption::WrapMode wrap) {
    QTextOption option = document.defaultTextOption();
    option.setWrapMode(wrap);
    document.setDefaultTextOption(option);
    document.setHtml(html);
    (void)document.pageCount();
}

bool isWithinPage(const QTextDocument& document) {
    const auto& layout = *document.documentLayout();
    const double width = document.pageSize().width() + 1;
    return document.idealWidth() <= width &&
           std::ranges::all_of(document.rootFrame()->childFrames(), [&](QTextFrame* frame) {
               return layout.frameBoundingRect(frame).width() <= width;
           });
}

// A column is as wide as its longest word; only where a page has no room for them, as for long
// names of files, words are broken.
void layOut(QTextDocument& document, const QString& html) {
    setHtml(document, html, QTextOption::WordWrap);
    if (!isWithinPage(document)) {
        setHtml(document, html, QTextOption::WrapAtWordBoundaryOrAnywhere);
    }
    keepTablesWhole(document);
    keepTogether(document);
}

struct Heading {
    QString text;
    std::size_t level = 1;
    int page = 0;         // from 0
    double place_pt = 0;  // above the lower edge of the page
};

// `top`: from the upper edge of a page of this height to its content, device pixels.
std::vector<Heading> headingsOf(const QTextDocument& document, double page_height, double top) {
    constexpr double points = 72.0 / resolution;
    std::vector<Heading> headings;
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
        if (const int level = block.blockFormat().headingLevel(); level > 0) {
            const int page = std::min(pageOf(document, block), document.pageCount() - 1);
            const double place = document.documentLayout()->blockBoundingRect(block).top() -
                                 page * document.pageSize().height();
            headings.push_back({block.text(), static_cast<std::size_t>(level), page,
                                (page_height - top - place) * points});
        }
    }
    return headings;
}

// A document of qpdf, which makes what QPdfWriter of Qt 6.4 cannot.
class PdfObjects {
public:
    using Object = qpdf_oh;

    explicit PdfObjects(const QByteArray& bytes) : pdf_(qpdf_init()) {
        qpdf_silence_errors(pdf_);
        read_ = !failed(qpdf_read_memory(pdf_, "report", bytes.constData(),
                                         static_cast<unsigned long long>(bytes.size()), nullptr));
    }
    ~PdfObjects() { qpdf_cleanup(&pdf_); }
    PdfObjects(const PdfObjects&) = delete;
    PdfObjects& operator=(const PdfObjects&) = delete;

    bool read() const { return read_; }
    Object root() { return qpdf_get_root(pdf_); }
    Object page(int index) { return qpdf_get_page_n(pdf_, static_cast<std::size_t>(index)); }
    Object dictionary() { return qpdf_make_indirect_object(pdf_, qpdf_oh_new_dictionary(pdf_)); }
    Object name(const char* name) { return qpdf_oh_new_name(pdf_, name); }
    Object text(const QString& text) {
        return qpdf_oh_new_unicode_string(pdf_, text.toUtf8().constData());
    }
    Object place(int page_index, double above_pt) {
        const Object place = qpdf_oh_new_array(pdf_);
        for (const Object each :
             {page(page_index), name("/XYZ"), qpdf_oh_new_null(pdf_),
              qpdf_oh_new_real_from_double(pdf_, above_pt, 1), qpdf_oh_new_null(pdf_)}) {
            qpdf_oh_append_item(pdf_, place, each);
        }
        return place;
    }
    void set(Object of, const char* key, Object value) {
        qpdf_oh_replace_key(pdf_, of, key, value);
    }
    void count(Object of, const char* key) {
        const Object now = qpdf_oh_get_key(pdf_, of, key);
        const long long number =
            qpdf_oh_is_integer(pdf_, now) != 0 ? qpdf_oh_get_int_value(pdf_, now) : 0;
        set(of, key, qpdf_oh_new_integer(pdf_, number + 1));
    }
    // Nothing: it could not be written. The same objects give the same bytes.
    QByteArray written() {
        if (failed(qpdf_init_write_memory(pdf_))) {
            return {};
        }
        qpdf_set_stream_data_mode(pdf_, qpdf_s_preserve);
        qpdf_set_deterministic_ID(pdf_, QPDF_TRUE);
        return failed(qpdf_write(pdf_))
                   ? QByteArray()
                   : QByteArray(reinterpret_cast<const char*>(qpdf_get_buffer(pdf_)),
                                static_cast<qsizetype>(qpdf_get_buffer_length(pdf_)));
    }

private:
    static bool failed(QPDF_ERROR_CODE code) { return (code & QPDF_ERRORS) != 0; }

    qpdf_data pdf_;
    bool read_ = false;
};

// The pages with their headings as the outline that viewers show beside them; as they were where
// that cannot be made.
QByteArray withOutline(const QByteArray& bytes, const std::vector<Heading>& headings) {
    using Object = PdfObjects::Object;
    PdfObjects pdf(bytes);
    if (!pdf.read()) {
        return bytes;
    }
    // The outline, and below it the last heading of each level, each with its last one below.
    struct Level {
        Object object = 0;
        std::optional<Object> last{};
    };
    std::vector<Level> path{{pdf.dictionary()}};
    for (const Heading& heading : headings) {
        path.resize(std::min(path.size(), heading.level));
        for (const Level& above : path) {
            pdf.count(above.object, "/Count");
        }
        Level& parent = path.back();
        const Object item = pdf.dictionary();
        pdf.set(item, "/Title", pdf.text(heading.text));
        pdf.set(item, "/Parent", parent.object);
        pdf.set(item, "/Dest", pdf.place(heading.page, heading.place_pt));
        if (parent.last) {
            pdf.set(*parent.last, "/Next", item);
            pdf.set(item, "/Prev", *parent.last);
        } else {
            pdf.set(parent.object, "/First", item);
        }
        pdf.set(parent.object, "/Last", item);
        parent.last = item;
        path.push_back({item});
    }
    pdf.set(pdf.root(), "/Outlines", path.front().object);
    pdf.set(pdf.root(), "/PageMode", pdf.name("/UseOutlines"));
    const QByteArray written = pdf.written();
    return written.isEmpty() ? bytes : written;
}

// As XML, with the characters that it reserves.
QByteArray metadata(const ReportText& text) {
    const QString author =
        QStringLiteral("<dc:creator><rdf:Seq><rdf:li>%1</rdf:li></rdf:Seq></dc:creator>")
            .arg(text.author.toHtmlEscaped());
    return (QStringLiteral("<?xpacket begin=\"\xEF\xBB\xBF\" id=\"W5M0MpCehiHzreSzNTczkc9d\"?>"
                           "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\">"
                           "<rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\">"
                           "<rdf:Description rdf:about=\"\" "
                           "xmlns:dc=\"http://purl.org/dc/elements/1.1/\" "
                           "xmlns:xmp=\"http://ns.adobe.com/xap/1.0/\">"
                           "<dc:title><rdf:Alt><rdf:li xml:lang=\"x-default\">%1</rdf:li></rdf:Alt>"
                           "</dc:title>%2"
                           "<xmp:CreatorTool>%3</xmp:CreatorTool></rdf:Description></rdf:RDF>"
                           "</x:xmpmeta><?xpacket end=\"w\"?>")
                .arg(text.title.toHtmlEscaped(), text.author.isEmpty() ? QString() : author,
                     text.program.toHtmlEscaped()))
        .toUtf8();
}

ReportText textOf(const std::vector<ReportContent>& contents, const QString& about) {
    if (contents.size() == 1) {
        return reportTextOf(contents.front());
    }
    std::vector<ReportChapter> chapters;
    std::ranges::transform(contents, std::back_inserter(chapters), chapterOf);
    return reportTextOf(about, chapters, contents.front().units);
}

}  // namespace

ReportText framedReport(const QString& report, const QString& about, const QString& program) {
    ReportText text;
    text.title = QStringLiteral("%1: %2").arg(report, about);
    text.program = program;
    text.foot = ReportWords::tr("Page %1 of %2");
    text.html = QStringLiteral("<h1>%1</h1>").arg(report.toHtmlEscaped());
    return text;
}

QString reportProgram() {
    return QStringLiteral("Vybeg ") + QCoreApplication::applicationVersion();
}

QDate reportDay() {
    bool told = false;
    const qint64 seconds = qEnvironmentVariable("SOURCE_DATE_EPOCH").toLongLong(&told);
    const QDate day = QDateTime::fromSecsSinceEpoch(seconds, Qt::UTC).date();
    return told && day.isValid() ? day : QDate::currentDate();
}

ReportText reportTextOf(const ReportContent& content, const QString& program, QDate made) {
    QStringList names;
    for (const ReportRecording& recording : content.recordings) {
        names << recording.name();
    }
    for (std::size_t k = 0; ofLogsAlone(content) && k < content.drift->drift.logs.size(); ++k) {
        names << QString::fromStdString(content.drift->drift.logs[k].name);
    }
    const QString& gyro = content.title.gyro;
    ReportText text =
        framedReport(ofLogsAlone(content) ? ReportWords::tr("Report of whole-angle logs")
                                          : ReportWords::tr("Report of a free decay"),
                     gyro.isEmpty() ? firstAndLast(names) : gyro, program);
    text.author = content.title.engineer;
    text.html += titleBlock(content.title, madeText(program, made)) + reportSections(content);
    return text;
}

ReportChapter chapterOf(const ReportContent& content) {
    const bool assumed = content.outcome && anyAssumed(content.outcome->identification.settings);
    return {lineOf(content),
            QStringLiteral("<h1 style=\"page-break-before:always\">%1</h1>")
                    .arg(content.set.toHtmlEscaped()) +
                titleBlock(content.title, {}) + reportSections(content),
            assumed};
}

ReportText reportTextOf(const QString& about, const std::vector<ReportChapter>& chapters,
                        const DisplayUnits& units, const QString& program, QDate made) {
    const auto head = [](const QString& text, const QString& unit = {}) {
        return richText(withUnit(text, unit));
    };
    HtmlTable table{{head(ReportWords::tr("Set, gyro")), head(ReportWords::tr("Page")),
                     head(ReportWords::tr("Mean f"), unitText("Hz")),
                     head(ReportWords::tr("Split Δf"), siPrefix(-3) + unitText("Hz")),
                     head(ReportWords::tr("Axis θ_w"), angleUnit(units)),
                     head(ReportWords::tr("Quality factor Q"))},
                    {},
                    {17, 7, 25, 23, 14, 14},
                    true};
    const QString combined =
        std::ranges::any_of(chapters, &ReportChapter::assumed)
            ? ReportWords::tr(
                  "Values with their combined standard uncertainties u, with assumed tolerances of "
                  "the channels. A dash: the recordings do not show it; the page of the set gives "
                  "the reason.")
            : ReportWords::tr(
                  "Values with their combined standard uncertainties u. A dash: the recordings do "
                  "not show it; the page of the set gives the reason.");
    QString pages;
    for (const ReportChapter& chapter : chapters) {
        table.rows.push_back(chapter.line);
        pages += chapter.html;
    }
    ReportText text = framedReport(ReportWords::tr("Report of free decays"), about, program);
    text.html += paragraph(QStringLiteral("%1: %2").arg(ReportWords::tr("Report made"),
                                                        madeText(program, made))) +
                 heading(ReportWords::tr("All sets")) + paragraph(combined) + html(table) + pages;
    return text;
}

QByteArray reportPdf(const ReportText& text, const std::vector<ReportFigure>& figures) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter pdf(&buffer);
    pdf.setResolution(resolution);
    pdf.setPageSize(QPageSize(QPageSize::A4));
    pdf.setPageMargins(QMarginsF(), QPageLayout::Point);
    pdf.setTitle(text.title);
    pdf.setCreator(text.program);
    pdf.setDocumentXmpMetadata(metadata(text));
    const QSizeF content = report_page * scale;
    const double left = (pdf.width() - content.width()) / 2;
    const double top = (pdf.height() - content.height()) / 2;

    Figures drawings(figures);
    QTextDocument document;
    QFont font(QGuiApplication::font().family());
    font.setPointSizeF(base_points);
    // With any spacing Qt sets no ligatures, so that a search finds "fi".
    font.setLetterSpacing(QFont::AbsoluteSpacing, least_spacing);
    document.setDefaultFont(font);
    document.setDocumentMargin(0);
    document.setDefaultStyleSheet(
        QLatin1String(style_sheet) +
        QStringLiteral(".mono { font-family: \"%1\"; font-size: 7.5pt; }")
            .arg(QFontDatabase::systemFont(QFontDatabase::FixedFont).family()));
    document.documentLayout()->registerHandler(QTextFormat::ImageObject, &drawings);
    document.documentLayout()->setPaintDevice(&pdf);
    document.setPageSize(content);
    layOut(document, text.html);
    // The numbers are as long as their marks or shorter: the second layout has the pages of the
    // first.
    if (const QString told = withPages(text.html, document); told != text.html) {
        layOut(document, told);
    }

    QPainter painter(&pdf);
    font.setPointSizeF(7.5);
    const int pages = document.pageCount();
    for (int page = 0; page < pages; ++page) {
        if (page > 0) {
            pdf.newPage();
        }
        painter.setFont(font);
        painter.setPen(Qt::darkGray);
        const QRectF head(left, top - head_height * scale, content.width(), 24 * scale);
        painter.drawText(head, Qt::AlignLeft | Qt::AlignVCenter,
                         painter.fontMetrics().elidedText(text.title, Qt::ElideMiddle,
                                                          static_cast<int>(head.width())));
        const QRectF foot(left, top + content.height() + (foot_height - 24) * scale,
                          content.width(), 24 * scale);
        painter.drawText(foot, Qt::AlignRight | Qt::AlignVCenter,
                         text.foot.arg(page + 1).arg(pages));
        painter.drawText(foot, Qt::AlignLeft | Qt::AlignVCenter, text.program);
        painter.save();
        const QRectF shown(0, page * content.height(), content.width(), content.height());
        painter.translate(left, top - shown.top());
        painter.setClipRect(shown);
        QAbstractTextDocumentLayout::PaintContext context;
        context.clip = shown;
        context.palette.setColor(QPalette::Text, Qt::black);
        document.documentLayout()->draw(&painter, context);
        painter.restore();
    }
    painter.end();
    return withOutline(withoutInstant(std::move(bytes)), headingsOf(document, pdf.height(), top));
}

struct ReportWriter::Work {
    std::vector<ReportFigure> figures;
    std::size_t drawn = 0;  // of them
    ReportText text;
    QString path;
    std::function<void(const Status&)> done;
};

void ReportWriter::write(const std::vector<ReportContent>& contents, const QString& about,
                         const QString& path, std::function<void(const Status&)> done) {
    std::vector<ReportFigure> figures;
    for (const ReportContent& content : contents) {
        std::ranges::move(reportFigures(content), std::back_inserter(figures));
    }
    write(textOf(contents, about), std::move(figures), path, std::move(done));
}

void ReportWriter::write(ReportText text, std::vector<ReportFigure> figures, const QString& path,
                         std::function<void(const Status&)> done) {
    auto work = std::make_shared<Work>();
    work->figures = std::move(figures);
    work->text = std::move(text);
    work->path = path;
    work->done = std::move(done);
    drawNext(work);
}

void ReportWriter::drawNext(const std::shared_ptr<Work>& work) {
    if (work->drawn < work->figures.size()) {
        ReportFigure& next = work->figures[work->drawn++];
        next = drawn(std::move(next));
        QTimer::singleShot(0, this, [this, work] { drawNext(work); });
        return;
    }
    job_.write(
        ++key_,
        [work](const JobControl& job) {
            const QByteArray pdf = reportPdf(work->text, work->figures);
            return write_file(std::filesystem::path(work->path.toStdU16String()),
                              {pdf.constData(), static_cast<std::size_t>(pdf.size())}, job);
        },
        [work](const Status& status) { work->done(status); });
}

}  // namespace vybeg::ui

#include "moc_report_document.cpp"
#include "report_document.moc"
