#include "ui/document/passport_store.h"

#include "ui/values/recording_set.h"
#include "ui/words/error_text.h"

#include <QFileInfo>

#include <filesystem>
#include <utility>

namespace vybeg::ui {

namespace {

constexpr int passport_key = -2;  // a file replaces one that is being read

// `before` with what was read.
PassportInput inputOf(PassportInput before, PassportComparison read) {
    before.file.path = std::filesystem::path(QString::fromStdString(read.file).toStdU16String());
    before.file.sha256 = std::move(read.sha256);
    before.passport = std::make_shared<const Passport>(std::move(read.passport));
    return before;
}

}  // namespace

void PassportStore::read(const QString& path, Done<PassportComparison> done) {
    job_.run<PassportComparison>(
        passport_key,
        [from = path.toStdString()](const JobControl& job) { return open_passport(from, job); },
        std::move(done));
}

void PassportStore::open(const QString& path) {
    read(QFileInfo(path).absoluteFilePath(), [this](Result<PassportComparison> read) {
        if (!read) {
            emit reported(errorMessage(read.error()));
            return;
        }
        step([] { return tr("open the passport"); }, inputOf(input_, std::move(*read)));
        emit opened();
    });
}

void PassportStore::close() {
    step([] { return tr("close the passport"); }, {{}, nullptr, input_.f_limit_ppm});
}

void PassportStore::setFrequencyLimit(double ppm) {
    if (ppm != input_.f_limit_ppm) {
        step([] { return tr("limit of the frequencies' changes"); },
             {input_.file, input_.passport, ppm});
    }
}

void PassportStore::startWith(const PassportInput& input) {
    job_.forget(passport_key);
    show(input);
    if (!input.file.path.empty()) {
        read(pathText(input.file),
             [this](Result<PassportComparison> read) { takeOfSession(std::move(read)); });
    }
}

void PassportStore::takeOfSession(Result<PassportComparison>&& read) {
    const QString path = pathText(input_.file);
    if (!read) {
        Message message = warningMessage([error = read.error()] {
            return tr("The session's passport cannot be opened: %1 The results are shown without "
                      "the comparison.")
                .arg(errorText(error));
        });
        message.buttons = {{[] { return tr("Find…"); }, [this] { emit wanted(); }}};
        emit reported(message);
        return;
    }
    if (!input_.file.sha256.empty() && input_.file.sha256 != read->sha256) {
        emit reported(warningMessage([path] {
            return tr("%1 is another passport than that of the session: its SHA-256 differs. The "
                      "results are compared with the present one.")
                .arg(path);
        }));
    }
    show(inputOf(input_, std::move(*read)));
}

void PassportStore::step(const UndoSteps::Words& words, const PassportInput& after) {
    steps_.change(words, input_, after, [this](const PassportInput& input) { show(input); });
}

void PassportStore::show(const PassportInput& input) {
    input_ = input;
    emit changed();
}

std::vector<Difference> PassportStore::differences(const ResonatorFit& now) const {
    return content() ? compare(*content(), now, {.f_limit_ppm = input_.f_limit_ppm})
                     : std::vector<Difference>();
}

}  // namespace vybeg::ui

#include "moc_passport_store.cpp"
