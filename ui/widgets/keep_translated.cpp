#include "ui/widgets/keep_translated.h"

#include <QEvent>
#include <QWidget>

#include <utility>

namespace vybeg::ui {

namespace {

class Translator : public QObject {
public:
    Translator(QWidget& widget, std::function<void()> translate)
        : QObject(&widget), translate_(std::move(translate)) {
        widget.installEventFilter(this);
    }

    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::LanguageChange) {
            translate_();
        }
        return QObject::eventFilter(watched, event);
    }

private:
    std::function<void()> translate_;
};

}  // namespace

void keepTranslated(QWidget& widget, std::function<void()> translate) {
    translate();
    new Translator(widget, std::move(translate));
}

}  // namespace vybeg::ui
