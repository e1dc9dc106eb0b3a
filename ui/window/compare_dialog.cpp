#include "ui/window/compare_dialog.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QPushButton>
#include <QRegularExpression>
#include <QVBoxLayout>

#include <algorithm>

namespace vybeg::ui {

// A picture, as large as it fits, on paper white.
class PictureView : public QWidget {
public:
    using QWidget::QWidget;

    void setPicture(const QPicture& picture, QSize size) {
        picture_ = picture;
        size_ = size;
        update();
    }

protected:
    void paintEvent(QPaintEvent*) override {
        if (size_.isEmpty()) {
            return;
        }
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        const double scale = std::min(static_cast<double>(width()) / size_.width(),
                                      static_cast<double>(height()) / size_.height());
        painter.translate((width() - scale * size_.width()) / 2,
                          (height() - scale * size_.height()) / 2);
        painter.scale(scale, scale);
        painter.fillRect(QRect(QPoint(0, 0), size_), Qt::white);
        painter.drawPicture(0, 0, picture_);
    }

private:
    QPicture picture_;
    QSize size_;
};

std::vector<std::int64_t> readLengths(const QString& text) {
    static const QRegularExpression separators(QStringLiteral("[\\s,;]+"));
    std::vector<std::int64_t> lengths;
    for (const QString& part : text.split(separators, Qt::SkipEmptyParts)) {
        bool number = false;
        const qint64 length = part.toLongLong(&number);
        if (!number || length < 5) {
            return {};
        }
        lengths.push_back(length);
    }
    return lengths;
}

CompareDialog::CompareDialog(QWidget* parent) : QDialog(parent) {
    resize(960, 760);
    label_ = new QLabel(this);
    list_ = new QLineEdit(QStringLiteral("6, 60"), this);
    label_->setBuddy(list_);
    compare_ = new QPushButton(this);
    compare_->setDefault(true);
    export_ = new QPushButton(this);
    hint_ = new QLabel(this);
    hint_->setAlignment(Qt::AlignCenter);
    hint_->setWordWrap(true);
    figure_ = new PictureView(this);
    figure_->setMinimumSize(400, 300);
    figure_->hide();
    auto* line = new QHBoxLayout;
    line->addWidget(label_);
    line->addWidget(list_, 1);
    line->addWidget(compare_);
    line->addWidget(export_);
    auto* column = new QVBoxLayout(this);
    column->addLayout(line);
    column->addWidget(hint_, 1);
    column->addWidget(figure_, 1);
    connect(list_, &QLineEdit::textChanged, this, &CompareDialog::refreshButtons);
    connect(compare_, &QPushButton::clicked, this, [this] { emit compareWanted(lengths()); });
    connect(export_, &QPushButton::clicked, this, &CompareDialog::exportWanted);
    retranslate();
}

std::vector<std::int64_t> CompareDialog::lengths() const {
    return readLengths(list_->text());
}

void CompareDialog::setLengths(const QString& text) {
    list_->setText(text);
}

void CompareDialog::setBusy(bool busy) {
    busy_ = busy;
    refreshButtons();
}

void CompareDialog::showFigure(std::vector<FigureColumn> columns, const FigureOptions& options) {
    columns_ = std::move(columns);
    const QSize size = figureSize(columns_.size(), options);
    figure_->setPicture(toPicture(figureDrawing(columns_, options), size), size);
    hint_->hide();
    figure_->show();
    refreshButtons();
}

void CompareDialog::refreshButtons() {
    compare_->setEnabled(!busy_ && !lengths().empty());
    export_->setEnabled(!columns_.empty());
}

void CompareDialog::changeEvent(QEvent* event) {
    QDialog::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
    }
}

void CompareDialog::retranslate() {
    setWindowTitle(tr("Compare windows"));
    label_->setText(tr("Window lengths, samples"));
    list_->setAccessibleName(tr("Window lengths, samples"));
    list_->setToolTip(
        tr("Whole numbers from 5, separated by commas. The article compares 6 and "
           "60 and varies 6, 12, ... 60."));
    compare_->setText(tr("Compare"));
    export_->setText(tr("Export figure…"));
    hint_->setText(
        tr("The figure of the article: the slow variables over time, one column per "
           "window length, with the algorithm and the other settings of the analysis "
           "panel."));
    figure_->setAccessibleName(tr("Slow variables for each window length"));
    refreshButtons();
}

}  // namespace vybeg::ui
