#include "config/document.hpp"

#include <matpoint/input_file.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <vector>

namespace matpoint {
namespace {

/// Reads a text and leaves word of how far it got, because nlohmann's SAX events carry no positions.
class CountingIterator {
  public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    CountingIterator(const char* at, const char** reached) : at_(at), reached_(reached) {}
    reference operator*() const { return *at_; }
    CountingIterator& operator++() {
        *reached_ = ++at_;
        return *this;
    }
    CountingIterator operator++(int) {
        const CountingIterator old = *this;
        ++*this;
        return old;
    }
    bool operator==(const CountingIterator& other) const { return at_ == other.at_; }

  private:
    const char* at_;
    const char** reached_;
};

/// Far more than any scene needs; pointers of values grow with their depth, and so does the stack of
/// whoever walks them.
constexpr std::size_t deepest_nesting = 256;

/// The same, in bytes.
constexpr std::uintmax_t largest_document = std::uintmax_t{256} << 20;

/// Builds the values and records where each starts.
class Reader final : public nlohmann::json_sax<Json> {
  public:
    Reader(std::string_view text, Document& document) : text_(text), document_(document) {
        if (text.substr(0, 3) == "\xEF\xBB\xBF") token_end_ = cursor_ = 3;
        reached_ = text.data();
    }

    bool read() {
        const char* end = text_.data() + text_.size();
        return Json::sax_parse(CountingIterator(text_.data(), &reached_), CountingIterator(end, &reached_),
                               this, Json::input_format_t::json, true, true);
    }

    bool null() override { return scalar(nullptr); }
    bool boolean(bool value) override { return scalar(value); }
    bool number_integer(Json::number_integer_t value) override { return scalar(value); }
    bool number_unsigned(Json::number_unsigned_t value) override { return scalar(value); }
    bool number_float(Json::number_float_t value, const std::string&) override { return scalar(value); }
    bool string(std::string& value) override { return scalar(std::move(value)); }
    bool binary(Json::binary_t&) override { return false; }
    bool start_object(std::size_t) override { return open(Json::object()); }
    bool start_array(std::size_t) override { return open(Json::array()); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool key(std::string& name) override {
        const Position position = start_of_token();
        pointer_ = join_pointer(levels_.back().pointer, name);
        if (const auto first = document_.positions.find(pointer_); first != document_.positions.end()) {
            document_.mistakes.add({.file = document_.path.string(),
                                    .line = position.line,
                                    .column = position.column,
                                    .pointer = pointer_,
                                    .message = fmt::format("given twice: on line {} and on line {}",
                                                           first->second.line, position.line)});
            document_.forget_positions(pointer_);
        }
        document_.positions[pointer_] = position;
        key_ = name;
        return true;
    }

    bool parse_error(std::size_t read, const std::string&, const Json::exception& exception) override {
        const std::size_t last = read > 0 ? read - 1 : 0;
        const Position position = position_of(std::min(skip_blanks(token_end_), last));
        // "[json.exception…] parse error at line 1, column 2: syntax error while parsing object - what is
        // wrong"
        std::string_view reason = exception.what();
        for (const std::string_view lead : {"] ", " - "}) {
            if (const auto found = reason.find(lead); found != reason.npos)
                reason.remove_prefix(found + lead.size());
        }
        const bool encoded = reason.find("UTF-8") == reason.npos;
        document_.mistakes.add({.file = document_.path.string(),
                                .line = position.line,
                                .column = position.column,
                                .message = fmt::format("not valid JSON: {}{}", reason,
                                                       encoded ? "" : "; save the file as UTF-8")});
        return false;
    }

  private:
    struct Level {
        Json* json;
        std::string pointer;
    };

    bool scalar(Json value) {
        place(std::move(value));
        return true;
    }
    bool open(Json container) {
        Json* placed = place(std::move(container));
        levels_.push_back({placed, pointer_});
        if (levels_.size() <= deepest_nesting) return true;
        const Position position = position_of(token_end_ - 1);
        document_.mistakes.add({.file = document_.path.string(),
                                .line = position.line,
                                .column = position.column,
                                .message = fmt::format("nested deeper than {} levels", deepest_nesting)});
        return false;
    }
    bool close() {
        token_end_ = offset();
        levels_.pop_back();
        return true;
    }

    /// Puts a value where it belongs; leaves its pointer in `pointer_`.
    Json* place(Json value) {
        const Position position = start_of_token(value.is_number());
        if (levels_.empty()) {
            pointer_.clear();
            document_.positions[pointer_] = position;
            document_.json = std::move(value);
            return &document_.json;
        }
        Json& parent = *levels_.back().json;
        if (parent.is_object()) {
            pointer_ = join_pointer(levels_.back().pointer, key_);
            return &(parent[key_] = std::move(value));
        }
        pointer_ = join_pointer(levels_.back().pointer, std::to_string(parent.size()));
        document_.positions[pointer_] = position;
        parent.push_back(std::move(value));
        return &parent.back();
    }

    /// Where the token that has just been read starts: after the one before it, blanks and separators.
    Position start_of_token(bool number = false) {
        const Position position = position_of(skip_blanks(token_end_));
        token_end_ = offset();
        // The lexer sees that a number has ended by the character after it.
        if (number && !std::isdigit(static_cast<unsigned char>(text_[token_end_ - 1]))) --token_end_;
        return position;
    }

    std::size_t offset() const { return static_cast<std::size_t>(reached_ - text_.data()); }

    std::size_t skip_blanks(std::size_t at) const {
        for (;;) {
            at = std::min(text_.find_first_not_of(" \t\r\n,:", at), text_.size());
            if (text_.substr(at, 2) == "//") {
                at = std::min(text_.find('\n', at), text_.size());
            } else if (text_.substr(at, 2) == "/*") {
                const std::size_t end = text_.find("*/", at + 2);
                at = end == text_.npos ? text_.size() : end + 2;
            } else {
                return at;
            }
        }
    }

    /// Offsets only grow, so lines are counted once. Continuation bytes of UTF-8 are no columns.
    Position position_of(std::size_t wanted) {
        for (; cursor_ < wanted; ++cursor_) {
            if (text_[cursor_] == '\n') {
                position_ = {position_.line + 1, 1};
            } else if ((static_cast<unsigned char>(text_[cursor_]) & 0xC0) != 0x80) {
                ++position_.column;
            }
        }
        return position_;
    }

    std::string_view text_;
    Document& document_;
    const char* reached_;
    std::size_t token_end_ = 0;
    std::size_t cursor_ = 0;
    Position position_{1, 1};
    std::vector<Level> levels_;
    std::string key_, pointer_;
};

}  // namespace

std::string join_pointer(const std::string& pointer, std::string_view key) {
    std::string joined = pointer + "/";
    for (const char c : key) {
        if (c == '~') {
            joined += "~0";
        } else if (c == '/') {
            joined += "~1";
        } else {
            joined += c;
        }
    }
    return joined;
}

Document parse_document(std::string_view text, std::filesystem::path path) {
    Document document;
    document.path = std::move(path);
    if (!Reader(text, document).read()) throw InputError(document.mistakes);
    return document;
}

Document read_document(const std::filesystem::path& file) {
    if (std::string why = why_unreadable(file, largest_document); !why.empty()) {
        Diagnostics diagnostics;
        diagnostics.add({.file = file.string(), .message = std::move(why)});
        throw InputError(diagnostics);
    }
    return parse_document(read_whole(file, largest_document), file);
}

void Document::forget_positions(const std::string& pointer) {
    std::erase_if(positions, [&](const auto& entry) {
        return entry.first == pointer || entry.first.starts_with(pointer + "/");
    });
}

Diagnostic Document::diagnostic(const std::string& pointer, std::string message, bool error) const {
    Diagnostic diagnostic{
        .error = error, .file = path.string(), .pointer = pointer, .message = std::move(message)};
    std::string around = pointer;
    for (;;) {
        if (overrides.contains(around)) {
            diagnostic.file = "--set " + around;
            return diagnostic;
        }
        if (const auto found = positions.find(around); found != positions.end()) {
            diagnostic.line = found->second.line;
            diagnostic.column = found->second.column;
            return diagnostic;
        }
        if (around.empty()) return diagnostic;
        around.erase(around.rfind('/'));
    }
}

}  // namespace matpoint
