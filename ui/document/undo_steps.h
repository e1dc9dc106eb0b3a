#pragma once

#include <QString>
#include <QUndoStack>

#include <functional>

namespace vybeg::ui {

// The steps of undo and redo of a document, each with words for the menu in the present language.
class UndoSteps {
public:
    using Words = std::function<QString()>;
    using Act = std::function<void()>;

    UndoSteps() { stack_.setUndoLimit(200); }

    QUndoStack& stack() { return stack_; }
    const QUndoStack& stack() const { return stack_; }
    // A step that is done already. Steps in a row with the same gesture (>= 0), a drag, are one.
    void add(Words words, Act undo, Act redo, int gesture = -1);
    // A step that sets a value, and sets it.
    template <class Value, class Set>
    void change(const Words& words, const Value& before, const Value& after, const Set& set,
                int gesture = -1) {
        add(
            words, [set, before] { set(before); }, [set, after] { set(after); }, gesture);
        set(after);
    }
    // What would be undone and redone; empty: nothing.
    QString undoWords() const { return wordsAt(stack_.index() - 1); }
    QString redoWords() const { return wordsAt(stack_.index()); }

private:
    QString wordsAt(int index) const;

    QUndoStack stack_;
};

}  // namespace vybeg::ui
