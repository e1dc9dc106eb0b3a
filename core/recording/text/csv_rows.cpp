#include "core/recording/text/csv_rows.h"

#include "core/base/number_text.h"
#include "core/base/plain_text.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/bytes/text_encoding.h"
#include "core/recording/samples/text_fields.h"
#include "core/recording/text/text_lines.h"

#include <algorithm>
#include <span>
#include <string_view>
#include <utility>

namespace vybeg {
namespace {

// Bytes of the longest row of several lines: a quote that never closes ends there.
constexpr std::size_t longest_row = std::size_t{1} << 16;

// A quote that is open at the end of a line may close in the next one.
constexpr char quote_open[] = VYBEG_MESSAGE("Words", "its quotation mark does not close");

struct SplitRow {
    std::vector<std::string> fields;
    const char* fault = nullptr;  // of the last field
};

// The end of a quoted field: the place of its closing quote, or npos.
std::size_t closing_quote(const std::string& text, std::size_t at) {
    for (at = text.find('"', at); at != std::string::npos; at = text.find('"', at + 2)) {
        if (at + 1 >= text.size() || text[at + 1] != '"') {
            break;
        }
    }
    return at;
}

std::string without_doubled_quotes(std::string text) {
    for (std::size_t at = text.find("\"\""); at != std::string::npos;
         at = text.find("\"\"", at + 1)) {
        text.erase(at, 1);
    }
    return text;
}

SplitRow split_row(const std::string& text, char separator) {
    SplitRow row;
    for (std::size_t at = 0;; ++at) {
        const std::size_t begin = std::min(text.find_first_not_of(" \t", at), text.size());
        if (begin == text.size() || text[begin] != '"') {
            const std::size_t end = std::min(text.find(separator, at), text.size());
            row.fields.emplace_back(trimmed(std::string_view(text).substr(at, end - at)));
            at = end;
        } else {
            const std::size_t quote = closing_quote(text, begin + 1);
            row.fields.push_back(without_doubled_quotes(text.substr(begin + 1, quote - begin - 1)));
            if (quote == std::string::npos) {
                row.fault = quote_open;
                return row;
            }
            at = std::min(text.find_first_not_of(" \t", quote + 1), text.size());
            if (at < text.size() && text[at] != separator) {
                row.fault = VYBEG_MESSAGE("Words", "text follows its closing quotation mark");
                return row;
            }
        }
        if (at == text.size()) {
            return row;
        }
    }
}

bool has_name(const std::vector<std::string>& names, const std::string& name) {
    return std::ranges::find(names, name) != names.end();
}

class Reader {
public:
    Reader(std::shared_ptr<const FileBytes> file, std::string name, const UsualName& usual)
        : lines_(std::move(file)), usual_(usual), table_{std::move(name), {}, {}} {}

    Result<CsvRows> read(const std::string& needed) {
        TRY(read_names(needed));
        for (;;) {
            const auto more = TRY(next_row(separator_));
            if (!more) {
                return std::move(table_);
            }
            TRY(add_row());
        }
    }

    bool has(const std::string& name) {
        const auto names = names_with(name);
        return names && has_name(names->fields, name);
    }

private:
    Result<bool> append_line() {
        const Result<std::optional<std::string_view>> next = lines_.next();
        if (!next && next.error().code == ErrorCode::format_limit) {
            return table_.invalid(lines_.number() + 1, "1",
                                  Phrase::tr("the line is longer than 1 MiB"));
        }
        const auto found = TRY(next);
        text_ += found ? to_utf8(*found) : "";
        return found.has_value();
    }

    // Reads the text of the next row, which goes on in further lines until its quotes close for
    // `separator`; false at the end of the file.
    Result<bool> next_row(char separator) {
        text_.clear();
        const bool found = TRY(append_line());
        line_ = lines_.number();
        while (found && split_row(text_, separator).fault == quote_open) {
            text_ += '\n';
            const bool more = TRY(append_line());
            if (!more || text_.size() > longest_row) {
                break;  // with its open quote, which the caller finds
            }
        }
        return found;
    }

    // The row of names, by the separator that separates most of those where one is `needed`.
    Result<SplitRow> names_with(const std::string& needed) {
        // The separator follows from the names, which hold no line end in either case.
        for (bool before = true; before;) {
            const bool found = TRY(next_row(','));
            before = found && stands_before_names(text_);
        }
        SplitRow best;
        for (const char separator : {',', ';', '\t'}) {
            SplitRow names = split_row(text_, separator);
            for (std::string& name : names.fields) {
                name = usual_(name);
            }
            const bool has = has_name(names.fields, needed);
            const bool best_has = has_name(best.fields, needed);
            if (has == best_has ? names.fields.size() > best.fields.size() : has) {
                best = std::move(names);
                separator_ = separator;
            }
        }
        return best;
    }

    // An empty line, a line `sep=;` or a comment.
    static bool stands_before_names(const std::string& line) {
        const std::string_view text = trimmed(line);
        return text.empty() || text.starts_with('#') ||
               (text.starts_with("sep=") && text.size() <= 5);
    }

    Status read_names(const std::string& needed) {
        const auto names = TRY(names_with(needed));
        if (text_.find('\0') != std::string::npos) {
            return invalid(needed, Phrase::tr("the file holds no text"));
        }
        if (!has_name(names.fields, needed)) {
            constexpr std::size_t most_names = 12;  // in a message
            const std::string told =
                joined(std::span(names.fields).first(std::min(names.fields.size(), most_names)),
                       ", ") +
                (names.fields.size() > most_names ? ", ..." : "");
            return invalid(
                needed, told.empty()
                            ? Phrase::tr("the list needs this column")
                            : Phrase::tr("the list needs this column; its columns are %1", {told}));
        }
        for (const std::string& name : names.fields) {
            if (!name.empty() && std::ranges::count(names.fields, name) > 1) {
                return invalid(name, Phrase::tr("two columns have this name"));
            }
        }
        table_.names = names.fields;
        return checked(names);
    }

    Status add_row() {
        SplitRow row = split_row(text_, separator_);
        TRY(checked(row));
        const auto is_text = [](const std::string& field) { return !field.empty(); };
        if (std::ranges::none_of(row.fields, is_text)) {
            return {};
        }
        for (std::size_t k = 0; k < row.fields.size(); ++k) {
            if (row.fields[k].find('\0') != std::string::npos) {
                return invalid(column(k), Phrase::tr("it holds a zero byte"));
            }
            if (!row.fields[k].empty() && (k >= table_.names.size() || table_.names[k].empty())) {
                return invalid(column(k),
                               Phrase::tr("\"%1\" stands below no name", {row.fields[k]}));
            }
        }
        row.fields.resize(table_.names.size());
        table_.rows.push_back({line_, std::move(row.fields)});
        return {};
    }

    // No error but that of a quote.
    Status checked(const SplitRow& row) const {
        return row.fault ? Status(invalid(column(row.fields.size() - 1), words(row.fault)))
                         : Status();
    }

    // The name of a column, or its number.
    std::string column(std::size_t k) const {
        const bool named = k < table_.names.size() && !table_.names[k].empty();
        return named ? table_.names[k] : integer_text(static_cast<std::int64_t>(k) + 1);
    }

    Error invalid(const std::string& at, MessageArg reason) const {
        return table_.invalid(line_, at, std::move(reason));
    }

    TextLines lines_;
    std::string text_;       // of the row, which may span several lines
    std::int64_t line_ = 0;  // where it begins
    const UsualName& usual_;
    char separator_ = ',';
    CsvRows table_;
};

}  // namespace

bool CsvRows::has(const std::string& name) const {
    return has_name(names, name);
}

const std::string& CsvRows::field(const CsvRow& row, const std::string& name) const {
    static const std::string none;
    const auto found = std::ranges::find(names, name);
    return found == names.end() ? none
                                : row.fields[static_cast<std::size_t>(found - names.begin())];
}

Error CsvRows::invalid(std::int64_t line, const std::string& column, MessageArg reason) const {
    return {ErrorCode::list_invalid, file, {count_arg(line), column, std::move(reason)}};
}

std::vector<std::string> csv_fields(const std::string& row) {
    return split_row(row, ',').fields;
}

Result<CsvRows> read_csv(const std::filesystem::path& path, const std::string& needed,
                         const UsualName& usual) {
    auto file = TRY(FileBytes::open(path));
    const auto head = file->text(0, 4);
    if (head && (*head == "PK\3\4" || *head == "\xD0\xCF\x11\xE0")) {
        return Error{ErrorCode::list_invalid,
                     path.string(),
                     {"1", needed, Phrase::tr("it is a workbook; save the sheet as CSV")}};
    }
    return Reader(std::move(file), path.string(), usual).read(needed);
}

bool csv_has_name(const std::filesystem::path& path, const std::string& name,
                  const UsualName& usual) {
    auto file = FileBytes::open(path);
    return file && Reader(std::move(*file), path.string(), usual).has(name);
}

}  // namespace vybeg
