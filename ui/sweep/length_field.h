#pragma once

#include <QLineEdit>

#include <cstdint>
#include <vector>

namespace vybeg::ui {

// Window lengths as typed: numbers and ranges "6..600" (about 15 lengths in equal ratios),
// separated by commas, semicolons or spaces; ascending, each once.
struct LengthList {
    std::vector<std::int64_t> lengths;
    QString refusal;  // why the text is no such list; empty for a list
};
LengthList readLengthList(const QString& text);

// A field for such a list. A wrong one is framed in red, with the reason as its tooltip.
class LengthField : public QLineEdit {
    Q_OBJECT

public:
    explicit LengthField(QWidget* parent = nullptr);

    LengthList list() const { return readLengthList(text()); }
    // Texts of the field itself, in the language of the interface.
    void retranslate();

protected:
    void paintEvent(QPaintEvent* event) override;
};

}  // namespace vybeg::ui
