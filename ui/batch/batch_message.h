#pragma once

#include <QLabel>

#include <functional>
#include <vector>

namespace vybeg::ui {

// How a batch ended, below the warnings of its list. Texts are functions, so that a change of
// language reaches them. Hidden while there is nothing to say.
class BatchMessage : public QLabel {
    Q_OBJECT

public:
    using Text = std::function<QString()>;

    explicit BatchMessage(QWidget* parent);

    void begin();  // a new batch: nothing to say
    void warn(Text text);
    void end(Text text, bool fault);
    void refresh();  // in the present language

protected:
    void changeEvent(QEvent* event) override;

private:
    void color();

    std::vector<Text> warnings_;
    Text end_;
    bool fault_ = false;
};

}  // namespace vybeg::ui
