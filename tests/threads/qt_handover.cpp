// Linked into the tests of the window in the build for ThreadSanitizer (preset tsan), which does
// not see how the uninstrumented QtCore hands work from thread to thread, and would report all of
// it as races. These functions take the place of Qt's, show what they order and call them.

#include <QMetaObject>
#include <QThreadPool>

#include <cstdio>
#include <cstdlib>
#include <dlfcn.h>
#include <memory>
#include <sanitizer/tsan_interface.h>

namespace {

// The function of QtCore whose place another one has taken.
template <class Function>
Function replaced(const char* symbol) {
    void* const found = dlsym(RTLD_NEXT, symbol);
    if (!found) {
        std::fprintf(stderr, "QtCore has no %s\n", symbol);
        std::abort();
    }
    return reinterpret_cast<Function>(found);
}

// A slot that is called in another thread: it sees what its caller has done before.
class HandedSlot : public QtPrivate::QSlotObjectBase {
public:
    explicit HandedSlot(QSlotObjectBase* slot) : QSlotObjectBase(&HandedSlot::act), slot_(slot) {
        __tsan_release(this);
    }

private:
    static void act(int which, QSlotObjectBase* self, QObject* receiver, void** args, bool* same) {
        auto* const handed = static_cast<HandedSlot*>(self);
        switch (which) {
            case Destroy:
                __tsan_acquire(handed);
                handed->slot_->destroyIfLastRef();
                delete handed;
                break;
            case Call:
                __tsan_acquire(handed);
                handed->slot_->call(receiver, args);
                break;
            case Compare: *same = handed->slot_->compare(args); break;
            default: break;
        }
    }

    QSlotObjectBase* slot_;
};

}  // namespace

void QThreadPool::start(std::function<void()> work, int priority) {
    static const auto start = replaced<void (*)(QThreadPool*, std::function<void()>, int)>(
        "_ZN11QThreadPool5startESt8functionIFvvEEi");
    // Destroyed in the thread that has run it.
    const auto handed = std::make_shared<std::function<void()>>(std::move(work));
    __tsan_release(handed.get());
    start(
        this,
        [this, handed] {
            __tsan_acquire(handed.get());
            (*handed)();
            *handed = nullptr;
            __tsan_release(this);
        },
        priority);
}

bool QThreadPool::waitForDone(int most_ms) {
    static const auto wait =
        replaced<bool (*)(QThreadPool*, int)>("_ZN11QThreadPool11waitForDoneEi");
    const bool done = wait(this, most_ms);
    __tsan_acquire(this);
    return done;
}

bool QMetaObject::invokeMethodImpl(QObject* object, QtPrivate::QSlotObjectBase* slot,
                                   Qt::ConnectionType type, void* result) {
    static const auto invoke =
        replaced<bool (*)(QObject*, QtPrivate::QSlotObjectBase*, Qt::ConnectionType, void*)>(
            "_ZN11QMetaObject16invokeMethodImplEP7QObjectPN9QtPrivate15QSlotObjectBaseEN2Qt14Conne"
            "ctionTypeEPv");
    return invoke(object, new HandedSlot(slot), type, result);
}
