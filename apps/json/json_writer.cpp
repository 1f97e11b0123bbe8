#include "apps/json/json_writer.hpp"

#include <fmt/format.h>

#include <boost/locale/utf.hpp>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <iterator>
#include <system_error>

namespace swirl::apps {

namespace {

constexpr std::size_t piece_bytes = std::size_t{64} * 1024;
constexpr std::size_t indent = 2;

void append_escaped(std::string& out, char character) {
    switch (character) {
        case '"':
            out += "\\\"";
            return;
        case '\\':
            out += "\\\\";
            return;
        case '\n':
            out += "\\n";
            return;
        case '\t':
            out += "\\t";
            return;
        default:
            break;
    }
    if (static_cast<unsigned char>(character) < 0x20) {
        fmt::format_to(std::back_inserter(out), "\\u{:04x}", static_cast<unsigned>(character));
    } else {
        out += character;
    }
}

}  // namespace

void JsonWriter::separate(Level& level) {
    if (level.members++ > 0) buffer_ += level.layout == JsonLayout::rows ? "," : ", ";
    if (level.layout == JsonLayout::rows) new_line(levels_.size());
    if (buffer_.size() >= piece_bytes) write_out();
}

void JsonWriter::new_line(std::size_t depth) {
    buffer_ += '\n';
    buffer_.append(indent * depth, ' ');
}

void JsonWriter::before_value() {
    if (levels_.empty()) {
        if (has_root_) throw std::logic_error("JSON: a second value at the top");
        has_root_ = true;
    } else if (levels_.back().object) {
        if (!has_key_) throw std::logic_error("JSON: a member of an object without a key");
        has_key_ = false;
    } else {
        separate(levels_.back());
    }
}

void JsonWriter::key(std::string_view name) {
    if (levels_.empty() || !levels_.back().object || has_key_) throw std::logic_error("JSON: a key out of place");
    separate(levels_.back());
    quoted(name);
    buffer_ += ": ";
    has_key_ = true;
}

void JsonWriter::begin(bool object, JsonLayout layout) {
    before_value();
    buffer_ += object ? '{' : '[';
    levels_.push_back({object, layout});
}

void JsonWriter::end(bool object) {
    if (levels_.empty() || levels_.back().object != object || has_key_)
        throw std::logic_error("JSON: an end out of place");
    const Level level = levels_.back();
    levels_.pop_back();
    if (level.layout == JsonLayout::rows && level.members > 0) new_line(levels_.size());
    buffer_ += object ? '}' : ']';
}

void JsonWriter::value(double number) {
    if (!std::isfinite(number)) return null();
    before_value();
    // Without the point readers would take it for the integer 0, which has no sign.
    if (number == 0 && std::signbit(number)) {
        buffer_ += "-0.0";
    } else {
        char digits[32];  // the longest, -2.2250738585072014e-308, has 24
        const auto [end, error] = std::to_chars(digits, digits + sizeof digits, number);
        buffer_.append(digits, end);
    }
}

void JsonWriter::value(bool truth) {
    before_value();
    buffer_ += truth ? "true" : "false";
}

void JsonWriter::integer(std::int64_t number) {
    before_value();
    fmt::format_to(std::back_inserter(buffer_), "{}", number);
}

void JsonWriter::natural(std::uint64_t number) {
    before_value();
    fmt::format_to(std::back_inserter(buffer_), "{}", number);
}

void JsonWriter::value(std::string_view text) {
    before_value();
    quoted(text);
}

void JsonWriter::value(std::complex<double> number) {
    begin_array();
    value(number.real());
    value(number.imag());
    end_array();
}

void JsonWriter::null() {
    before_value();
    buffer_ += "null";
}

void JsonWriter::quoted(std::string_view text) {
    using Utf8 = boost::locale::utf::utf_traits<char>;
    buffer_ += '"';
    for (const char* position = text.begin(); position != text.end();) {
        const char* next = position;
        const auto point = Utf8::decode(next, text.end());
        if (!boost::locale::utf::is_valid_codepoint(point)) {
            buffer_ += "\xEF\xBF\xBD";
            ++position;  // a valid character may begin at the next byte
            continue;
        }
        if (point < 0x80) append_escaped(buffer_, *position);
        if (point >= 0x80) buffer_.append(position, next);
        position = next;
    }
    buffer_ += '"';
}

void JsonWriter::write_out() {
    if (take_) {
        take_(buffer_);
    } else if (text_ != nullptr) {
        *text_ += buffer_;
    } else if (std::fwrite(buffer_.data(), 1, buffer_.size(), file_) != buffer_.size()) {
        throw JsonError("cannot write JSON: " + std::generic_category().message(errno));
    }
    buffer_.clear();
}

void JsonWriter::finish() {
    if (!levels_.empty() || !has_root_) throw std::logic_error("JSON: the document is not complete");
    buffer_ += '\n';
    write_out();
    if (file_ != nullptr && (std::fflush(file_) != 0 || std::ferror(file_) != 0)) {
        throw JsonError("cannot write JSON: " + std::generic_category().message(errno));
    }
}

}  // namespace swirl::apps
