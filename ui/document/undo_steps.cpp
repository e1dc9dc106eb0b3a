#include "ui/document/undo_steps.h"

#include <utility>

namespace vybeg::ui {

namespace {

class Step : public QUndoCommand {
public:
    Step(UndoSteps::Words words, UndoSteps::Act undo, UndoSteps::Act redo, int gesture)
        : words_(std::move(words)),
          undo_(std::move(undo)),
          redo_(std::move(redo)),
          gesture_(gesture) {}

    QString words() const { return words_(); }
    void undo() override { undo_(); }
    // The stack redoes what it gets, which is done already.
    void redo() override {
        if (std::exchange(done_, false)) {
            return;
        }
        redo_();
    }
    int id() const override { return gesture_; }
    bool mergeWith(const QUndoCommand* other) override {
        redo_ = static_cast<const Step*>(other)->redo_;
        return true;
    }

private:
    UndoSteps::Words words_;
    UndoSteps::Act undo_;
    UndoSteps::Act redo_;
    int gesture_;
    bool done_ = true;
};

}  // namespace

void UndoSteps::add(Words words, Act undo, Act redo, int gesture) {
    stack_.push(new Step(std::move(words), std::move(undo), std::move(redo), gesture));
}

QString UndoSteps::wordsAt(int index) const {
    const auto* step = static_cast<const Step*>(stack_.command(index));
    return step ? step->words() : QString();
}

}  // namespace vybeg::ui
