#pragma once

#include <complex>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace swirl::apps {

/// The document could not be written (a full disk, a closed pipe).
class JsonError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// How the members of an object or array are laid out: `rows` gives each its own line, `line` keeps them on one.
enum class JsonLayout { rows, line };

/// Writes one JSON document (RFC 8259) as it comes, without keeping it: memory O(nesting depth), so orbits of any
/// length stream through. Calls must follow the grammar: a key before every member of an object, none in an array, one
/// value at the top, everything closed at finish(); std::logic_error otherwise.
class JsonWriter {
public:
    /// `target` outlives the writer. To a file the text goes in pieces of 64 KiB.
    explicit JsonWriter(std::FILE* target) : file_(target) {}
    explicit JsonWriter(std::string& target) : text_(&target) {}
    /// `take` gets the text in such pieces, too.
    explicit JsonWriter(std::function<void(std::string_view)> take) : take_(std::move(take)) {}

    void begin_object(JsonLayout layout = JsonLayout::line) { begin(true, layout); }
    void end_object() { end(true); }
    void begin_array(JsonLayout layout = JsonLayout::line) { begin(false, layout); }
    void end_array() { end(false); }
    void key(std::string_view name);

    /// The shortest decimal that reads back to the same bits (-0.0 too); null when not finite.
    void value(double number);
    void value(bool truth);
    template <std::integral Integer>
    void value(Integer number) {
        if constexpr (std::signed_integral<Integer>) integer(static_cast<std::int64_t>(number));
        if constexpr (std::unsigned_integral<Integer>) natural(static_cast<std::uint64_t>(number));
    }
    /// UTF-8; what is not valid UTF-8 becomes U+FFFD.
    void value(std::string_view text);
    void value(const char* text) { value(std::string_view(text)); }
    /// [re, im]
    void value(std::complex<double> number);
    void null();

    template <class Value>
    void member(std::string_view name, const Value& content) {
        key(name);
        value(content);
    }

    /// An array of what value() takes.
    template <class Values>
    void array(const Values& contents, JsonLayout layout = JsonLayout::line) {
        begin_array(layout);
        for (const auto& content : contents) value(content);
        end_array();
    }
    template <class Values>
    void list(std::string_view name, const Values& contents, JsonLayout layout = JsonLayout::line) {
        key(name);
        array(contents, layout);
    }

    /// Ends the document with a newline and flushes it. JsonError if any of it could not be written; a long document
    /// throws that from the call that finds out.
    void finish();

private:
    struct Level {
        bool object;
        JsonLayout layout;
        std::size_t members = 0;
    };

    void begin(bool object, JsonLayout layout);
    void end(bool object);
    void integer(std::int64_t number);
    void natural(std::uint64_t number);
    void before_value();
    void separate(Level& level);
    void new_line(std::size_t depth);
    void quoted(std::string_view text);
    void write_out();

    std::FILE* file_ = nullptr;
    std::string* text_ = nullptr;
    std::function<void(std::string_view)> take_;
    std::string buffer_;
    std::vector<Level> levels_;
    bool has_key_ = false;
    bool has_root_ = false;
};

}  // namespace swirl::apps
